//! Axes: round numbers, evenly or by their logarithms.

use plotters::coord::ranged1d::{KeyPointHint, NoDefaultFormatting, Ranged, ValueFormatter};
use std::ops::Range;

/// Numbers along an edge of a plot. Both kinds are one type, so that a plot of any two is one type.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Axis {
    /// From the first to the second.
    Linear(f64, f64),
    /// From the first to the second, both above 0.
    Logarithmic(f64, f64),
    /// So many rows, from the top down, the middle of each at a whole number from 0.
    Rows(usize),
}

impl Axis {
    /// From 0 to beyond all of these.
    pub(super) fn from_zero(values: impl Iterator<Item = f64>) -> Self {
        Self::Linear(0.0, values.fold(1.0, f64::max) * 1.08)
    }

    /// Around all of these, with some room at both ends.
    pub(super) fn around(values: impl Iterator<Item = f64>) -> Self {
        let known = values.filter(|value| value.is_finite() && *value > 0.0);
        let (least, most) = known.fold((f64::INFINITY, 0.0_f64), |(a, b), v| (a.min(v), b.max(v)));
        if most == 0.0 { Self::Logarithmic(1.0, 10.0) } else { Self::Logarithmic(least / 1.4, most * 1.4) }
    }

    /// Where this is, from 0 to 1.
    fn share(self, value: f64) -> f64 {
        match self {
            Self::Linear(least, most) => (value - least) / (most - least),
            // 0 has no place, and is drawn at the end: a clock that is too coarse tells such a time.
            Self::Logarithmic(least, most) => (value.max(least) / least).ln() / (most / least).ln(),
            Self::Rows(count) => (count as f64 - 0.5 - value) / count as f64,
        }
    }

    fn ticks(self) -> Vec<f64> {
        match self {
            Self::Linear(least, most) => {
                let step =
                    [1.0, 2.0, 5.0, 10.0, 20.0, 50.0, 100.0].into_iter().find(|step| most / step <= 9.0);
                let step = step.unwrap_or(most / 5.0);
                (0..10).map(|i| f64::from(i) * step).filter(|tick| (least..=most).contains(tick)).collect()
            }
            Self::Logarithmic(least, most) => {
                // Powers of ten alone are enough where there are many of them.
                let factors: &[f64] = if most / least > 3000.0 { &[1.0] } else { &[1.0, 2.0, 5.0] };
                let powers = least.log10().floor() as i32..=most.log10().ceil() as i32;
                let ticks = powers.flat_map(|power| factors.iter().map(move |f| f * 10_f64.powi(power)));
                ticks.filter(|tick| (least..=most).contains(tick)).collect()
            }
            Self::Rows(count) => (0..count).map(|row| row as f64).collect(),
        }
    }
}

impl Ranged for Axis {
    type FormatOption = NoDefaultFormatting;
    type ValueType = f64;

    fn map(&self, value: &f64, (from, to): (i32, i32)) -> i32 {
        from + (self.share(*value) * f64::from(to - from)).round() as i32
    }

    fn key_points<Hint: KeyPointHint>(&self, _: Hint) -> Vec<f64> {
        self.ticks()
    }

    fn range(&self) -> Range<f64> {
        match *self {
            Self::Linear(least, most) | Self::Logarithmic(least, most) => least..most,
            Self::Rows(count) => 0.0..count as f64,
        }
    }
}

impl ValueFormatter<f64> for Axis {
    fn format(value: &f64) -> String {
        match *value {
            v if v >= 1e6 => format!("{} M", round(v / 1e6)),
            v if v >= 1e3 => format!("{} k", round(v / 1e3)),
            v => round(v),
        }
    }
}

/// Without what multiplying by powers of ten leaves at the end.
fn round(value: f64) -> String {
    let text = format!("{value:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_in_range() {
        assert_eq!(Axis::around([3.0, 40.0].into_iter()).ticks(), [5.0, 10.0, 20.0, 50.0]);
        assert_eq!(Axis::from_zero([62.0].into_iter()).ticks(), [0.0, 10.0, 20.0, 30.0, 40.0, 50.0, 60.0]);
        assert_eq!(Axis::around(std::iter::empty()), Axis::Logarithmic(1.0, 10.0));
        let words = [0.1 + 0.2, 2_000.0, 5e6].map(|v| Axis::format(&v));
        assert_eq!(words, ["0.3", "2 k", "5 M"]);
    }

    #[test]
    fn values_map_to_pixels() {
        let log = Axis::Logarithmic(1.0, 100.0);
        assert_eq!([1.0, 10.0, 100.0].map(|v| log.map(&v, (0, 200))), [0, 100, 200]);
        assert_eq!([(20, 200), (200, 20)].map(|pixels| log.map(&0.0, pixels)), [20, 200]);
        // Upwards on a screen is towards smaller numbers; the first row is at the top all the same.
        assert_eq!([0.0, 1.0].map(|row| Axis::Rows(2).map(&row, (400, 0))), [100, 300]);
    }
}

//! Which heights contours are drawn at.

use crate::args;

/// Levels between two that are drawn thicker.
const INDEX: usize = 5;
/// The most levels where nobody says how many; round steps make from two fifths of it up.
const USUAL: f64 = 37.5;
/// More could hardly be told apart, and would be asked for by mistake only.
const MOST: f64 = 100_000.0;

/// A height at which there are lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Level {
    pub(crate) height: f32,
    /// Whether it is one of those that are drawn thicker, for the eye to count by.
    pub(crate) is_index: bool,
}

/// Levels, and the height from each to the next where that is the same for all.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Levels {
    /// Ascending, each once.
    pub(crate) all: Vec<Level>,
    pub(crate) step: Option<f64>,
}

impl Levels {
    /// The levels that are asked for, of a field with this range.
    ///
    /// # Errors
    /// A line, where they would be too many.
    pub(crate) fn of(options: &args::Contours, range: Option<[f32; 2]>) -> Result<Self, String> {
        match (range, options.levels, options.step) {
            _ if !options.at.is_empty() => Ok(Self::at(options.at.clone())),
            (None, ..) => Ok(Self::default()),
            (Some(range), Some(count), _) => Ok(Self::parts(count, range)),
            (Some([least, most]), None, Some(step)) => {
                if (f64::from(most) - f64::from(least)) / step > MOST {
                    return Err(format!(
                        "--step {step} makes more than {MOST} levels from {least} to {most}"
                    ));
                }
                Ok(Self::every(step, [least, most]))
            }
            (Some(range), None, None) => Ok(Self::usual(range)),
        }
    }

    /// The multiples of a round step.
    pub(crate) fn usual([least, most]: [f32; 2]) -> Self {
        let step = round_up((f64::from(most) - f64::from(least)) / USUAL);
        if step > 0.0 { Self::every(step, [least, most]) } else { Self::default() }
    }

    /// The multiples of `step`; each fifth multiple is an index. As `onering::contours::levels`, but with a step in 64
    /// bits: 20 times 0.05 is 1 then, and 3 times 0.1 the `f32` nearest to 0.3.
    fn every(step: f64, [least, most]: [f32; 2]) -> Self {
        let [first, last] = [(f64::from(least) / step).ceil(), (f64::from(most) / step).floor()];
        // Beyond 2^53 one more is the same number again.
        let multiples =
            (0..=MOST as u32).map(|i| first + f64::from(i)).take_while(|multiple| *multiple <= last);
        let level = |multiple: f64| Level {
            height: (multiple * step) as f32,
            is_index: multiple % INDEX as f64 == 0.0,
        };
        let mut all: Vec<Level> = multiples.map(level).collect();
        all.dedup_by_key(|level| level.height);
        Self { all, step: Some(step) }
    }

    /// `count` levels that cut the range into equal parts.
    fn parts(count: u32, [least, most]: [f32; 2]) -> Self {
        let [least, most] = [least, most].map(f64::from);
        let part = (most - least) / (f64::from(count) + 1.0);
        let mut all: Vec<Level> = (1..=count)
            .map(|i| Level {
                height: (least + f64::from(i) * part) as f32,
                is_index: (i as usize).is_multiple_of(INDEX),
            })
            .collect();
        all.dedup_by_key(|level| level.height);
        Self { all, step: Some(part) }
    }

    fn at(mut heights: Vec<f32>) -> Self {
        // -0 and 0 are one height.
        heights.iter_mut().for_each(|height| *height += 0.0);
        heights.sort_unstable_by(f32::total_cmp);
        heights.dedup();
        let level = |height| Level { height, is_index: false };
        Self { all: heights.into_iter().map(level).collect(), step: None }
    }

    /// Only the heights.
    pub(crate) fn heights(&self) -> Vec<f32> {
        self.all.iter().map(|level| level.height).collect()
    }
}

/// The least of 1, 2 and 5, times a power of ten, that is not less; 0 for what is not positive or not finite.
pub(crate) fn round_up(value: f64) -> f64 {
    if !(value > 0.0 && value.is_finite()) {
        return 0.0;
    }
    let power = 10f64.powf(value.log10().floor());
    // Logarithms are not exact, so that powers of ten on both sides are tried.
    let rounds = [0.5, 1.0, 2.0, 5.0, 10.0, 20.0].map(|digit| digit * power);
    rounds.into_iter().find(|round| *round >= value * (1.0 - 1e-9)).unwrap_or(value)
}

/// How many decimals are needed to tell multiples of this round step apart.
pub(crate) fn decimals(step: f64) -> usize {
    if step > 0.0 && step < 1.0 { (-step.log10() - 1e-9).ceil().min(12.0) as usize } else { 0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_are_round() {
        let rounds = [0.011, 0.1, 1.0, 1.2, 4.0, 7.0, 999.0, 1000.0].map(round_up);
        let expected = [0.02, 0.1, 1.0, 2.0, 5.0, 10.0, 1000.0, 1000.0];
        assert!(rounds.iter().zip(expected).all(|(a, b)| (a - b).abs() <= 1e-12 * b), "{rounds:?}");
        assert_eq!([0.0, -1.0, f64::NAN, f64::INFINITY].map(round_up), [0.0; 4]);
        assert_eq!([0.02, 0.5, 0.1, 1.0, 50.0, 0.0].map(decimals), [2, 1, 1, 0, 0, 0]);
    }

    #[test]
    fn usual_levels_are_some_and_each_fifth_multiple_is_an_index() {
        for (least, most) in [(0.0, 1.0), (-3.7, 12.1), (171.5, 415.6), (-1e-6, 1e-6), (1e30, 3e30)] {
            let levels = Levels::usual([least, most]);
            assert!((14..=38).contains(&levels.all.len()), "{levels:?}");
            assert!(levels.all.iter().all(|level| (least..=most).contains(&level.height)));
        }
        let levels = Levels::every(2.0, [-11.0, 21.0]);
        let index = |level: &&Level| level.is_index;
        assert!(levels.all.iter().filter(index).map(|level| level.height).eq([-10.0, 0.0, 10.0, 20.0]));
        assert_eq!(Levels::every(0.05, [0.0, 1.0]).heights()[18..], [0.9, 0.95, 1.0]);
        assert_eq!(Levels::every(0.02, [-0.401, -0.38]).heights(), [-0.4, -0.38]);
        assert_eq!(Levels::every(1e-9, [1e30, 1e30]).heights(), [1e30]);
        assert_eq!(Levels::usual([5.0, 5.0]), Levels::default());
    }

    #[test]
    fn parts_are_equal_and_given_levels_are_ordered() {
        assert_eq!(Levels::parts(3, [0.0, 8.0]).heights(), [2.0, 4.0, 6.0]);
        assert_eq!(Levels::parts(9, [1.0, 1.0]).heights(), [1.0]);
        assert_eq!(Levels::at(vec![3.0, -0.0, 1.0, 0.0, 3.0]).heights(), [0.0, 1.0, 3.0]);
    }
}

//! Numbers as people write them.

use crate::level::{decimals, round_up};

/// With as many decimals as a step of this size needs.
pub(super) fn text(value: f64, step: f64) -> String {
    if !(1e-6..1e7).contains(&step) && step > 0.0 {
        return format!("{value:.2e}");
    }
    let decimals = decimals(step);
    // A difference of two numbers may be a little below 0, which is not -0.
    let value = if value.abs() < 1e-6 * step { 0.0 } else { value };
    format!("{value:.decimals$}")
}

/// With three digits or a little more, and no zeros at the end.
pub(super) fn short(value: f64) -> String {
    let text = text(value, round_up(value.abs() / 200.0));
    if text.contains('.') && !text.contains('e') {
        return text.trim_end_matches('0').trim_end_matches('.').into();
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn decimals_are_those_of_the_step() {
        let texts = [(0.30000001, 0.1), (-1e-9, 0.5), (250.0, 50.0), (1e9, 1e9), (2e-7, 1e-7), (-0.25, 0.05)];
        let texts = texts.map(|(value, step)| text(value, step));
        assert_eq!(
            [0.05, 2.5, 4.784_926_4, 1234.567, -0.123_456_7].map(short),
            ["0.05", "2.5", "4.78", "1235", "-0.123"]
        );
        assert_eq!(texts, ["0.3", "0.0", "250", "1.00e9", "2.00e-7", "-0.25"]);
    }
}

//! Numbers to decimal text.

/// Appends the fewest digits that are read back as the same bits, such as `0.1`, `1.0` or `1e-12`; `inf`, `-inf`
/// and `NaN` for what has no digits.
#[inline]
pub(crate) fn f32_into(text: &mut Vec<u8>, value: f32) {
    // A third of the time that the standard library takes.
    text.extend_from_slice(zmij::Buffer::new().format(value).as_bytes());
}

/// Appends an integer.
#[inline]
pub(crate) fn u64_into(text: &mut Vec<u8>, value: u64) {
    text.extend_from_slice(itoa::Buffer::new().format(value).as_bytes());
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::number::f32_of;
    use proptest::prelude::*;

    fn text_of(value: f32) -> String {
        let mut text = Vec::new();
        f32_into(&mut text, value);
        String::from_utf8(text).unwrap()
    }

    /// How many digits a number has, without zeros at either end.
    fn digits(text: &str) -> usize {
        let digits: String = text.split('e').next().unwrap().chars().filter(char::is_ascii_digit).collect();
        digits.trim_matches('0').len()
    }

    #[test]
    fn whole_numbers_and_what_is_no_number() {
        let values = [1.0, -0.0, 0.1, 16777216.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN];
        assert_eq!(values.map(text_of), ["1.0", "-0.0", "0.1", "16777216.0", "inf", "-inf", "NaN"]);
        let mut text = b"f ".to_vec();
        u64_into(&mut text, 4294967296);
        assert_eq!(text, b"f 4294967296");
    }

    proptest! {
        #[test]
        fn digits_are_as_few_as_the_standard_librarys_and_read_back(bits: u32) {
            let value = f32::from_bits(bits);
            prop_assume!(value.is_finite());
            let text = text_of(value);
            prop_assert_eq!(f32_of(text.as_bytes()).map(f32::to_bits), Some(bits));
            prop_assert_eq!(text.parse::<f32>().map(f32::to_bits), Ok(bits));
            prop_assert_eq!(digits(&text), digits(&format!("{value:e}")));
        }
    }
}

//! Decimal text to `f32` and to indices.

/// The powers of ten that an `f64` holds exactly.
const POWERS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];

/// The `f32` nearest to the decimal number that the whole word spells; ties go to even. `inf`, `infinity`
/// and `nan` are numbers, in upper or lower case and with a sign; what is too large is infinite.
#[inline]
pub(crate) fn f32_of(word: &[u8]) -> Option<f32> {
    short_decimal(word).or_else(|| fast_float2::parse(word).ok())
}

/// Clinger's fast path, for the numbers that mesh files are made of: `-0.070713`, `12`, `1.5e-3`.
/// `None` where it cannot vouch for the last bit, or where the word is no number.
///
/// Up to 2^53 the digits are an exact `f64`, and so is the power of ten up to 10^22: one division or
/// multiplication gives the nearest `f64`. Rounding that to `f32` is right as well, unless it lies exactly
/// between two of them: the number itself may lie to either side. No result is below 10^-22, so none is a
/// subnormal `f32`, and between two is one bit pattern.
#[inline(always)]
fn short_decimal(word: &[u8]) -> Option<f32> {
    let (negative, digits) = split_sign(word);
    let (mantissa, exponent) = mantissa_and_exponent(digits)?;
    nearest(negative, mantissa, exponent)
}

/// The `f32` nearest to the mantissa times ten to the exponent, where one operation tells.
#[inline(always)]
fn nearest(negative: bool, mantissa: u64, exponent: i32) -> Option<f32> {
    const HALFWAY: u64 = 1 << 28;
    let power = POWERS.get(exponent.unsigned_abs() as usize)?;
    if mantissa > 1 << 53 {
        return None;
    }
    let wide = if exponent < 0 { mantissa as f64 / power } else { mantissa as f64 * power };
    if wide.to_bits() & (2 * HALFWAY - 1) == HALFWAY {
        return None;
    }
    Some(if negative { -wide as f32 } else { wide as f32 })
}

/// The decimal number that the bytes begin with, without exponent, and what follows it. `None` for whatever
/// needs a closer look at the whole word: [`f32_of`] gives the same for what this reads.
#[inline(always)]
pub(crate) fn f32_prefix(bytes: &[u8]) -> Option<(f32, &[u8])> {
    let (negative, digits) = split_sign(bytes);
    let (mut mantissa, whole, mut rest) = leading_digits(0, digits);
    let mut count = whole;
    let mut exponent = 0;
    if let [b'.', tail @ ..] = rest {
        let fraction;
        (mantissa, fraction, rest) = digits_by_eight(mantissa, tail)?;
        count += fraction;
        exponent = -(fraction as i32);
    }
    if count == 0 || count > 19 {
        return None;
    }
    Some((nearest(negative, mantissa, exponent)?, rest))
}

/// [`leading_digits`], eight at a time; `None` within eight bytes of the end.
#[inline(always)]
fn digits_by_eight(number: u64, bytes: &[u8]) -> Option<(u64, usize, &[u8])> {
    const TENS: [u64; 9] = [1, 10, 100, 1000, 10_000, 100_000, 1_000_000, 10_000_000, 100_000_000];
    let values = u64::from_le_bytes(*bytes.first_chunk()?) ^ (EACH * u64::from(b'0'));
    // Adding 0x76 sets the top bit of a byte from ten on; what is carried reaches bytes behind it only.
    let others = (values.wrapping_add(EACH * 0x76) | values) & (EACH * 0x80);
    let count = others.trailing_zeros() as usize / 8;
    let rest = &bytes[count..];
    if count == 8 {
        let (number, more, rest) =
            leading_digits(number.wrapping_mul(TENS[8]).wrapping_add(eight_digits(values)), rest);
        return Some((number, 8 + more, rest));
    }
    // Zeros in front, instead of what follows the digits.
    let values = values << (56 - 8 * count) << 8;
    Some((number.wrapping_mul(TENS[count]).wrapping_add(eight_digits(values)), count, rest))
}

/// A byte of one, eight times.
const EACH: u64 = 0x0101_0101_0101_0101;

/// The number of eight decimal digits, the first one in the lowest byte: neighbours are put together, to pairs,
/// fours and eight.
#[inline(always)]
fn eight_digits(values: u64) -> u64 {
    const LOW: u64 = 0x0000_00FF_0000_00FF;
    let pairs = values.wrapping_mul(10).wrapping_add(values >> 8);
    let upper = (pairs & LOW).wrapping_mul(100 + (1_000_000 << 32));
    let lower = (pairs >> 16 & LOW).wrapping_mul(1 + (10_000 << 32));
    upper.wrapping_add(lower) >> 32
}

/// `12.50e3` as 1250 and 1; `None` for more digits than a `u64` is sure to hold.
#[inline(always)]
fn mantissa_and_exponent(word: &[u8]) -> Option<(u64, i32)> {
    let (mut mantissa, whole, mut rest) = leading_digits(0, word);
    let mut count = whole;
    let mut exponent = 0;
    if let Some((b'.', tail)) = rest.split_first() {
        let fraction;
        (mantissa, fraction, rest) = leading_digits(mantissa, tail);
        count += fraction;
        exponent = -(fraction as i32);
    }
    if let Some((b'e' | b'E', tail)) = rest.split_first() {
        exponent += small_exponent(tail)?;
        rest = &[];
    }
    (rest.is_empty() && 0 < count && count <= 19).then_some((mantissa, exponent))
}

/// Appends the digits that the word begins with to a number: the number, how many there were, and what
/// follows. The number wraps around beyond 19 digits.
#[inline(always)]
fn leading_digits(mut number: u64, word: &[u8]) -> (u64, usize, &[u8]) {
    let mut count = 0;
    while let Some(digit) = word.get(count).map(|byte| byte.wrapping_sub(b'0')).filter(|digit| *digit < 10) {
        number = number.wrapping_mul(10).wrapping_add(u64::from(digit));
        count += 1;
    }
    (number, count, &word[count..])
}

fn small_exponent(word: &[u8]) -> Option<i32> {
    let (negative, digits) = split_sign(word);
    let (value, count, rest) = leading_digits(0, digits);
    let value = (rest.is_empty() && 0 < count && count <= 4).then_some(value as i32)?;
    Some(if negative { -value } else { value })
}

#[inline(always)]
fn split_sign(word: &[u8]) -> (bool, &[u8]) {
    match word {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        _ => (false, word),
    }
}

/// [`index_prefix`] for up to 19 digits; `None` within eight bytes of the end.
#[inline(always)]
pub(crate) fn short_index_prefix(bytes: &[u8]) -> Option<(bool, u64, &[u8])> {
    let (negative, digits) = split_sign(bytes);
    let (value, count, rest) = digits_by_eight(0, digits)?;
    (0 < count && count <= 19).then_some((negative, value, rest))
}

/// An index as written: its sign and its size, `u64::MAX` for anything beyond 19 digits. With it comes
/// what follows the digits. `None` if the word does not begin with an integer.
#[inline(always)]
pub(crate) fn index_prefix(word: &[u8]) -> Option<(bool, u64, &[u8])> {
    let (negative, digits) = split_sign(word);
    let (value, count, rest) = leading_digits(0, digits);
    (count > 0).then_some((negative, if count <= 19 { value } else { u64::MAX }, rest))
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The standard library's reader of `f32` is correctly rounded too, and shares no code with ours.
    fn expected(text: &str) -> u32 {
        text.parse::<f32>().unwrap().to_bits()
    }

    fn got(text: &str) -> Option<u32> {
        f32_of(text.as_bytes()).map(f32::to_bits)
    }

    #[test]
    fn numbers_round_once() {
        for text in [
            "0",
            "-0",
            "-0.0",
            "+1.5",
            ".5",
            "5.",
            "1e5",
            "1E+5",
            "1e-5",
            "16777217",
            "16777219.0",
            // Halfway between two f32, and a hair to either side: two roundings would go wrong.
            "1.00000017881393432617187499",
            "1.00000017881393432617187500",
            "1.00000017881393432617187501",
            "1.000000178813934326171875",
            "9007199791611905",
            "9007199254740993",
            "3.4028235e38",
            "3.4028236e38",
            "1e39",
            "-1e39",
            "1e-45",
            "7e-46",
            "1e-300",
            "1e400",
            "00000000000000000000000001.5",
            "123456789012345678901234567890",
        ] {
            assert_eq!(got(text), Some(expected(text)), "{text}");
        }
    }

    #[test]
    fn infinity_and_nan_are_numbers() {
        assert_eq!(f32_of(b"-Inf"), Some(f32::NEG_INFINITY));
        assert_eq!(f32_of(b"infinity"), Some(f32::INFINITY));
        assert!(f32_of(b"-nan").unwrap().is_nan());
    }

    #[test]
    fn other_words_are_not() {
        for word in ["", "-", ".", "e5", "1e", "1e+", "1x", "1..2", "--1", "1,5", "0x10", "1_0", "1.-"] {
            assert_eq!(got(word), None, "{word}");
        }
    }

    #[test]
    fn indices_saturate() {
        assert_eq!(index_prefix(b"-12/3"), Some((true, 12, &b"/3"[..])));
        assert_eq!(index_prefix(b"99999999999999999999"), Some((false, u64::MAX, &b""[..])));
        assert_eq!(index_prefix(b"x"), None);
        assert_eq!(index_prefix(b"-"), None);
    }

    proptest! {
        #[test]
        fn decimals_agree_with_the_standard_library(text in r"[-+]?[0-9]{1,12}(\.[0-9]{0,12})?([eE][-+]?[0-9]{1,2})?") {
            prop_assert_eq!(got(&text), Some(expected(&text)));
        }

        // Written out in full, the point between two neighbouring f32 is the hardest input there is.
        #[test]
        fn halfway_points_agree(bits in 0x2000_0000u32..0x5F00_0000) {
            let [low, high] = [bits, bits + 1].map(|bits| f64::from(f32::from_bits(bits)));
            let text = format!("{:.60}", (low + high) / 2.0);
            let (text, hair) = (text.trim_end_matches('0'), format!("{text}1"));
            prop_assert_eq!(got(text), Some(expected(text)));
            prop_assert_eq!(got(&hair), Some(expected(&hair)));
        }

        #[test]
        fn any_bytes_are_read_without_panic(word: Vec<u8>) {
            let _ = (f32_of(&word), index_prefix(&word));
        }
    }
}

//! Colours for attributes: sRGB, 8 bits a channel, told apart by colour-blind eyes as well.
//!
//! - Flags: vermilion where set, light grey elsewhere (of the palette of Okabe and Ito, 2008).
//! - Labels: hues that follow the golden ratio round the circle of OKLCH (Ottosson, 2020), in four lightnesses by
//!   turns. Label l has the same colour in every mesh, and the same as l + 256. Seen as in Machado, Oliveira and
//!   Fernandes (2009), the first eight keep apart for protanopes, deuteranopes and tritanopes.
//! - Scalars: viridis (Smith and van der Walt, 2015), from the least to the largest finite value; grey where there
//!   is no number, an end of the scale where it is infinite.

use crate::Values;

const SET: Rgb = [213, 94, 0];
const UNSET: Rgb = [204, 204, 204];
const NO_NUMBER: Rgb = [128, 128, 128];

/// Viridis at 33 places, an equal step apart. Between them a straight line is within 2 of 255 of the full table.
const VIRIDIS: [u32; 33] = [
    0x440154, 0x470D60, 0x48186A, 0x482374, 0x472D7B, 0x453681, 0x424086, 0x3F4989, 0x3B528B, 0x375A8D,
    0x33638D, 0x2F6A8E, 0x2C728E, 0x297A8E, 0x26818E, 0x23898E, 0x21908C, 0x1F988B, 0x1F9F88, 0x21A685,
    0x28AE80, 0x31B57B, 0x3EBC74, 0x4CC26C, 0x5DC963, 0x6ECE58, 0x82D34C, 0x96D83F, 0xABDC32, 0xC0DF24,
    0xD5E21A, 0xEAE51A, 0xFDE725,
];

/// Red, green and blue in sRGB.
pub type Rgb = [u8; 3];

/// The colours of one attribute.
pub(crate) enum Colours<'a> {
    Flags(&'a [bool]),
    Labels(&'a [u32], Box<[Rgb; 256]>),
    Scalars { values: &'a [f32], least: f64, range: f64 },
}

impl<'a> Colours<'a> {
    /// Linear in the number of values.
    pub(crate) fn of(values: Values<'a>) -> Self {
        match values {
            Values::Flags(flags) => Self::Flags(flags),
            Values::Labels(labels) => Self::Labels(labels, palette()),
            Values::Scalars(values) => {
                let finite = || values.iter().copied().filter(|value| value.is_finite()).map(f64::from);
                let least = finite().fold(f64::INFINITY, f64::min);
                Self::Scalars { values, least, range: finite().fold(f64::NEG_INFINITY, f64::max) - least }
            }
        }
    }

    /// The colour of the i-th value.
    #[inline]
    pub(crate) fn at(&self, i: usize) -> Rgb {
        match self {
            Self::Flags(flags) => [UNSET, SET][usize::from(flags[i])],
            Self::Labels(labels, palette) => palette[labels[i] as usize % palette.len()],
            Self::Scalars { values, least, range } => on_scale(f64::from(values[i]), *least, *range),
        }
    }
}

fn on_scale(value: f64, least: f64, range: f64) -> Rgb {
    if value.is_nan() {
        return NO_NUMBER;
    }
    // Infinite values, and the only value of a constant field, are on no scale.
    let share = match (value - least) / range {
        share if share.is_finite() => share,
        _ if value == f64::INFINITY => 1.0,
        _ => 0.0,
    };
    viridis(share)
}

/// The colour of the scale viridis (Smith and van der Walt, 2015) at a share of its length, in sRGB: dark violet at 0,
/// yellow at 1. Shares outside are as the nearer end, NaN as 0.
///
/// ```
/// assert_eq!([-1.0, 0.5, 1.0].map(onering_io::colour::viridis), [[68, 1, 84], [33, 144, 140], [253, 231, 37]]);
/// assert_eq!(onering_io::colour::viridis(f64::NAN), [68, 1, 84]);
/// ```
pub fn viridis(share: f64) -> Rgb {
    let share = if share > 0.0 { share.min(1.0) } else { 0.0 };
    let place = share * (VIRIDIS.len() - 1) as f64;
    let below = place as usize;
    let [from, to] = [below, (below + 1).min(VIRIDIS.len() - 1)].map(|i| VIRIDIS[i].to_be_bytes());
    std::array::from_fn(|c| {
        let [from, to] = [from, to].map(|colour| f64::from(colour[c + 1]));
        (from + (to - from) * (place - below as f64)).round() as u8
    })
}

fn palette() -> Box<[Rgb; 256]> {
    Box::new(std::array::from_fn(|label| label_colour(label as u32)))
}

fn label_colour(label: u32) -> Rgb {
    // Where the hues begin and the order of the lightnesses: the best of a search for the least distance between
    // any two of the first eight, for all eyes.
    const FIRST_HUE: u32 = 0x70A3_D70A;
    const GOLDEN: u32 = 0x9E37_79B9;
    const LIGHTNESS: [f64; 4] = [0.87, 0.57, 0.72, 0.42];
    let turns = f64::from(label.wrapping_mul(GOLDEN).wrapping_add(FIRST_HUE)) / 2f64.powi(32);
    let (sin, cos) = (turns * std::f64::consts::TAU).sin_cos();
    let mut chroma = 0.16;
    loop {
        let linear = linear_of_oklab([LIGHTNESS[label as usize % 4], chroma * cos, chroma * sin]);
        // Paler until a screen can show it. Greys are in reach, so this ends.
        if chroma < 0.01 || linear.iter().all(|channel| (0.0..=1.0).contains(channel)) {
            return linear.map(|channel| (srgb_of_linear(channel.clamp(0.0, 1.0)) * 255.0).round() as u8);
        }
        chroma *= 0.95;
    }
}

/// The matrices of Ottosson's OKLab.
fn linear_of_oklab([l, a, b]: [f64; 3]) -> [f64; 3] {
    let [long, medium, short] = [
        l + 0.396_337_777_4 * a + 0.215_803_757_3 * b,
        l - 0.105_561_345_8 * a - 0.063_854_172_8 * b,
        l - 0.089_484_177_5 * a - 1.291_485_548_0 * b,
    ]
    .map(|root: f64| root.powi(3));
    [
        4.076_741_662_1 * long - 3.307_711_591_3 * medium + 0.230_969_929_2 * short,
        -1.268_438_004_6 * long + 2.609_757_401_1 * medium - 0.341_319_396_5 * short,
        -0.004_196_086_3 * long - 0.703_418_614_7 * medium + 1.707_614_701_0 * short,
    ]
}

/// The transfer function of sRGB (IEC 61966-2-1), both in 0 to 1.
pub fn srgb_of_linear(linear: f64) -> f64 {
    if linear <= 0.003_130_8 { linear * 12.92 } else { 1.055 * linear.powf(1.0 / 2.4) - 0.055 }
}

/// Linear light for each 8-bit value of sRGB. In 16 bits: in 8 the darkest 13 would be two.
pub fn linear_table() -> [u16; 256] {
    std::array::from_fn(|value| {
        let srgb = value as f64 / 255.0;
        let linear = if srgb <= 0.040_45 { srgb / 12.92 } else { ((srgb + 0.055) / 1.055).powf(2.4) };
        (linear * f64::from(u16::MAX)).round() as u16
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scalars_span_the_scale_and_no_number_is_grey() {
        let values = [-1.0, 3.0, 1.0, f32::NAN, f32::INFINITY, f32::NEG_INFINITY];
        let colours = Colours::of(Values::Scalars(&values));
        let (bottom, top) = ([0x44, 0x01, 0x54], [0xFD, 0xE7, 0x25]);
        let expected = [bottom, top, [0x21, 0x90, 0x8C], NO_NUMBER, top, bottom];
        assert_eq!((0..6).map(|i| colours.at(i)).collect::<Vec<_>>(), expected);
    }

    #[test]
    fn fields_without_a_range_have_colours() {
        let at = |values: &[f32]| Colours::of(Values::Scalars(values)).at(0);
        assert_eq!(at(&[7.0, 7.0]), [0x44, 0x01, 0x54]);
        assert_eq!(at(&[f32::NAN]), NO_NUMBER);
        assert_eq!(at(&[f32::INFINITY]), [0xFD, 0xE7, 0x25]);
        assert_eq!(at(&[f32::MAX, f32::MIN]), [0xFD, 0xE7, 0x25]);
        assert_eq!(at(&[f32::from_bits(1), 0.0]), [0xFD, 0xE7, 0x25]);
    }

    #[test]
    fn linear_light_gives_back_every_value_of_srgb() {
        let table = linear_table();
        assert_eq!((table[0], table[255]), (0, u16::MAX));
        for (value, linear) in table.iter().enumerate() {
            let back = srgb_of_linear(f64::from(*linear) / f64::from(u16::MAX)) * 255.0;
            assert_eq!(back.round() as usize, value);
        }
    }

    #[test]
    fn labels_have_colours_of_their_own() {
        let mut first = palette()[..32].to_vec();
        first.sort_unstable();
        assert!(first.windows(2).all(|two| two[0] != two[1]));
        let labels = [3, 256 + 3];
        let colours = Colours::of(Values::Labels(&labels));
        assert_eq!(colours.at(0), colours.at(1));
    }

    type Matrix = [[f64; 3]; 3];

    const ALL_CONES: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// Machado, Oliveira and Fernandes, severity 1.
    const PROTANOPE: Matrix =
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]];
    const DEUTERANOPE: Matrix =
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.011820, 0.042940, 0.968881]];
    const TRITANOPE: Matrix =
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.303900]];

    fn times(matrix: &Matrix, vector: [f64; 3]) -> [f64; 3] {
        matrix.map(|row| row.iter().zip(vector).map(|(a, b)| a * b).sum())
    }

    /// OKLab of what the eye makes of the colour.
    fn seen(eye: &Matrix, colour: Rgb) -> [f64; 3] {
        let table = linear_table();
        let linear = colour.map(|channel| f64::from(table[usize::from(channel)]) / f64::from(u16::MAX));
        let cones = times(
            &[
                [0.4122214708, 0.5363325363, 0.0514459929],
                [0.2119034982, 0.6806995451, 0.1073969566],
                [0.0883024619, 0.2817188376, 0.6299787005],
            ],
            times(eye, linear).map(|channel| channel.clamp(0.0, 1.0)),
        );
        times(
            &[
                [0.2104542553, 0.7936177850, -0.0040720468],
                [1.9779984951, -2.4285922050, 0.4505937099],
                [0.0259040371, 0.7827717662, -0.8086757660],
            ],
            cones.map(f64::cbrt),
        )
    }

    fn distance(eye: &Matrix, two: [Rgb; 2]) -> f64 {
        let [a, b] = two.map(|colour| seen(eye, colour));
        a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    }

    #[test]
    fn colour_blind_eyes_tell_the_first_labels_and_flags_apart() {
        let palette = palette();
        for eye in [ALL_CONES, PROTANOPE, DEUTERANOPE, TRITANOPE] {
            assert!(distance(&eye, [SET, UNSET]) > 0.15);
            for (a, b) in (0..8).flat_map(|a| (0..a).map(move |b| (a, b))) {
                // Two hundredths are a difference that is just seen.
                assert!(distance(&eye, [palette[a], palette[b]]) > 0.09, "labels {a} and {b}");
            }
        }
    }
}

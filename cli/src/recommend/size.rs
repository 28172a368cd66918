//! Amounts of memory, as people write them.

use std::fmt;
use std::str::FromStr;

/// So many bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Size(pub(crate) u64);

/// Powers of 1000 and of 1024, by the letters that follow the number.
const UNITS: [(&str, u64); 9] = [
    ("", 1),
    ("k", 1_000),
    ("m", 1_000_000),
    ("g", 1_000_000_000),
    ("t", 1_000_000_000_000),
    ("ki", 1 << 10),
    ("mi", 1 << 20),
    ("gi", 1 << 30),
    ("ti", 1 << 40),
];

impl FromStr for Size {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        const WRONG: &str = "not an amount of memory such as 500M, 1.5G or 64MiB";
        let end = text.find(|c: char| !c.is_ascii_digit() && c != '.').unwrap_or(text.len());
        let (number, unit) = text.split_at(end);
        let unit = unit.trim_start().to_ascii_lowercase();
        let unit = unit.strip_suffix('b').unwrap_or(&unit);
        let (_, bytes) = UNITS.iter().find(|(name, _)| *name == unit).ok_or(WRONG)?;
        let number: f64 = number.parse().map_err(|_| WRONG)?;
        let total = number * *bytes as f64;
        if total < 1.0 {
            return Err("it is no memory at all");
        }
        // As f64 that is 2^64, the first number that is too large.
        if total < u64::MAX as f64 { Ok(Self(total as u64)) } else { Err("no machine has so much memory") }
    }
}

impl fmt::Display for Size {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let bytes = self.0 as f64;
        match self.0 {
            0..1_000 => write!(f, "{} B", self.0),
            1_000..1_000_000 => write!(f, "{:.1} kB", bytes / 1e3),
            1_000_000..1_000_000_000 => write!(f, "{:.1} MB", bytes / 1e6),
            _ => write!(f, "{:.2} GB", bytes / 1e9),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_are_powers_of_1000_or_of_1024() {
        let bytes = |text: &str| text.parse::<Size>().unwrap().0;
        assert_eq!(
            ["7", "7B", "500M", "500 mb", "1.5G", "2KiB", "1Gi"].map(bytes),
            [7, 7, 500_000_000, 500_000_000, 1_500_000_000, 2048, 1 << 30]
        );
        for text in [
            "",
            "M",
            "-5M",
            "5X",
            "1.2.3",
            "nan",
            "inf",
            "0",
            "0.1",
            "5 M 3",
            "5iB",
            "16777216Ti",
            &"9".repeat(400),
        ] {
            assert!(text.parse::<Size>().is_err(), "{text}");
        }
        assert_eq!("16777215Ti".parse(), Ok(Size(u64::MAX - (1 << 40) + 1)));
        assert_eq!(
            [999, 1_500, 2_000_000, 3_210_000_000].map(|b| Size(b).to_string()),
            ["999 B", "1.5 kB", "2.0 MB", "3.21 GB"]
        );
    }
}

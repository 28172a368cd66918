//! The two ways in which PLY has numbers.

use crate::decimal::{f32_into, u64_into};

/// Appends numbers to a row. Nothing can fail: the bytes are in memory.
pub(super) trait Encoding {
    /// As the header names it.
    const NAME: &'static str;

    fn float(row: &mut Vec<u8>, value: f32);
    fn uchar(row: &mut Vec<u8>, value: u8);
    /// For `int` as well: the caller sees to it that the sign bit is clear.
    fn uint(row: &mut Vec<u8>, value: u32);
    fn end(row: &mut Vec<u8>);
}

/// Little endian, without anything between.
pub(super) struct Binary;

impl Encoding for Binary {
    const NAME: &'static str = "binary_little_endian";

    #[inline(always)]
    fn float(row: &mut Vec<u8>, value: f32) {
        row.extend_from_slice(&value.to_le_bytes());
    }

    #[inline(always)]
    fn uchar(row: &mut Vec<u8>, value: u8) {
        row.push(value);
    }

    #[inline(always)]
    fn uint(row: &mut Vec<u8>, value: u32) {
        row.extend_from_slice(&value.to_le_bytes());
    }

    #[inline(always)]
    fn end(_: &mut Vec<u8>) {}
}

/// Words with a space between, a row on each line.
pub(super) struct Ascii;

impl Encoding for Ascii {
    const NAME: &'static str = "ascii";

    fn float(row: &mut Vec<u8>, value: f32) {
        f32_into(row, value);
        row.push(b' ');
    }

    fn uchar(row: &mut Vec<u8>, value: u8) {
        Self::uint(row, value.into());
    }

    fn uint(row: &mut Vec<u8>, value: u32) {
        u64_into(row, value.into());
        row.push(b' ');
    }

    fn end(row: &mut Vec<u8>) {
        // The space after the last word; a row has a word.
        if let Some(last) = row.last_mut() {
            *last = b'\n';
        }
    }
}

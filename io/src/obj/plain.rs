//! Vertices and faces the way nearly every program writes them, read byte by byte instead of word by word.
//! Whatever is not quite plain is `None`, and left to the reader that knows all of OBJ.

use crate::number::{f32_prefix, short_index_prefix};

/// Faces of more corners are not plain.
const CORNERS: usize = 8;

/// The corners of a face.
pub(super) struct Corners {
    list: [u32; CORNERS],
    count: usize,
    pub(super) highest: u32,
}

impl Corners {
    pub(super) fn list(&self) -> &[u32] {
        &self.list[..self.count]
    }
}

/// Three coordinates behind the keyword, and what follows them: more words, or the end of the line.
#[inline(always)]
pub(super) fn position(line: &[u8]) -> Option<([f32; 3], &[u8])> {
    let (x, rest) = f32_prefix(skip_blanks(line))?;
    let (y, rest) = f32_prefix(skip_blanks(behind_word(rest)?))?;
    let (z, rest) = f32_prefix(skip_blanks(behind_word(rest)?))?;
    Some(([x, y, z], behind_word(rest)?))
}

/// The corners behind the keyword, three or more and each below `limit`, and what follows them: the end of the
/// line. Negative ones are counted back from `vertices`, the number of those so far.
#[inline(always)]
pub(super) fn corners(line: &[u8], vertices: Option<usize>, limit: u32) -> Option<(Corners, &[u8])> {
    let mut corners = Corners { list: [0; CORNERS], count: 0, highest: 0 };
    let mut rest = skip_blanks(line);
    loop {
        let (negative, index, tail) = short_index_prefix(rest)?;
        let corner = if negative { (vertices? as u64).checked_sub(index) } else { index.checked_sub(1) };
        let corner = corner.filter(|corner| *corner < u64::from(limit) && index > 0)? as u32;
        *corners.list.get_mut(corners.count)? = corner;
        corners.count += 1;
        corners.highest = corners.highest.max(corner);
        rest = skip_blanks(behind_word(behind_tail(tail))?);
        if let [b'\n' | b'\r', ..] = rest {
            return (corners.count >= 3).then_some((corners, rest));
        }
    }
}

/// Steps over `/2/3`, `//3`, `/2`, `/`.
#[inline(always)]
fn behind_tail(mut rest: &[u8]) -> &[u8] {
    if let [b'/', ..] = rest {
        while let [b'/' | b'-' | b'+' | b'0'..=b'9', tail @ ..] = rest {
            rest = tail;
        }
    }
    rest
}

/// The same bytes, if a word ends before them.
#[inline(always)]
fn behind_word(rest: &[u8]) -> Option<&[u8]> {
    matches!(rest, [b' ' | b'\t' | b'\n' | b'\r', ..]).then_some(rest)
}

#[inline(always)]
fn skip_blanks(mut rest: &[u8]) -> &[u8] {
    while let [b' ' | b'\t', tail @ ..] = rest {
        rest = tail;
    }
    rest
}

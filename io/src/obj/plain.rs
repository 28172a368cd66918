//! Vertices and faces the way nearly every program writes them, read byte by byte instead of word by word.
//! Whatever is not quite plain is `None`, and left to the reader that knows all of OBJ.

use super::Reader;
use super::numbering::Numbering;
use crate::Error;
use crate::memory::push;
use crate::number::{f32_prefix, short_index_prefix};
use crate::text::Scanner;

/// Faces of more corners are not plain.
const CORNERS: usize = 8;

impl Reader {
    /// Reads a line that is as plain as most; `false`, with nothing read, if it is not.
    #[inline(always)]
    pub(super) fn plain_line(&mut self, scanner: &mut Scanner<'_>) -> Result<bool, Error> {
        let rest = match scanner.remainder() {
            [b'v', b' ', line @ ..] => {
                let Some((position, rest)) = position(line) else { return Ok(false) };
                push(&mut self.positions, position)?;
                rest
            }
            [b'f', b' ', line @ ..] => {
                let corners = corners(line, self.numbering.after(self.positions.len()));
                let Some((corners, rest)) = corners else { return Ok(false) };
                self.corner_bound = self.corner_bound.max(corners.bound);
                let mut polygon = self.polygons.open();
                for corner in corners.list() {
                    self.polygons.corner(&mut polygon, *corner)?;
                }
                self.polygons.close(polygon)?;
                rest
            }
            [b'v', b'n' | b't', b' ', rest @ ..] => rest,
            _ => return Ok(false),
        };
        self.statements += 1;
        scanner.go_on_with(rest);
        Ok(true)
    }
}

/// The corners of a face.
struct Corners {
    list: [u32; CORNERS],
    count: usize,
    /// One more than the highest that is not counted back.
    bound: u32,
}

impl Corners {
    fn list(&self) -> &[u32] {
        &self.list[..self.count]
    }
}

/// Three coordinates behind the keyword, and what follows them: more words, or the end of the line.
#[inline(always)]
fn position(line: &[u8]) -> Option<([f32; 3], &[u8])> {
    let (x, rest) = f32_prefix(skip_blanks(line))?;
    let (y, rest) = f32_prefix(skip_blanks(behind_word(rest)?))?;
    let (z, rest) = f32_prefix(skip_blanks(behind_word(rest)?))?;
    Some(([x, y, z], behind_word(rest)?))
}

/// The corners behind the keyword, three or more, and what follows them: the end of the line.
#[inline(always)]
fn corners(line: &[u8], numbering: Numbering) -> Option<(Corners, &[u8])> {
    let mut corners = Corners { list: [0; CORNERS], count: 0, bound: 0 };
    let mut rest = skip_blanks(line);
    loop {
        let (negative, index, tail) = short_index_prefix(rest)?;
        let corner = if negative { numbering.back(index)? } else { numbering.absolute(index)? };
        if !negative {
            corners.bound = corners.bound.max(corner + 1);
        }
        *corners.list.get_mut(corners.count)? = corner;
        corners.count += 1;
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

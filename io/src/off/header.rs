//! The keyword and the counts of an OFF file.

use super::keyword::Keyword;
use super::malformed;
use crate::error::quote;
use crate::number::index_prefix;
use crate::words::Words;
use crate::{Error, Item, Place, Reason};

#[derive(Debug)]
pub(super) struct Header<'a> {
    pub(super) keyword: Keyword,
    pub(super) vertices: usize,
    pub(super) faces: u64,
    /// What follows the line of the counts.
    pub(super) lines: Words<'a>,
    /// What follows the counts.
    pub(super) stream: Words<'a>,
    /// The first word behind the third count on its line, and the line: either data or a fault.
    pub(super) stray: Option<(&'a [u8], Place)>,
}

/// Bytes of the shortest face, `0` and a line end.
const SHORTEST_FACE: u64 = 2;

impl<'a> Header<'a> {
    /// What follows the keyword in a file of `length` bytes; it is long enough for what the header declares.
    pub(super) fn read(keyword: Keyword, mut words: Words<'a>, length: usize) -> Result<Self, Error> {
        let first = words.next();
        let line = Place::Line(words.line());
        let [vertices, faces] = [count(first, line)?, count(words.next_on_line(), line)?];
        words.next_on_line();
        let stream = words.clone();
        let stray = words.next_on_line().map(|word| (word, line));
        words.end_line();
        // `0 0 0` and a line end.
        let shortest_vertex = 2 * keyword.components() as u64;
        let [needed, more] = [(vertices, shortest_vertex), (faces, SHORTEST_FACE)]
            .map(|(count, shortest)| shortest.saturating_mul(count));
        // The last line may lack its end.
        let (needed, available) = (needed.saturating_add(more), (length - stream.at()) as u64);
        if needed > available + 1 {
            let reason = Reason::TooShort {
                item: Item::File,
                needed: needed.saturating_add(stream.at() as u64),
                available: length as u64,
            };
            return Err(malformed(line, reason));
        }
        if vertices > u64::from(u32::MAX) {
            return Err(malformed(line, Reason::TooMany));
        }
        Ok(Self { keyword, vertices: vertices as usize, faces, lines: words, stream, stray })
    }
}

pub(super) fn count(word: Option<&[u8]>, line: Place) -> Result<u64, Error> {
    let missing =
        Reason::NotThisFormat { expected: "an OFF file: the counts of vertices and faces are missing" };
    let word = word.ok_or_else(|| malformed(line, missing))?;
    match index_prefix(word) {
        Some((false, count, [])) => Ok(count),
        _ => Err(malformed(line, Reason::BadWord { word: quote(word), expected: "a count" })),
    }
}

//! The keyword and the counts of an OFF file.

use super::malformed;
use crate::error::quote;
use crate::number::index_prefix;
use crate::words::Words;
use crate::{Error, Format, Item, Place, Reason};

#[derive(Debug)]
pub(super) struct Header {
    /// Whether vertices are announced to be nothing but coordinates.
    pub(super) is_plain: bool,
    pub(super) vertices: usize,
    pub(super) faces: u64,
}

/// Bytes of the shortest vertex, `0 0 0` and a line end, and of the shortest face, `0` and a line end.
const SHORTEST: [u64; 2] = [6, 2];

impl Header {
    /// The header of a file of `length` bytes; it is long enough for what the header declares.
    pub(super) fn read(words: &mut Words<'_>, length: usize) -> Result<Self, Error> {
        let mut word = words.next();
        let keyword = word.and_then(Keyword::of);
        if let Some(keyword) = &keyword {
            let place = Place::Line(words.line());
            word = words.next_on_line();
            if let Some(variant) = keyword.unsupported(word) {
                return Err(Error::Unsupported {
                    format: Format::Off,
                    path: None,
                    place,
                    feature: variant.into(),
                });
            }
            word = word.or_else(|| words.next());
        }
        let line = Place::Line(words.line());
        let counts = [count(word, line)?, count(words.next_on_line(), line)?];
        words.end_line();
        let [vertices, faces] = counts;
        let [needed, more] = [0, 1].map(|i| SHORTEST[i].saturating_mul(counts[i]));
        // The last line may lack its end.
        let (needed, available) = (needed.saturating_add(more), (length - words.at()) as u64);
        if needed > available + 1 {
            let reason = Reason::TooShort {
                item: Item::File,
                needed: needed.saturating_add(words.at() as u64),
                available: length as u64,
            };
            return Err(malformed(line, reason));
        }
        if vertices > u64::from(u32::MAX) {
            return Err(malformed(line, Reason::TooMany));
        }
        Ok(Self {
            is_plain: keyword.is_none_or(|keyword| keyword.is_plain()),
            vertices: vertices as usize,
            faces,
        })
    }
}

fn count(word: Option<&[u8]>, line: Place) -> Result<u64, Error> {
    let missing =
        Reason::NotThisFormat { expected: "an OFF file: the counts of vertices and faces are missing" };
    let word = word.ok_or_else(|| malformed(line, missing))?;
    match index_prefix(word) {
        Some((false, count, [])) => Ok(count),
        _ => Err(malformed(line, Reason::BadWord { word: quote(word), expected: "a count" })),
    }
}

/// `[ST][C][N][4][n]OFF`, the prefixes in any order and each at most once.
struct Keyword<'a> {
    prefixes: &'a [u8],
}

impl<'a> Keyword<'a> {
    fn of(word: &'a [u8]) -> Option<Self> {
        let prefixes = word.strip_suffix(b"OFF")?;
        let mut rest = prefixes;
        let mut seen = Vec::new();
        while !rest.is_empty() {
            let prefix =
                [&b"ST"[..], b"C", b"N", b"4", b"n"].into_iter().find(|prefix| rest.starts_with(prefix))?;
            if seen.contains(&prefix) {
                return None;
            }
            seen.push(prefix);
            rest = &rest[prefix.len()..];
        }
        Some(Self { prefixes })
    }

    fn is_plain(&self) -> bool {
        self.prefixes.is_empty()
    }

    /// The variant that is not read, if it is one; `next` is the next word of the line.
    fn unsupported(&self, next: Option<&[u8]>) -> Option<&'static str> {
        if next == Some(b"BINARY") {
            return Some("OFF BINARY");
        }
        let has = |prefix| self.prefixes.contains(&prefix);
        match (has(b'4'), has(b'n')) {
            (true, _) => Some("4OFF (homogeneous coordinates)"),
            (_, true) => Some("nOFF (any number of dimensions)"),
            _ => None,
        }
    }
}

/// Whether the first word outside comments is an OFF keyword.
pub(crate) fn begins_with_keyword(bytes: &[u8]) -> bool {
    Words::new(bytes, Some(b'#')).next().and_then(Keyword::of).is_some()
}

//! The text of a field that holds numbers.

use std::ops::Range;

use super::Scene;
use crate::{Error, Reason};

/// Where the numbers of a field are; nowhere by default.
#[derive(Debug, Default)]
pub(crate) struct Field {
    /// Its bytes in the file.
    range: Range<usize>,
    /// What they stand for, where they are no plain text: character references were resolved.
    decoded: Option<Vec<u8>>,
}

/// The numbers of a field, word by word: blanks and commas part them.
pub(super) struct Numbers<'a> {
    scene: &'a Scene<'a>,
    field: &'a Field,
    text: &'a [u8],
    class: &'static [u8; 256],
    at: usize,
}

const WORD: u8 = 0;
const BLANK: u8 = 1;
const COMMENT: u8 = 2;

/// What each byte is: one load instead of six comparisons, for every byte of a file.
const PLAIN: [u8; 256] = {
    let mut class = [WORD; 256];
    class[b' ' as usize] = BLANK;
    class[b',' as usize] = BLANK;
    let mut byte = b'\t';
    while byte <= b'\r' {
        class[byte as usize] = BLANK;
        byte += 1;
    }
    class
};

/// The same where a `#` hides the rest of its line.
const WITH_COMMENTS: [u8; 256] = {
    let mut class = PLAIN;
    class[b'#' as usize] = COMMENT;
    class
};

impl Field {
    pub(crate) fn new(range: Range<usize>) -> Self {
        Self { range, decoded: None }
    }

    pub(crate) fn decoded(range: Range<usize>, text: Vec<u8>) -> Self {
        Self { range, decoded: Some(text) }
    }

    pub(super) fn numbers<'a>(&'a self, scene: &'a Scene<'a>) -> Numbers<'a> {
        let text = self.decoded.as_deref().unwrap_or(&scene.bytes[self.range.clone()]);
        let class = if scene.has_comments { &WITH_COMMENTS } else { &PLAIN };
        Numbers { scene, field: self, text, class, at: 0 }
    }
}

impl<'a> Numbers<'a> {
    /// The next word.
    #[inline(always)]
    pub(super) fn next(&mut self) -> Option<&'a [u8]> {
        let mut start = self.at;
        loop {
            match self.class[usize::from(*self.text.get(start)?)] {
                WORD => break,
                COMMENT => start += end_of_line(&self.text[start..]),
                _ => start += 1,
            }
        }
        let mut end = start + 1;
        while self.text.get(end).is_some_and(|byte| self.class[usize::from(*byte)] == WORD) {
            end += 1;
        }
        self.at = end;
        Some(&self.text[start..end])
    }

    /// Byte of the file behind the word read last. In decoded text that is not known: then where the field begins.
    pub(super) fn at(&self) -> usize {
        match self.field.decoded {
            Some(_) => self.field.range.start,
            None => self.field.range.start + self.at,
        }
    }

    #[cold]
    pub(super) fn malformed(&self, reason: Reason) -> Error {
        self.scene.malformed(self.at(), reason)
    }
}

#[cold]
fn end_of_line(text: &[u8]) -> usize {
    memchr::memchr2(b'\n', b'\r', text).unwrap_or(text.len())
}

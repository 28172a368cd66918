//! The text of a field that holds numbers.

use std::ops::Range;

use super::Scene;
use crate::words::Words;
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
    words: Words<'a>,
    /// Byte of the text behind the word read last.
    behind: usize,
}

impl Field {
    pub(crate) fn new(range: Range<usize>) -> Self {
        Self { range, decoded: None }
    }

    pub(crate) fn decoded(range: Range<usize>, text: Vec<u8>) -> Self {
        Self { range, decoded: Some(text) }
    }

    pub(super) fn numbers<'a>(&'a self, scene: &'a Scene<'a>) -> Numbers<'a> {
        let words = match &self.decoded {
            Some(text) => Words::new(text, scene.comment),
            None => Words::new(&scene.bytes[..self.range.end], scene.comment).from_byte(self.range.start),
        };
        Numbers { scene, field: self, behind: words.at(), words: words.with_commas() }
    }
}

impl<'a> Numbers<'a> {
    #[inline(always)]
    pub(super) fn next(&mut self) -> Option<&'a [u8]> {
        let word = self.words.next()?;
        self.behind = self.words.at();
        Some(word)
    }

    /// Byte of the file behind the word read last. In decoded text that is not known: then where the field begins.
    pub(super) fn at(&self) -> usize {
        match self.field.decoded {
            Some(_) => self.field.range.start,
            None => self.behind,
        }
    }

    #[cold]
    pub(super) fn malformed(&self, reason: Reason) -> Error {
        self.scene.malformed(self.at(), reason)
    }
}

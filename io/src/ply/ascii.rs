//! Values as words.

use super::element::Element;
use super::malformed;
use super::scalar::{Integer, Scalar};
use super::source::Source;
use crate::error::quote;
use crate::number::{f32_of, index_prefix};
use crate::words::Words;
use crate::{Error, Item, Place, Reason};

#[derive(Clone)]
pub(super) struct Ascii<'a> {
    bytes: &'a [u8],
    words: Words<'a>,
    last: &'a [u8],
}

impl<'a> Ascii<'a> {
    pub(super) fn new(bytes: &'a [u8], end: usize) -> Self {
        Self { bytes, words: Words::new(bytes, None).starting_at(end), last: b"" }
    }

    #[inline(always)]
    fn word(&mut self, item: Item) -> Result<&'a [u8], Error> {
        match self.words.next() {
            Some(word) => {
                self.last = word;
                Ok(word)
            }
            None => Err(malformed(self.place(item), Reason::Ends { item })),
        }
    }

    #[inline(always)]
    fn integer(&mut self, item: Item, expected: &'static str) -> Result<i64, Error> {
        match index_prefix(self.word(item)?) {
            Some((negative, size, b"")) => {
                let size = i64::try_from(size).unwrap_or(i64::MAX);
                Ok(if negative { -size } else { size })
            }
            _ => Err(self.bad(item, expected)),
        }
    }

    #[cold]
    fn bad(&mut self, item: Item, expected: &'static str) -> Error {
        malformed(self.place(item), Reason::BadWord { word: quote(self.last), expected })
    }
}

impl Source for Ascii<'_> {
    #[inline(always)]
    fn coordinate(&mut self, _: Scalar, item: Item) -> Result<f32, Error> {
        match f32_of(self.word(item)?) {
            Some(number) => Ok(number),
            None => Err(malformed(self.place(item), Reason::BadNumber { word: quote(self.last) })),
        }
    }

    #[inline(always)]
    fn index(&mut self, _: Integer, item: Item) -> Result<i64, Error> {
        self.integer(item, "a vertex index")
    }

    #[inline(always)]
    fn length(&mut self, _: Integer, _: Scalar, item: Item) -> Result<usize, Error> {
        const EXPECTED: &str = "the length of a list";
        let length = self.integer(item, EXPECTED)?;
        usize::try_from(length).map_err(|_| self.bad(item, EXPECTED))
    }

    #[inline(always)]
    fn skip(&mut self, _: Scalar, item: Item) -> Result<(), Error> {
        self.word(item).map(drop)
    }

    #[inline(always)]
    fn skip_all(&mut self, count: usize, kind: Scalar, item: Item) -> Result<(), Error> {
        (0..count).try_for_each(|_| self.skip(kind, item))
    }

    fn spelled(&self, _: i64) -> String {
        quote(self.last)
    }

    fn place(&mut self, _: Item) -> Place {
        Place::Line(self.words.line())
    }

    /// Each value is a digit at least, and a blank but for the last one.
    fn most_rows(&self, element: &Element<'_>) -> usize {
        let values = (self.bytes.len() - self.words.at()).div_ceil(2);
        values.checked_div(element.properties.len()).unwrap_or(0)
    }

    fn rest(&mut self) -> (usize, Place) {
        let mut rest = self.words.clone();
        let bytes = rest.next().map_or(0, |word| self.bytes[rest.at() - word.len()..].trim_ascii_end().len());
        (bytes, Place::Line(rest.line()))
    }
}

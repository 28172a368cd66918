//! The attributes of an element that matter to a mesh.

use std::borrow::Cow;

use quick_xml::escape::{EscapeError, unescape};
use quick_xml::events::attributes::{AttrError, Attributes as Pairs};

use super::xml_error;
use crate::error::quote;
use crate::memory::reserve;
use crate::scene::{Field, Name};
use crate::{Error, Reason};

/// What is wrong with an attribute: its byte in the file, and why.
pub(super) enum Fault {
    At(usize, Reason),
    Other(Error),
}

/// Values as they stand in the file.
#[derive(Default)]
pub(super) struct Attributes<'a> {
    pub(super) def: Option<Value<'a>>,
    pub(super) used: Option<Value<'a>>,
    pub(super) point: Option<Value<'a>>,
    pub(super) coord_index: Option<Value<'a>>,
    pub(super) index: Option<Value<'a>>,
    pub(super) ccw: Option<Value<'a>>,
}

/// The text of a value, and its first byte in the file.
#[derive(Clone, Copy)]
pub(super) struct Value<'a> {
    text: &'a str,
    pub(super) at: usize,
}

impl<'a> Attributes<'a> {
    /// Reads a tag, without its brackets, that begins at byte `at`; its name has `name` bytes. All attributes are
    /// checked, wanted or not.
    pub(super) fn of(tag: &'a str, name: usize, at: usize) -> Result<Self, Fault> {
        let mut found = Self::default();
        for pair in Pairs::new(tag, name) {
            let pair = pair.map_err(|error| Fault::At(at + offset_of(&error), xml_error(&error)))?;
            let Cow::Borrowed(text) = pair.value else { continue };
            let value = Value { text, at: at + (text.as_ptr() as usize - tag.as_ptr() as usize) };
            value.check()?;
            match pair.key.0 {
                "DEF" => found.def = value.if_any(),
                "USE" => found.used = value.if_any(),
                "point" => found.point = Some(value),
                "coordIndex" => found.coord_index = Some(value),
                "index" => found.index = Some(value),
                "ccw" => found.ccw = Some(value),
                _ => {}
            }
        }
        Ok(found)
    }
}

impl<'a> Value<'a> {
    fn if_any(self) -> Option<Self> {
        (!self.text.is_empty()).then_some(self)
    }

    pub(super) fn name(self) -> Result<Name<'a>, Fault> {
        Ok(self.decoded()?.map_or(Cow::Borrowed(self.text.as_bytes()), Cow::Owned))
    }

    pub(super) fn field(self) -> Result<Field, Fault> {
        let range = self.at..self.at + self.text.len();
        Ok(match self.decoded()? {
            None => Field::new(range),
            Some(text) => Field::decoded(range, text),
        })
    }

    pub(super) fn is_false(self) -> bool {
        self.text.trim().eq_ignore_ascii_case("false")
    }

    /// Refuses what no value may hold: unknown references, and `<`, which shows that a quotation mark is missing.
    fn check(self) -> Result<(), Fault> {
        if let Some(offset) = memchr::memchr(b'<', self.text.as_bytes()) {
            let message = "`<` in the value of an attribute".to_owned();
            return Err(Fault::At(self.at + offset, Reason::Xml { message }));
        }
        self.each_piece(|_| {})
    }

    /// The text with its references resolved; `None` where it has none.
    fn decoded(self) -> Result<Option<Vec<u8>>, Fault> {
        if memchr::memchr(b'&', self.text.as_bytes()).is_none() {
            return Ok(None);
        }
        let mut out = Vec::new();
        // What a reference stands for is never longer than it.
        reserve(&mut out, self.text.len()).map_err(Fault::Other)?;
        self.each_piece(|piece| out.extend_from_slice(piece.as_bytes()))?;
        Ok(Some(out))
    }

    /// Hands over plain text and what references stand for, piece by piece.
    fn each_piece(self, mut take: impl FnMut(&str)) -> Result<(), Fault> {
        let mut rest = self.text;
        while let Some(start) = memchr::memchr(b'&', rest.as_bytes()) {
            let at = self.at + (self.text.len() - rest.len()) + start;
            take(&rest[..start]);
            let length = memchr::memchr(b';', &rest.as_bytes()[start..]);
            let end = start + length.map_or(0, |length| length + 1);
            let reference = unescape(&rest[start..end]);
            let fault = |error: EscapeError| Fault::At(at, unknown_reference(&rest[start..], &error));
            match reference {
                Ok(character) if start < end => take(&character),
                Ok(_) => return Err(fault(EscapeError::UnterminatedEntity(start..rest.len()))),
                Err(error) => return Err(fault(error)),
            }
            rest = &rest[end..];
        }
        take(rest);
        Ok(())
    }
}

/// What is wrong with the reference that a text begins with.
pub(super) fn unknown_reference(text: &str, error: &EscapeError) -> Reason {
    let end = text.find(';').map_or(text.len(), |end| end + 1);
    let reference = quote(&text.as_bytes()[..end]);
    let problem = match error {
        EscapeError::UnterminatedEntity(_) => "has no `;`",
        EscapeError::UnrecognizedEntity(..) => "is no entity of XML's own",
        _ => "is no character",
    };
    Reason::Xml { message: format!("`{reference}` {problem}") }
}

/// Bytes from the beginning of a tag to the fault.
fn offset_of(error: &AttrError) -> usize {
    match error {
        AttrError::ExpectedEq(at)
        | AttrError::ExpectedValue(at)
        | AttrError::UnquotedValue(at)
        | AttrError::ExpectedQuote(at, _)
        | AttrError::Duplicated(at, _) => *at,
    }
}

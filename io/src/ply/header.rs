//! The header: which elements follow, in which encoding, and where.

use std::collections::HashSet;

use super::element::{Element, Kind, Property};
use super::malformed;
use super::role::Role;
use super::scalar::{Integer, Scalar};
use crate::error::quote;
use crate::memory::push;
use crate::number::index_prefix;
use crate::triangles::skip;
use crate::words::Words;
use crate::{Error, Note, Place, Reason, Skipped};

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Ascii,
    LittleEndian,
    BigEndian,
}

#[derive(Debug)]
pub(super) struct Header<'a> {
    pub(super) encoding: Encoding,
    pub(super) elements: Vec<Element<'a>>,
    /// How many vertices are declared.
    pub(super) vertices: u32,
    pub(super) notes: Vec<Note>,
    /// The first byte behind it.
    pub(super) end: usize,
}

impl<'a> Header<'a> {
    pub(super) fn parse(bytes: &'a [u8]) -> Result<Self, Error> {
        let mut parser = Parser::new(bytes);
        parser.mark()?;
        while parser.line()? {}
        parser.finish()
    }
}

struct Parser<'a> {
    bytes: &'a [u8],
    words: Words<'a>,
    encoding: Option<Encoding>,
    elements: Vec<Element<'a>>,
    element_names: HashSet<&'a [u8]>,
    /// Those of the last element.
    property_names: HashSet<&'a [u8]>,
    notes: Vec<Note>,
    /// Whether lines end with CR alone.
    cr: bool,
}

impl<'a> Parser<'a> {
    fn new(bytes: &'a [u8]) -> Self {
        Self {
            bytes,
            words: Words::new(bytes, None),
            encoding: None,
            elements: Vec::new(),
            element_names: HashSet::new(),
            property_names: HashSet::new(),
            notes: Vec::new(),
            cr: false,
        }
    }

    /// The first line.
    fn mark(&mut self) -> Result<(), Error> {
        if self.words.next() != Some(b"ply") || self.words.next_on_line().is_some() {
            return Err(
                self.error(Reason::NotThisFormat { expected: "a PLY file: it does not begin with `ply`" })
            );
        }
        let rest = &self.bytes[self.words.at()..];
        self.cr = rest.starts_with(b"\r") && !rest.starts_with(b"\r\n");
        Ok(())
    }

    /// One line that is not empty; `false` behind the last one.
    fn line(&mut self) -> Result<bool, Error> {
        let keyword = self.words.next().ok_or_else(|| self.declaration(b"end_header", "is missing"))?;
        match keyword {
            b"format" => self.format()?,
            b"element" => self.element()?,
            b"property" => self.property()?,
            b"comment" | b"obj_info" => {}
            b"end_header" => return Ok(false),
            _ => {
                let line = self.place();
                skip(&mut self.notes, Skipped::UnknownStatements, 1, line);
            }
        }
        self.words.end_line();
        Ok(true)
    }

    fn format(&mut self) -> Result<(), Error> {
        let word = self.word(b"format")?;
        let encoding = match word {
            b"ascii" => Encoding::Ascii,
            b"binary_little_endian" => Encoding::LittleEndian,
            b"binary_big_endian" => Encoding::BigEndian,
            _ => return Err(self.bad(word, "`ascii`, `binary_little_endian` or `binary_big_endian`")),
        };
        match self.encoding.replace(encoding) {
            None => Ok(()),
            Some(_) => Err(self.declaration(b"format", "is declared twice")),
        }
    }

    fn element(&mut self) -> Result<(), Error> {
        let name = self.word(b"element")?;
        let word = self.word(b"element")?;
        let count = match index_prefix(word) {
            Some((false, count, b"")) => usize::try_from(count).unwrap_or(usize::MAX),
            _ => return Err(self.bad(word, "a count")),
        };
        if !self.element_names.insert(name) {
            return Err(self.declaration(name, "is declared twice"));
        }
        self.property_names.clear();
        let (index, line) = (self.elements.len(), self.place());
        push(
            &mut self.elements,
            Element { name, count, properties: Vec::new(), role: Role::Other, index, line },
        )
    }

    fn property(&mut self) -> Result<(), Error> {
        let kind = match self.word(b"property")? {
            b"list" => Kind::List { length: self.length()?, item: self.scalar()? },
            name => Kind::Scalar(self.scalar_of(name)?),
        };
        let name = self.word(b"property")?;
        if self.elements.is_empty() {
            return Err(self.declaration(name, "belongs to no element"));
        }
        if !self.property_names.insert(name) {
            return Err(self.declaration(name, "is declared twice"));
        }
        self.elements
            .last_mut()
            .map_or(Ok(()), |element| push(&mut element.properties, Property { name, kind }))
    }

    fn length(&mut self) -> Result<Integer, Error> {
        let word = self.word(b"property")?;
        let integer = self.scalar_of(word)?.integer();
        integer.ok_or_else(|| self.bad(word, "an integer type, as the length of a list needs"))
    }

    fn scalar(&mut self) -> Result<Scalar, Error> {
        let name = self.word(b"property")?;
        self.scalar_of(name)
    }

    fn scalar_of(&mut self, name: &[u8]) -> Result<Scalar, Error> {
        Scalar::of_name(name).ok_or_else(|| self.bad(name, "a scalar type"))
    }

    /// The next word of the line that begins with `keyword`.
    fn word(&mut self, keyword: &[u8]) -> Result<&'a [u8], Error> {
        self.words.next_on_line().ok_or_else(|| self.declaration(keyword, "lacks a word"))
    }

    fn finish(mut self) -> Result<Header<'a>, Error> {
        let end = self.end()?;
        let encoding = self.encoding.ok_or_else(|| self.declaration(b"format", "is missing"))?;
        let mut vertices = 0;
        for element in &mut self.elements {
            element.role = Role::of(element)?;
            if let Role::Vertices(_) = element.role {
                vertices =
                    u32::try_from(element.count).map_err(|_| malformed(element.line, Reason::TooMany))?;
            }
        }
        Ok(Header { encoding, elements: self.elements, vertices, notes: self.notes, end })
    }

    /// The first byte behind the line of `end_header`.
    fn end(&mut self) -> Result<usize, Error> {
        let at = self.words.at();
        let rest = &self.bytes[at..];
        let blanks = rest.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
        let length = match rest[blanks..] {
            [b'\r', b'\n', ..] if !self.cr => 2,
            [b'\r' | b'\n', ..] => 1,
            [] => 0,
            _ => return Err(self.declaration(b"end_header", "is followed by something on its line")),
        };
        Ok(at + blanks + length)
    }

    fn place(&mut self) -> Place {
        Place::Line(self.words.line())
    }

    fn bad(&mut self, word: &[u8], expected: &'static str) -> Error {
        self.error(Reason::BadWord { word: quote(word), expected })
    }

    fn declaration(&mut self, name: &[u8], problem: &'static str) -> Error {
        self.error(Reason::Declaration { name: quote(name), problem })
    }

    fn error(&mut self, reason: Reason) -> Error {
        malformed(self.place(), reason)
    }
}

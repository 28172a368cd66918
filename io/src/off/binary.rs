//! The binary variant of OFF.

use super::keyword::{Keyword, check_dimension};
use super::malformed;
use super::reader::divided;
use crate::error::quote;
use crate::memory::{push, reserve};
use crate::polygons::Polygons;
use crate::triangles::skip;
use crate::{Error, Item, Note, Place, Reason, Skipped, Triangles};

/// Bytes of a number: integers and floats alike, the most significant one first.
const NUMBER: usize = 4;
/// Bytes of the shortest face: no corners, no colour.
const SHORTEST_FACE: u64 = 2 * NUMBER as u64;

/// Reads what follows the word `BINARY`, which ends before byte `at`.
pub(super) fn read(bytes: &[u8], at: usize, keyword: Keyword) -> Result<Triangles, Error> {
    let mut reader = Reader {
        bytes,
        at: end_of_line(bytes, at)?,
        positions: Vec::new(),
        polygons: Polygons::default(),
        notes: Vec::new(),
    };
    if keyword.dimension_follows {
        let place = Place::Byte(reader.at);
        check_dimension(reader.count(Item::Header)?, place)?;
    }
    let counts_at = reader.at;
    let [vertices, faces] = [reader.count(Item::Header)?, reader.count(Item::Header)?];
    // The number of edges, which may be any.
    reader.integer(Item::Header)?;
    let stride = NUMBER * keyword.numbers();
    let needed = vertices * stride as u64 + faces * SHORTEST_FACE;
    reader.check_rest(needed, Item::File, counts_at)?;
    reader.vertices(vertices as usize, stride, keyword)?;
    (0..faces).try_for_each(|face| reader.face(Item::Face(face as usize)))?;
    reader.finish()
}

/// The byte behind the line end that has to follow.
fn end_of_line(bytes: &[u8], at: usize) -> Result<usize, Error> {
    let rest = &bytes[at..];
    let blanks = rest.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
    match &rest[blanks..] {
        [b'\n', ..] => Ok(at + blanks + 1),
        [b'\r', b'\n', ..] => Ok(at + blanks + 2),
        other => {
            let word = quote(&other[..other.len().min(1)]);
            let expected = "the line end that has to follow `BINARY`";
            Err(malformed(Place::Byte(at + blanks), Reason::BadWord { word, expected }))
        }
    }
}

struct Reader<'a> {
    bytes: &'a [u8],
    at: usize,
    positions: Vec<[f32; 3]>,
    polygons: Polygons,
    notes: Vec<Note>,
}

impl<'a> Reader<'a> {
    fn vertices(&mut self, count: usize, stride: usize, keyword: Keyword) -> Result<(), Error> {
        reserve(&mut self.positions, count)?;
        let numbers = self.take(count * stride);
        self.positions.extend(numbers.chunks_exact(stride).map(|vertex| match keyword.weight() {
            None => [0, 1, 2].map(|axis| float(vertex, axis)),
            Some(weight) => divided([0, 1, 2, 3].map(|i| f64::from(float(vertex, i))), weight),
        }));
        Ok(())
    }

    fn face(&mut self, item: Item) -> Result<(), Error> {
        let start = self.at;
        let size = self.count(item)?;
        self.check_rest(size * NUMBER as u64, item, start)?;
        let mut polygon = self.polygons.open();
        for _ in 0..size {
            let corner = self.corner(size, item)?;
            self.polygons.corner(&mut polygon, corner)?;
        }
        if size < 3 {
            skip(&mut self.notes, Skipped::ShortFaces, 1, Place::Byte(start));
        } else {
            self.polygons.close(polygon)?;
        }
        self.colour(item)
    }

    /// The vertex that a corner names. Faces that are skipped may name any.
    #[inline(always)]
    fn corner(&mut self, size: u64, item: Item) -> Result<u32, Error> {
        let (at, vertices) = (self.at, self.positions.len());
        let index = self.integer(item)?;
        if size >= 3 && usize::try_from(index).map_or(true, |index| index >= vertices) {
            let reason = Reason::IndexOutOfRange { index: index.to_string(), vertices };
            return Err(malformed(Place::ByteIn { item, byte: at }, reason));
        }
        Ok(index as u32)
    }

    /// Steps over the colour of a face: up to four components, and before them how many they are.
    fn colour(&mut self, item: Item) -> Result<(), Error> {
        let start = self.at;
        let components = self.count(item)?;
        if components > 4 {
            let (word, expected) = (components.to_string(), "a number of colour components, 0 to 4");
            return Err(malformed(Place::ByteIn { item, byte: start }, Reason::BadWord { word, expected }));
        }
        let length = components as usize * NUMBER;
        self.check_rest(length as u64, item, start)?;
        self.take(length);
        Ok(())
    }

    fn count(&mut self, item: Item) -> Result<u64, Error> {
        let byte = self.at;
        let count = self.integer(item)?;
        let bad = |_| {
            malformed(
                Place::ByteIn { item, byte },
                Reason::BadWord { word: count.to_string(), expected: "a count" },
            )
        };
        u64::try_from(count).map_err(bad)
    }

    #[inline(always)]
    fn integer(&mut self, item: Item) -> Result<i32, Error> {
        let Some(number) = self.bytes[self.at..].first_chunk::<NUMBER>() else {
            return Err(malformed(Place::Byte(self.at), Reason::Ends { item }));
        };
        self.at += NUMBER;
        Ok(i32::from_be_bytes(*number))
    }

    /// So many bytes, which were seen to be there.
    fn take(&mut self, length: usize) -> &'a [u8] {
        let taken = &self.bytes[self.at..self.at + length];
        self.at += length;
        taken
    }

    /// Refuses an item that declares at byte `declared_at` to go on for more bytes than there are.
    #[inline(always)]
    fn check_rest(&self, needed: u64, item: Item, declared_at: usize) -> Result<(), Error> {
        let rest = (self.bytes.len() - self.at) as u64;
        if needed <= rest {
            return Ok(());
        }
        let [needed, available] = match item {
            Item::File => [needed + self.at as u64, self.bytes.len() as u64],
            _ => [needed, rest],
        };
        Err(malformed(Place::Byte(declared_at), Reason::TooShort { item, needed, available }))
    }

    fn finish(mut self) -> Result<Triangles, Error> {
        if self.polygons.faces().len() > u32::MAX as usize {
            return Err(malformed(Place::File, Reason::TooMany));
        }
        let rest = self.bytes.len() - self.at;
        if rest > 0 {
            push(
                &mut self.notes,
                Note { what: Skipped::TrailingBytes, count: rest, first: Place::Byte(self.at) },
            )?;
        }
        Ok(self.polygons.into_triangles(self.positions, self.notes))
    }
}

/// One of the numbers of a vertex.
fn float(vertex: &[u8], number: usize) -> f32 {
    let start = NUMBER * number;
    f32::from_be_bytes([vertex[start], vertex[start + 1], vertex[start + 2], vertex[start + 3]])
}

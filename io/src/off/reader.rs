//! The vertices and faces of an OFF file.

use super::header::Header;
use super::malformed;
use crate::error::quote;
use crate::memory::{push, reserve};
use crate::number::{f32_of, index_prefix};
use crate::polygons::Polygons;
use crate::triangles::skip;
use crate::words::Words;
use crate::{Error, Note, Place, Reason, Skipped, Triangles};

/// How vertices and faces are told from what stands behind them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Layout {
    /// Each is a line.
    Lines,
    /// Nothing stands behind them.
    Stream,
    /// Nothing stands behind them, and nothing behind the last one either.
    WholeStream,
}

/// Why reading stopped.
#[derive(Debug)]
pub(super) enum Failure {
    /// A line is too short, or there are too few: the file may have another layout.
    Line(Error),
    Other(Error),
}

impl From<Error> for Failure {
    fn from(error: Error) -> Self {
        Self::Other(error)
    }
}

pub(super) struct Reader<'a> {
    words: Words<'a>,
    layout: Layout,
    positions: Vec<[f32; 3]>,
    polygons: Polygons,
    notes: Vec<Note>,
}

impl<'a> Reader<'a> {
    /// At the first vertex.
    pub(super) fn new(words: Words<'a>, layout: Layout) -> Self {
        Self { words, layout, positions: Vec::new(), polygons: Polygons::default(), notes: Vec::new() }
    }

    pub(super) fn run(mut self, header: &Header<'_>) -> Result<Triangles, Failure> {
        reserve(&mut self.positions, header.vertices)?;
        for _ in 0..header.vertices {
            self.vertex(header)?;
        }
        for read in 0..header.faces {
            self.face(header, read)?;
        }
        if self.layout == Layout::WholeStream {
            self.check_end()?;
        }
        if self.polygons.faces().len() > u32::MAX as usize {
            return Err(malformed(Place::File, Reason::TooMany).into());
        }
        Ok(self.polygons.into_triangles(self.positions, self.notes))
    }

    #[inline(always)]
    fn vertex(&mut self, header: &Header<'_>) -> Result<(), Failure> {
        let position = match header.keyword.weight() {
            None => self.plain_position(header)?,
            Some(weight) => self.weighted_position(header, weight)?,
        };
        push(&mut self.positions, position)?;
        self.end_record();
        Ok(())
    }

    #[inline(always)]
    fn plain_position(&mut self, header: &Header<'_>) -> Result<[f32; 3], Failure> {
        let mut position = [0.0; 3];
        for (found, coordinate) in position.iter_mut().enumerate() {
            let word = self.component(header, found)?;
            *coordinate = f32_of(word).ok_or_else(|| self.bad_number(word))?;
        }
        Ok(position)
    }

    fn weighted_position(&mut self, header: &Header<'_>, weight: usize) -> Result<[f32; 3], Failure> {
        let mut components = [0.0; 4];
        for (found, component) in components.iter_mut().enumerate() {
            let word = self.component(header, found)?;
            *component = fast_float2::parse(word).map_err(|_| self.bad_number(word))?;
        }
        Ok(divided(components, weight))
    }

    /// The next number of a vertex that has `found` already.
    #[inline(always)]
    fn component(&mut self, header: &Header<'_>, found: usize) -> Result<&'a [u8], Failure> {
        let word = if found == 0 { self.words.next() } else { self.next() };
        match word {
            Some(word) => Ok(word),
            None => Err(self.short_vertex(header, found)),
        }
    }

    #[inline(always)]
    fn face(&mut self, header: &Header<'_>, read: u64) -> Result<(), Failure> {
        let Some(word) = self.words.next() else {
            return Err(self.short(Reason::Missing {
                what: "faces",
                declared: header.faces,
                present: read as usize,
            }));
        };
        let Some((false, declared, [])) = index_prefix(word) else {
            return Err(self.malformed(Reason::BadWord { word: quote(word), expected: "a count" }).into());
        };
        let mut polygon = self.polygons.open();
        while (polygon.size as u64) < declared {
            let Some(word) = self.next() else {
                return Err(self.short(Reason::Missing { what: "corners", declared, present: polygon.size }));
            };
            let corner = self.corner(word, declared)?;
            self.polygons.corner(&mut polygon, corner)?;
        }
        if polygon.size < 3 {
            let line = Place::Line(self.words.line());
            skip(&mut self.notes, Skipped::ShortFaces, 1, line);
        } else {
            self.polygons.close(polygon)?;
        }
        self.end_record();
        Ok(())
    }

    /// The vertex that a corner names. Faces that are skipped may name any.
    #[inline(always)]
    fn corner(&mut self, word: &[u8], corners: u64) -> Result<u32, Error> {
        let Some((negative, index, [])) = index_prefix(word) else {
            return Err(self.malformed(Reason::BadIndex { word: quote(word) }));
        };
        let vertices = self.positions.len();
        if corners >= 3 && (index >= vertices as u64 || negative && index > 0) {
            return Err(self.malformed(Reason::IndexOutOfRange { index: quote(word), vertices }));
        }
        Ok(index as u32)
    }

    /// The next word of the vertex or the face.
    #[inline(always)]
    fn next(&mut self) -> Option<&'a [u8]> {
        match self.layout {
            Layout::Lines => self.words.next_on_line(),
            Layout::Stream | Layout::WholeStream => self.words.next(),
        }
    }

    #[inline(always)]
    fn end_record(&mut self) {
        if self.layout == Layout::Lines {
            self.words.end_line();
        }
    }

    fn check_end(&mut self) -> Result<(), Error> {
        let expected = "the end of the file, though all vertices and faces were read";
        match self.words.next() {
            None => Ok(()),
            Some(word) => Err(self.malformed(Reason::BadWord { word: quote(word), expected })),
        }
    }

    #[cold]
    fn bad_number(&mut self, word: &[u8]) -> Error {
        self.malformed(Reason::BadNumber { word: quote(word) })
    }

    #[cold]
    fn short_vertex(&mut self, header: &Header<'_>, found: usize) -> Failure {
        let present = self.positions.len();
        self.short(match (found, header.keyword.components()) {
            (0, _) => Reason::Missing { what: "vertices", declared: header.vertices as u64, present },
            (_, 3) => Reason::TooFewCoordinates { found },
            (_, all) => {
                Reason::Missing { what: "components of a vertex", declared: all as u64, present: found }
            }
        })
    }

    #[cold]
    fn short(&mut self, reason: Reason) -> Failure {
        Failure::Line(self.malformed(reason))
    }

    #[cold]
    fn malformed(&mut self, reason: Reason) -> Error {
        malformed(Place::Line(self.words.line()), reason)
    }
}

/// The point of homogeneous coordinates, one of which is the divisor: rounded once, behind the division.
pub(super) fn divided(components: [f64; 4], weight: usize) -> [f32; 3] {
    // In front of the coordinates, or behind them.
    let first = usize::from(weight == 0);
    [0, 1, 2].map(|axis| (components[first + axis] / components[weight]) as f32)
}

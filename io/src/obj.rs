//! Wavefront OBJ: vertices and faces. Everything else is skipped.
//!
//! - A corner `a/b/c` is vertex `a`; texture coordinates and normals are ignored (with the feature `tobj`,
//!   `obj_attributes` reads them). Groups and objects share one list of vertices.
//! - Indices count from 1, negative ones back from the last vertex so far. A face may name vertices that
//!   the file defines later.
//! - `v x y z` may be followed by anything, such as a weight or a colour. It is ignored; a weight does not
//!   divide the coordinates.
//! - Coordinates are rounded once, from decimal text to the nearest `f32`. `inf` and `nan` are kept.
//! - A face of fewer than three corners is skipped, and so are points, lines, curves, surfaces and lines
//!   with an unknown keyword: [`Triangles::notes`] counts them.
//! - A backslash continues a line; LF, CRLF and CR end one. Names and comments may be in any encoding.

mod keyword;
mod lines;
#[cfg(feature = "parallel")]
mod lists;
mod numbering;
#[cfg(feature = "parallel")]
mod parallel;
pub(crate) mod pieces;
mod plain;
#[cfg(feature = "parallel")]
mod turns;
mod writer;

pub(crate) use self::keyword::begins_with_keyword;
use self::keyword::{element, is_other};
pub(crate) use self::lines::write as write_lines;
use self::numbering::Numbering;
pub(crate) use self::writer::write;
use crate::error::quote;
use crate::memory::push;
use crate::number::{f32_of, index_prefix};
use crate::polygons::Polygons;
use crate::text::{Scanner, without_byte_order_mark};
use crate::triangles::skip;
use crate::{Error, Format, Note, Place, Reason, Skipped, Triangles};

/// Reads the vertices and faces of an OBJ file. Linear in its size; besides the result it takes no memory.
///
/// With the feature `parallel`, all threads of the current rayon pool read a file of 1 MiB or more, to the same result:
/// in parts of 256 KiB that end with a line feed, of which each thread takes one after the other. Besides the result, a
/// part and what it holds are in memory for each thread: mostly less than 1 MB, never more than 6 MB but for a line
/// longer than a part. A file with something wrong, or with a line of more than 16 MiB, is then read from the beginning
/// by one thread.
///
/// # Errors
/// [`Error::Malformed`] with the line at fault, the first one in the file: a vertex with fewer than three
/// coordinates or with a word that is no number; a corner that is no index, is 0, or names no vertex of the
/// file. Also if there is neither a vertex nor a face, and most lines begin with no OBJ keyword: by chance, some
/// lines of any junk do. An empty file is an empty mesh.
pub fn read(bytes: &[u8]) -> Result<Triangles, Error> {
    #[cfg(feature = "parallel")]
    if let Some(mesh) = parallel::read(bytes) {
        return Ok(mesh);
    }
    read_in_order(bytes)
}

fn read_in_order(bytes: &[u8]) -> Result<Triangles, Error> {
    let mut reader = Reader::new(Numbering::of_file(u32::MAX));
    match reader.lines(without_byte_order_mark(bytes)) {
        Ok(()) if reader.has_all_corners() => return reader.finish(),
        Err(error @ Error::OutOfMemory { .. }) => return Err(error),
        // What was read goes before it is read again.
        _ => drop(reader),
    }
    // Whether a face's corners exist is known at the end only. Instead of remembering lines in every
    // file, the few bad files are read twice: now each corner is checked where it stands.
    let count = u32::try_from(count_vertices(Scanner::new(bytes)))
        .map_err(|_| malformed(Place::File, Reason::TooMany))?;
    let mut reader = Reader::new(Numbering::of_file(count));
    reader.lines(without_byte_order_mark(bytes))?;
    reader.finish()
}

fn count_vertices(mut scanner: Scanner<'_>) -> usize {
    let mut count = 0;
    while !scanner.is_at_end() {
        count += usize::from(scanner.word() == Some(b"v"));
        scanner.end_line();
    }
    count
}

fn malformed(place: Place, reason: Reason) -> Error {
    Error::malformed(Format::Obj, place, reason)
}

/// What a word of a face names.
enum Corner {
    Absolute(u32),
    Back(u32),
    /// No vertex that a face may name.
    Beyond,
}

struct Reader {
    /// What corners are made of before the first line.
    numbering: Numbering,
    /// The line behind what was read.
    next_line: usize,
    positions: Vec<[f32; 3]>,
    polygons: Polygons,
    /// One more than the highest corner of any face.
    corner_bound: u32,
    /// The lowest corner of faces that were skipped, among those that are counted back.
    lowest_skipped: u32,
    notes: Vec<Note>,
    /// Lines that are neither empty nor a comment.
    statements: usize,
}

impl Reader {
    fn new(numbering: Numbering) -> Self {
        Self {
            numbering,
            next_line: 1,
            positions: Vec::new(),
            polygons: Polygons::default(),
            corner_bound: 0,
            lowest_skipped: u32::MAX,
            notes: Vec::new(),
            statements: 0,
        }
    }

    /// Reads the next lines of the file.
    fn lines(&mut self, text: &[u8]) -> Result<(), Error> {
        let mut scanner = Scanner::of_lines(text, self.next_line);
        while !scanner.is_at_end() {
            if !self.plain_line(&mut scanner)? {
                self.line(&mut scanner)?;
            }
            scanner.end_line();
        }
        self.next_line = scanner.line();
        Ok(())
    }

    /// Reads any line. Apart from the few instructions that most lines need.
    #[inline(never)]
    fn line(&mut self, scanner: &mut Scanner<'_>) -> Result<(), Error> {
        let line = Place::Line(scanner.line());
        match scanner.word() {
            Some(keyword) => self.statement(keyword, scanner, line),
            None => Ok(()),
        }
    }

    #[inline(always)]
    fn statement(&mut self, keyword: &[u8], scanner: &mut Scanner<'_>, line: Place) -> Result<(), Error> {
        self.statements += 1;
        match keyword {
            b"v" => self.vertex(scanner, line)?,
            b"f" | b"fo" => self.face(scanner, line)?,
            b"vn" | b"vt" => {}
            _ => self.other(keyword, line),
        }
        Ok(())
    }

    #[inline(always)]
    fn vertex(&mut self, scanner: &mut Scanner<'_>, line: Place) -> Result<(), Error> {
        let mut position = [0.0; 3];
        for (found, coordinate) in position.iter_mut().enumerate() {
            let word = scanner.word().ok_or_else(|| malformed(line, Reason::TooFewCoordinates { found }))?;
            *coordinate =
                f32_of(word).ok_or_else(|| malformed(line, Reason::BadNumber { word: quote(word) }))?;
        }
        push(&mut self.positions, position)
    }

    #[inline(always)]
    fn face(&mut self, scanner: &mut Scanner<'_>, line: Place) -> Result<(), Error> {
        let mut polygon = self.polygons.open();
        let mut bound = 0;
        let (mut beyond, mut lowest) = (None, u32::MAX);
        while let Some(word) = scanner.word() {
            let corner = match self.corner(word, line)? {
                Corner::Back(corner) => {
                    lowest = lowest.min(corner);
                    corner
                }
                Corner::Absolute(corner) => {
                    bound = bound.max(corner.saturating_add(1));
                    corner
                }
                Corner::Beyond => {
                    beyond = beyond.or(Some(word));
                    u32::MAX
                }
            };
            self.polygons.corner(&mut polygon, corner)?;
        }
        if polygon.size < 3 {
            self.lowest_skipped = self.lowest_skipped.min(lowest);
            skip(&mut self.notes, Skipped::ShortFaces, 1, line);
            return Ok(());
        }
        if let Some(word) = beyond {
            return Err(out_of_range(word, self.numbering.limit() as usize, line));
        }
        self.corner_bound = self.corner_bound.max(bound);
        self.polygons.close(polygon)
    }

    fn corner(&self, word: &[u8], line: Place) -> Result<Corner, Error> {
        let bad = || malformed(line, Reason::BadIndex { word: quote(word) });
        let (negative, index, rest) = index_prefix(word).ok_or_else(bad)?;
        if !rest.is_empty() && !is_corner_tail(rest) {
            return Err(bad());
        }
        if index == 0 {
            return Err(malformed(line, Reason::IndexZero));
        }
        let numbering = self.numbering.after(self.positions.len());
        if !negative {
            return Ok(numbering.absolute(index).map_or(Corner::Beyond, Corner::Absolute));
        }
        let corner = numbering.back(index);
        corner.map(Corner::Back).ok_or_else(|| out_of_range(word, self.positions.len(), line))
    }

    #[cold]
    fn other(&mut self, keyword: &[u8], line: Place) {
        if let Some(element) = element(keyword) {
            skip(&mut self.notes, Skipped::Elements(element.into()), 1, line);
        } else if !is_other(keyword) {
            skip(&mut self.notes, Skipped::UnknownStatements, 1, line);
        }
    }

    /// Whether the corners that are not counted back exist.
    fn has_all_corners(&self) -> bool {
        self.corner_bound as usize <= self.positions.len()
    }

    /// The first unknown line of a file that is not OBJ at all.
    fn junk(&self) -> Option<Place> {
        let is_empty = self.positions.is_empty() && self.polygons.faces().is_empty();
        let unknown = self.notes.iter().find(|note| note.what == Skipped::UnknownStatements);
        let is_most = |note: &&Note| is_empty && note.count > self.statements - note.count;
        unknown.filter(is_most).map(|note| note.first)
    }

    fn finish(mut self) -> Result<Triangles, Error> {
        if let Some(line) = self.junk() {
            let expected =
                "an OBJ file: it has no vertex, and most lines begin with no keyword of the format";
            return Err(malformed(line, Reason::NotThisFormat { expected }));
        }
        if self.positions.len().max(self.polygons.faces().len()) > u32::MAX as usize {
            return Err(malformed(Place::File, Reason::TooMany));
        }
        self.positions.shrink_to_fit();
        Ok(self.polygons.into_triangles(self.positions, self.notes))
    }
}

/// `/2/3`, `//3`, `/2`, `/`: texture coordinate and normal, which need not exist.
fn is_corner_tail(tail: &[u8]) -> bool {
    tail[0] == b'/' && tail.iter().all(|byte| matches!(byte, b'/' | b'-' | b'+' | b'0'..=b'9'))
}

fn out_of_range(word: &[u8], vertices: usize, line: Place) -> Error {
    let index = word.split(|byte| *byte == b'/').next().unwrap_or(word);
    malformed(line, Reason::IndexOutOfRange { index: quote(index), vertices })
}

//! STL, binary and ASCII: triangles, each with its own three corners.
//!
//! - Corners at equal positions become one vertex, in order of first appearance, unless
//!   [`Options::weld_stl`](crate::Options::weld_stl) is off: then triangle `f` has the vertices `3 f` to `3 f + 2`.
//!   Equal are coordinates of the same `f32` value: -0.0 equals +0.0, and a NaN equals nothing. The bits of the first
//!   corner are kept.
//! - A file is binary if its length is that of the triangles that it declares, 84 + 50 n bytes, whatever its header
//!   says; else it is ASCII if it begins with `solid` and no zero byte is among the first 84.
//! - Bytes behind the declared triangles of a binary file are skipped, with a note: many programs append something.
//! - Keywords of an ASCII file are in upper or lower case, line ends are blanks like others, and all `solid` blocks
//!   make one mesh. The rest of a line with an unknown keyword is skipped, with a note.
//! - Normals, names and the two bytes behind each binary triangle are ignored.

mod ascii;
pub(crate) mod pieces;
mod writer;

pub(crate) use self::writer::write;
use crate::memory::reserve;
use crate::triangles::skip;
use crate::{Error, Format, Note, Options, Place, Reason, Skipped, Triangles};
use onering_core::repair::weld_into;
use onering_core::{BuildError, memory};
use std::ops::Range;

const HEADER: usize = 84;
const RECORD: usize = 50;

/// More triangles have more corners than can be numbered.
const MOST: usize = u32::MAX as usize / 3;

/// Whether it is STL by its length, or begins with `solid`.
pub(crate) fn looks_like_stl(bytes: &[u8]) -> bool {
    has_binary_length(bytes, bytes.len() as u64) || ascii::begins_with_solid(bytes)
}

/// Reads the triangles of an STL file. Linear in its size; see [`weld_into`] for files made to be slow.
///
/// # Memory
/// The result has 12 bytes for each triangle and 12 for each vertex. If corners are welded, about 20 bytes more are
/// taken for each triangle of a closed surface while it is made, and up to 110 where no corners are equal; none if
/// they are not. Where the file is ASCII, its corners take 36 to 72 more.
///
/// # Errors
/// [`Error::Malformed`]: a binary file that has fewer triangles than it declares; in an ASCII file, with the line at
/// fault, a vertex without three numbers, a loop that has not three vertices or is not ended, or nothing but lines
/// with unknown keywords.
pub fn read(bytes: &[u8], options: &Options) -> Result<Triangles, Error> {
    if is_ascii(bytes) {
        let (corners, notes) = ascii::read(bytes)?;
        return triangles(corners, options.weld_stl, notes);
    }
    let (records, notes) = records(bytes)?;
    triangles(Binary(records), options.weld_stl, notes)
}

fn is_ascii(bytes: &[u8]) -> bool {
    // Beyond the header as well: a count may have none. The numbers of the first triangles do.
    let has_zero = || bytes.iter().take(512).any(|byte| *byte == 0);
    !has_binary_length(bytes, bytes.len() as u64) && ascii::begins_with_solid(bytes) && !has_zero()
}

/// Whether a file that begins like this has just the length that it declares.
pub(crate) fn has_binary_length(start: &[u8], length: u64) -> bool {
    declared(start).is_some_and(|count| length == length_of(count))
}

/// How many triangles a binary file says it has.
fn declared(bytes: &[u8]) -> Option<u64> {
    let count = bytes.get(HEADER - 4..)?.first_chunk()?;
    Some(u64::from(u32::from_le_bytes(*count)))
}

fn length_of(count: u64) -> u64 {
    HEADER as u64 + RECORD as u64 * count
}

/// The declared triangles of a binary file, and a note on what lies behind them.
fn records(bytes: &[u8]) -> Result<(&[[u8; RECORD]], Vec<Note>), Error> {
    let too_short = Reason::NotThisFormat {
        expected: "an STL file: it is shorter than a binary one, and does not begin with `solid`",
    };
    let declared = declared(bytes).ok_or_else(|| malformed(Place::File, too_short))?;
    let (records, rest) = bytes[HEADER..].as_chunks();
    let present = records.len();
    let missing = Reason::Missing { what: "triangles", declared, present };
    let records = usize::try_from(declared).ok().and_then(|count| records.get(..count));
    let records = records.ok_or_else(|| malformed(Place::File, missing))?;
    let behind = rest.len() + RECORD * (present - records.len());
    let mut notes = Vec::new();
    if behind > 0 {
        skip(&mut notes, Skipped::TrailingBytes, behind, Place::Byte(bytes.len() - behind));
    }
    Ok((records, notes))
}

/// The corners of triangles, three by three.
trait Corners {
    fn triangle_count(&self) -> usize;
    fn corner(&self, corner: usize) -> [f32; 3];
    /// All corners as vertices.
    fn into_positions(self) -> Result<Vec<[f32; 3]>, Error>;
}

/// Normal, three corners and two more bytes, in little-endian order.
struct Binary<'a>(&'a [[u8; RECORD]]);

impl Corners for Binary<'_> {
    fn triangle_count(&self) -> usize {
        self.0.len()
    }

    #[inline(always)]
    fn corner(&self, corner: usize) -> [f32; 3] {
        corner_of(&self.0[corner / 3], corner % 3)
    }

    fn into_positions(self) -> Result<Vec<[f32; 3]>, Error> {
        let mut triangles = Vec::new();
        reserve(&mut triangles, self.0.len())?;
        triangles.extend(self.0.iter().map(corners_of));
        Ok(triangles.into_flattened())
    }
}

#[inline(always)]
fn corners_of(record: &[u8; RECORD]) -> [[f32; 3]; 3] {
    std::array::from_fn(|corner| corner_of(record, corner))
}

/// One of the three.
#[inline(always)]
fn corner_of(record: &[u8; RECORD], corner: usize) -> [f32; 3] {
    let number = |i: usize| f32::from_le_bytes(std::array::from_fn(|byte| record[i + byte]));
    let at = 12 + 12 * corner;
    [number(at), number(at + 4), number(at + 8)]
}

impl Corners for Vec<[f32; 3]> {
    fn triangle_count(&self) -> usize {
        self.len() / 3
    }

    #[inline(always)]
    fn corner(&self, corner: usize) -> [f32; 3] {
        self[corner]
    }

    fn into_positions(mut self) -> Result<Vec<[f32; 3]>, Error> {
        self.shrink_to_fit();
        Ok(self)
    }
}

fn triangles(corners: impl Corners, weld: bool, notes: Vec<Note>) -> Result<Triangles, Error> {
    let count = corners.triangle_count();
    if count > MOST {
        return Err(malformed(Place::File, Reason::TooMany));
    }
    let (positions, faces) = if weld {
        welded(&corners)?
    } else {
        let mut faces = Vec::new();
        reserve(&mut faces, count)?;
        faces.extend(unwelded_faces(0..count));
        (corners.into_positions()?, faces)
    };
    Ok(Triangles { notes, ..Triangles::new(positions, faces) })
}

/// These triangles, each with vertices of its own.
fn unwelded_faces(triangles: Range<usize>) -> impl Iterator<Item = [u32; 3]> {
    triangles.map(|f| [3 * f as u32, 3 * f as u32 + 1, 3 * f as u32 + 2])
}

type Arrays = (Vec<[f32; 3]>, Vec<[u32; 3]>);

fn welded(corners: &impl Corners) -> Result<Arrays, Error> {
    let weld = || {
        let mut faces = memory::filled(corners.triangle_count(), [0; 3])?;
        let positions = weld_into(faces.as_flattened_mut(), |corner| corners.corner(corner))?;
        Ok((positions, faces))
    };
    let (mut positions, faces) = weld().map_err(|error| match error {
        BuildError::OutOfMemory { bytes } => Error::OutOfMemory { path: None, bytes },
        _ => malformed(Place::File, Reason::TooMany),
    })?;
    positions.shrink_to_fit();
    Ok((positions, faces))
}

fn malformed(place: Place, reason: Reason) -> Error {
    Error::malformed(Format::Stl, place, reason)
}

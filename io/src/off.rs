//! OFF, the Object File Format of Geomview: vertices and polygons.
//!
//! - The keyword is `OFF` behind any of `ST`, `C`, `N`, which announce texture coordinates, colours and normals at
//!   the vertices, in whatever order: programs differ from the manual in it. It may be missing, as the manual has
//!   it, but then only the file's extension tells what it is. `4OFF`, `nOFF` and `OFF BINARY` are refused.
//! - The counts of vertices and faces follow, on its line or the next; that of the edges is ignored and may be
//!   missing.
//! - A line is a vertex or a face, and what stands behind the coordinates or corners is ignored: colours, normals,
//!   texture coordinates. Only a file of the plain keyword, or none, may be broken into lines otherwise; then nothing
//!   but coordinates and corners may be in it.
//! - A face of fewer than three corners is skipped, with a note. So is, without one, all that follows the last face.
//! - `#` hides the rest of its line; LF, CRLF and CR end one.

mod header;
mod reader;
mod writer;

pub(crate) use self::header::begins_with_keyword;
pub(crate) use self::writer::write;
use crate::words::Words;
use crate::{Error, Format, Place, Reason, Triangles};
use header::Header;
use reader::{Failure, Layout, Reader};

/// Reads the vertices and faces of an OFF file. Linear in its size; besides the result it takes no memory.
///
/// # Errors
/// [`Error::Malformed`] with the line at fault: counts that are none or that the file is too short for, a vertex of
/// fewer than three numbers, a face of fewer corners than it says, a corner that is no index or names no vertex.
/// [`Error::Unsupported`] for `4OFF`, `nOFF` and `OFF BINARY`.
pub fn read(bytes: &[u8]) -> Result<Triangles, Error> {
    let mut words = Words::new(bytes, Some(b'#'));
    let header = Header::read(&mut words, bytes.len())?;
    match Reader::new(words.clone(), Layout::Lines).run(&header) {
        Err(Failure::Line(_)) if header.is_plain => Reader::new(words, Layout::Stream).run(&header),
        result => result,
    }
    .map_err(|failure| match failure {
        Failure::Line(error) | Failure::Other(error) => error,
    })
}

fn malformed(place: Place, reason: Reason) -> Error {
    Error::malformed(Format::Off, place, reason)
}

//! OFF, the Object File Format of Geomview: vertices and polygons.
//!
//! - The keyword is `OFF` behind any of `ST`, `C`, `N`, which announce texture coordinates, colours and normals at
//!   the vertices, in whatever order: programs differ from the manual in it. It may be missing, as the manual has
//!   it, but then only the file's extension tells what it is.
//! - `4` before `OFF` announces homogeneous coordinates: a vertex is `x y z w` and lies at x/w, y/w, z/w, divided as
//!   `f64` and then rounded to `f32` once. Where w is 0, that is infinite or NaN.
//! - `n` before `OFF` announces a dimension, which follows on a line of its own: 3 is read. The manual does not say
//!   where `4nOFF` has w; Geomview takes the first of the four components for it, and so does this.
//! - The counts of vertices and faces follow, on its line or the next; that of the edges is ignored and may be
//!   missing.
//! - A line is a vertex or a face, and what stands behind the coordinates or corners is ignored: colours, normals,
//!   texture coordinates. Only a file without `ST`, `C` and `N` may be broken into lines otherwise; then nothing but
//!   coordinates and corners may be in it. If data begins on the line of the counts, behind that of the edges, nothing
//!   may follow the last face.
//! - `BINARY` behind the keyword: after the line end, everything is 32-bit integers and floats, the most significant
//!   byte first. The counts, three here; the vertices, each with its normal, colour (four floats) and texture
//!   coordinates if announced; the faces, each with its corner count, corners, and a colour of as many floats as the
//!   integer before it says, up to four. The dimension of `nOFF` stands before `BINARY`, where Geomview reads it, or is
//!   the first of the integers. What follows the last face is left out with a note.
//! - A face of fewer than three corners is skipped, with a note. So is, without one, all text that follows the last
//!   face.
//! - `#` hides the rest of its line; LF, CRLF and CR end one.

mod binary;
mod header;
mod keyword;
mod reader;
mod writer;

pub(crate) use self::keyword::begins_with_keyword;
pub(crate) use self::writer::write;
use crate::error::quote;
use crate::words::Words;
use crate::{Error, Format, Place, Reason, Triangles};
use header::Header;
use keyword::Keyword;
use reader::{Failure, Layout, Reader};

/// Reads the vertices and faces of an OFF file. Linear in its size; besides the result it takes no memory.
///
/// # Errors
/// [`Error::Malformed`] with the line at fault, or the byte of a binary file: counts that are none or that the file is too short for, a vertex of
/// too few numbers, a face of fewer corners than it says, a corner that is no index or names no vertex, words behind
/// the counts that are no data. [`Error::Unsupported`] for `nOFF` of another dimension than 3.
pub fn read(bytes: &[u8]) -> Result<Triangles, Error> {
    let mut words = Words::new(bytes, Some(b'#'));
    let keyword = Keyword::read(&mut words)?;
    if keyword.is_binary {
        return binary::read(bytes, words.at(), keyword);
    }
    let header = Header::read(keyword, words, bytes.len())?;
    let by_line = Reader::new(header.lines.clone(), Layout::Lines).run(&header);
    let result = match (by_line, header.stray) {
        (Err(Failure::Other(error @ Error::OutOfMemory { .. })), _) => return Err(error),
        (Err(_), Some(_)) if keyword.is_plain() => in_stream(&header, Layout::WholeStream),
        (Err(Failure::Line(_)), None) if keyword.is_plain() => in_stream(&header, Layout::Stream),
        (_, Some((word, line))) => {
            let expected = "the end of the line behind the counts";
            return Err(malformed(line, Reason::BadWord { word: quote(word), expected }));
        }
        (result, None) => result,
    };
    result.map_err(|failure| match failure {
        Failure::Line(error) | Failure::Other(error) => error,
    })
}

fn in_stream(header: &Header<'_>, layout: Layout) -> Result<Triangles, Failure> {
    Reader::new(header.stream.clone(), layout).run(header)
}

fn malformed(place: Place, reason: Reason) -> Error {
    Error::malformed(Format::Off, place, reason)
}

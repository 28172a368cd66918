//! Stanford PLY, in text and in both binary byte orders: vertices, faces and strips. Everything else is skipped.
//!
//! - Positions are the properties `x`, `y`, `z` of the element `vertex`, of any types and in any order. Each is rounded
//!   once to the nearest `f32`; `inf` and `nan` are kept.
//! - Faces are the list `vertex_indices`, or else `vertex_index`, of the element `face`. One of fewer than three corners
//!   is skipped, with a note.
//! - Strips are that list of the element `tristrips`, or else its first list. A negative index ends a strip; every other
//!   triangle is turned around. Their triangles come after all faces, wherever they stand in the file.
//! - Elements may come in any order, with any further properties. Other elements are skipped, and so are unknown lines
//!   of the header and bytes behind the last element: [`Triangles::notes`] counts them.
//! - LF, CRLF and CR end a line. In a file whose first line ends with CR alone, `end_header` does so too: an LF behind it
//!   is the first byte of the data. In text, line ends are blanks behind the header.
//!
//! After Greg Turk, "The PLY Polygon File Format" (1994). It has no version but 1.0; none is asked for.

mod ascii;
mod binary;
mod body;
mod element;
mod encoding;
mod header;
mod lines;
mod role;
mod rows;
mod scalar;
mod source;
mod writer;

use self::ascii::Ascii;
use self::binary::Binary;
use self::body::Body;
use self::header::{Encoding, Header};
pub(crate) use self::lines::write as write_lines;
pub(crate) use self::writer::write;
use crate::{Error, Format, Place, Reason, Triangles};

/// Whether the first line is `ply`.
pub(crate) fn begins_with_mark(bytes: &[u8]) -> bool {
    let rest = bytes.strip_prefix(b"ply").map(<[u8]>::trim_ascii_start);
    rest.is_some_and(|rest| {
        bytes[3..bytes.len() - rest.len()].iter().any(|byte| matches!(byte, b'\n' | b'\r'))
    })
}

/// Reads the vertices and faces of a PLY file. Linear in its size; besides the result it takes at most 40 bytes for each
/// byte of the header. No count of the file is believed: memory is taken for what the bytes behind it can hold.
///
/// # Errors
/// [`Error::Malformed`] with the line of the header or of a text file, or with the byte and the element of a binary one:
/// a header that has no end, no format, an unknown type, a count that is none, an element or a property twice, vertices
/// without `x`, `y` and `z`, or indices that are no integers; a file that ends too early; a list of negative length; in
/// text a length, an index or a coordinate that is no number; an index that names no vertex.
pub fn read(bytes: &[u8]) -> Result<Triangles, Error> {
    let header = Header::parse(bytes)?;
    match header.encoding {
        Encoding::Ascii => Body::new(&header, Ascii::new(bytes, header.end)).read(),
        Encoding::LittleEndian => Body::new(&header, Binary::<false>::new(bytes, header.end)).read(),
        Encoding::BigEndian => Body::new(&header, Binary::<true>::new(bytes, header.end)).read(),
    }
}

fn malformed(place: Place, reason: Reason) -> Error {
    Error::malformed(Format::Ply, place, reason)
}

//! What this crate knows of `.ring`, the binary file of onering's own structures: how it begins. It holds a structure
//! with all its columns and not only triangles, so its reader is `onering::ring`, in the crate that has the structures.

use crate::{Error, Format, Place};

/// The first eight bytes of every `.ring` file: a byte that no text has, the name, and line ends that a transfer as text
/// would change.
pub const MAGIC: [u8; 8] = *b"\x89ring\r\n\x1a";

pub(crate) fn unsupported() -> Error {
    let feature = "to be opened with `onering::ring`".into();
    Error::Unsupported { format: Format::Ring, path: None, place: Place::File, feature }
}

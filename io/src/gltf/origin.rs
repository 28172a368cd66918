//! Where the triangles of a glTF document come from.

use std::collections::BTreeSet;
use std::fmt;

/// The parts of a glTF document that a mesh was read from.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Origin {
    /// How many primitives were read; those in [`Triangles::notes`](crate::Triangles::notes) were not.
    pub primitives: usize,
    /// The kinds of the buffers that positions and indices lie in.
    pub buffers: BTreeSet<BufferKind>,
}

/// Where a buffer of a glTF document lies. Its `Display` is `bin chunk`, `data uri` or `external bin`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[non_exhaustive]
pub enum BufferKind {
    /// In the BIN chunk of a GLB.
    Chunk,
    /// In the JSON itself, as a data URI.
    DataUri,
    /// In a file beside the document.
    File,
}

impl BufferKind {
    pub(super) fn of(uri: Option<&str>) -> Self {
        match uri {
            None => Self::Chunk,
            Some(uri) if uri.starts_with("data:") => Self::DataUri,
            Some(_) => Self::File,
        }
    }
}

impl fmt::Display for BufferKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Chunk => "bin chunk",
            Self::DataUri => "data uri",
            Self::File => "external bin",
        })
    }
}

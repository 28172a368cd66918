//! Places in a file and parts of it, for errors and notes.

use std::fmt;

/// Where in a file. Lines count from 1, everything else from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Place {
    /// The file as a whole.
    File,
    /// A line of a text file; where a backslash continues it, the first line.
    Line(usize),
    /// A byte of a binary file.
    Byte(usize),
    /// A byte of a binary file, in this part of it.
    ByteIn {
        /// The part.
        item: Item,
        /// The byte, from the start of the file.
        byte: usize,
    },
    /// A vertex of a mesh that is to be written.
    Vertex(usize),
    /// A face of a mesh that is to be written.
    Face(usize),
    /// A buffer of a glTF document.
    Buffer(usize),
    /// A primitive of a glTF document.
    Primitive {
        /// Index of the mesh.
        mesh: usize,
        /// Index of the primitive in the mesh.
        primitive: usize,
    },
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => write!(f, "the whole file"),
            Self::Line(line) => write!(f, "line {line}"),
            Self::Byte(byte) => write!(f, "byte {byte}"),
            Self::ByteIn { item, byte } => write!(f, "{item} at byte {byte}"),
            Self::Vertex(vertex) => write!(f, "vertex {vertex}"),
            Self::Face(face) => write!(f, "face {face}"),
            Self::Buffer(buffer) => write!(f, "buffer {buffer}"),
            Self::Primitive { mesh, primitive } => write!(f, "mesh {mesh} primitive {primitive}"),
        }
    }
}

/// A part of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Item {
    /// The file as a whole.
    File,
    /// The header of a GLB file.
    Header,
    /// A chunk of a GLB file, by its position.
    Chunk(usize),
    /// A glTF buffer.
    Buffer(usize),
    /// A glTF bufferView.
    BufferView(usize),
    /// A glTF accessor.
    Accessor(usize),
    /// The sparse part of a glTF accessor.
    Sparse(usize),
    /// A vertex.
    Vertex(usize),
    /// A face, as the file counts them.
    Face(usize),
    /// A strip of triangles.
    Strip(usize),
    /// One of the other elements that a PLY file declares.
    Row {
        /// Index of the declaration in the header.
        element: usize,
        /// Which one of those that it declares.
        row: usize,
    },
}

impl fmt::Display for Item {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::File => write!(f, "the file"),
            Self::Header => write!(f, "the header"),
            Self::Chunk(i) => write!(f, "chunk {i}"),
            Self::Buffer(i) => write!(f, "buffer {i}"),
            Self::BufferView(i) => write!(f, "bufferView {i}"),
            Self::Accessor(i) => write!(f, "accessor {i}"),
            Self::Sparse(i) => write!(f, "sparse accessor {i}"),
            Self::Vertex(i) => write!(f, "vertex {i}"),
            Self::Face(i) => write!(f, "face {i}"),
            Self::Strip(i) => write!(f, "strip {i}"),
            Self::Row { element, row } => write!(f, "element {element} row {row}"),
        }
    }
}

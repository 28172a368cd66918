//! What can go wrong while a topology is built.
use core::fmt;

/// Why a face list is not a topology that a backend can hold. Faces and vertices are named by their index.
///
/// Where several things are wrong, faces are looked at before edges and edges before vertices, and the element
/// that comes first in the list is named, whichever pairing was asked for. `repair` mends all
/// but too large numbers.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum BuildError {
    /// A face names a vertex that does not exist.
    VertexOutOfRange {
        /// The face.
        face: usize,
        /// The vertex that it names.
        vertex: u32,
        /// Number of vertices.
        vertex_count: usize,
    },
    /// A face names one vertex more than once.
    DegenerateFace {
        /// The face.
        face: usize,
        /// The vertex that it repeats.
        vertex: u32,
    },
    /// Three or more faces lie along one edge, and the backend cannot hold that.
    NonManifoldEdge {
        /// The ends of the edge, the lesser first.
        vertices: [u32; 2],
        /// Number of faces along it.
        faces: usize,
        /// The first face that is one too many.
        face: usize,
    },
    /// Two faces run along one edge in the same direction: they disagree in orientation.
    SameDirection {
        /// Start and end of the edge, as both faces run.
        vertices: [u32; 2],
        /// The two faces.
        faces: [usize; 2],
    },
    /// The faces of a vertex form more than one fan, and the backend cannot hold that.
    SeveralFans {
        /// The vertex.
        vertex: u32,
        /// Number of fans.
        fans: usize,
    },
    /// More vertices than a four-byte handle can name.
    TooManyVertices {
        /// Number of vertices.
        vertices: usize,
        /// The most that the backend can name.
        limit: usize,
    },
    /// More half-edges than the links of the backend can name.
    TooManyHalfEdges {
        /// Number of half-edges, three for each face.
        half_edges: usize,
        /// The most that the backend can name.
        limit: usize,
    },
    /// More records of non-manifold elements than the links of the backend can name.
    TooManyRecords {
        /// Words in the records.
        words: usize,
        /// The most that the backend can name.
        limit: usize,
    },
    /// The memory for the tables could not be had.
    OutOfMemory {
        /// Size of the table that was asked for.
        bytes: usize,
    },
}

impl fmt::Display for BuildError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::VertexOutOfRange { face, vertex, vertex_count } => {
                write!(f, "face {face} names vertex {vertex}, but there are {vertex_count} vertices")
            }
            Self::DegenerateFace { face, vertex } => write!(f, "face {face} names vertex {vertex} twice"),
            Self::NonManifoldEdge { vertices: [a, b], faces, face } => {
                write!(f, "{faces} faces lie along the edge {a}-{b}; face {face} is one too many")
            }
            Self::SameDirection { vertices: [a, b], faces: [first, second] } => {
                write!(f, "faces {first} and {second} both run from vertex {a} to {b}")
            }
            Self::SeveralFans { vertex, fans } => {
                write!(f, "the faces around vertex {vertex} form {fans} fans that meet only there")
            }
            Self::TooManyVertices { vertices, limit } => {
                write!(f, "{vertices} vertices; the most is {limit}")
            }
            Self::TooManyHalfEdges { half_edges, limit } => {
                write!(f, "{half_edges} half-edges; the most is {limit}")
            }
            Self::TooManyRecords { words, limit } => {
                write!(f, "{words} words in records of non-manifold elements; the most is {limit}")
            }
            Self::OutOfMemory { bytes } => write!(f, "no memory for a table of {bytes} bytes"),
        }
    }
}

impl core::error::Error for BuildError {}

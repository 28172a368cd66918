//! [`Footprint`]: what a structure takes in memory, as a formula and as a count.
use core::fmt;

/// Knows its memory.
pub trait Footprint {
    /// Bytes for each kind of element: what [`heap_bytes`](Self::heap_bytes) equals for every mesh.
    const BYTES: Bytes;

    /// Bytes of topology on the heap. Positions and other attributes are not topology.
    fn heap_bytes(&self) -> usize;
}

/// Coefficients of a memory formula, linear in the numbers of elements.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Bytes {
    /// Whatever the mesh.
    pub constant: usize,
    /// For each vertex.
    pub vertex: usize,
    /// For each edge.
    pub edge: usize,
    /// For each face.
    pub face: usize,
    /// For each boundary curve.
    pub curve: usize,
    /// For each word of the records of edges that no two half-edges share as opposites: for each such edge,
    /// one and its half-edges.
    pub edge_record: usize,
    /// For each word of the records of vertices of several fans: for each such vertex, one and its fans.
    pub vertex_record: usize,
    /// For each vertex that is left without a face where as many vertices as can be have one each of which they are
    /// a corner, and no two the same. Isolated vertices do not count.
    pub unmatched: usize,
}

/// Numbers of elements that [`Bytes`] is linear in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Counts {
    /// Vertices, isolated ones included.
    pub vertices: usize,
    /// Undirected edges.
    pub edges: usize,
    /// Faces.
    pub faces: usize,
    /// Boundary curves.
    pub curves: usize,
    /// Words in records of edges.
    pub edge_record_words: usize,
    /// Words in records of vertices.
    pub vertex_record_words: usize,
    /// Vertices, but for isolated ones, without a face of their own: see [`Bytes::unmatched`].
    pub unmatched: usize,
}

impl Bytes {
    /// No byte for anything: what a formula begins with.
    pub const NONE: Self = Self {
        constant: 0,
        vertex: 0,
        edge: 0,
        face: 0,
        curve: 0,
        edge_record: 0,
        vertex_record: 0,
        unmatched: 0,
    };

    /// Bytes for a mesh with these counts.
    pub const fn of(&self, n: &Counts) -> usize {
        self.constant
            + self.vertex * n.vertices
            + self.edge * n.edges
            + self.face * n.faces
            + self.curve * n.curves
            + self.edge_record * n.edge_record_words
            + self.vertex_record * n.vertex_record_words
            + self.unmatched * n.unmatched
    }

    /// Bytes a triangle on a large closed manifold, where there are half as many vertices as faces and one and
    /// a half times as many edges.
    pub const fn per_triangle(&self) -> usize {
        (2 * self.face + self.vertex + 3 * self.edge) / 2
    }
}

/// The formula, in V, E, T (faces), B (boundary curves), the words of records, and unmatched vertices.
impl fmt::Display for Bytes {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let terms = [
            (self.face, " T"),
            (self.vertex, " V"),
            (self.edge, " E"),
            (self.curve, " B"),
            (self.edge_record, " edge records"),
            (self.vertex_record, " vertex records"),
            (self.unmatched, " unmatched vertices"),
            (self.constant, ""),
        ];
        let mut plus = "";
        for (bytes, of) in terms.into_iter().filter(|&(bytes, _)| bytes > 0) {
            write!(f, "{plus}{bytes}{of}")?;
            plus = " + ";
        }
        Ok(())
    }
}

//! [`Topology`]: what every backend answers.
use crate::{Handle, corner, handle::Handles};
use alloc::vec::Vec;

/// Triangles over vertices: what every backend answers.
///
/// A half-edge is one side of one face, so there are three for each face, and a boundary edge has one.
/// Faces are counter-clockwise. Required methods are O(1), but for `origin` of a sorted opposite table, a walk around
/// the vertex; and `next`, `prev` and `face` of compact stars look through the ring of a neighbour, O(degree).
///
/// The provided `next`, `prev`, `face` and `first` number half-edges by corners (`3f + k`). A backend that
/// numbers them otherwise overrides all of them, with `half_edges` and `half_edge_bound`; a caller may assume
/// nothing about the indices behind handles but that they are below the count or bound.
///
/// Methods panic for a handle that is out of range.
pub trait Topology {
    /// Names a vertex.
    type Vertex: Handle;
    /// Names a half-edge.
    type HalfEdge: Handle;
    /// Names a face.
    type Face: Handle;

    /// Number of vertices, isolated ones included. Vertex handles have the indices below it.
    fn vertex_count(&self) -> usize;

    /// Number of triangles. Face handles have the indices below it.
    fn face_count(&self) -> usize;

    /// The vertex that `h` starts at.
    fn origin(&self, h: Self::HalfEdge) -> Self::Vertex;

    /// The vertex that `h` ends at.
    #[inline(always)]
    fn target(&self, h: Self::HalfEdge) -> Self::Vertex {
        self.origin(self.next(h))
    }

    /// The half-edge after `h` in its face.
    #[inline(always)]
    fn next(&self, h: Self::HalfEdge) -> Self::HalfEdge {
        corner::next(h)
    }

    /// The half-edge before `h` in its face.
    #[inline(always)]
    fn prev(&self, h: Self::HalfEdge) -> Self::HalfEdge {
        corner::prev(h)
    }

    /// The face of `h`.
    #[inline(always)]
    fn face(&self, h: Self::HalfEdge) -> Self::Face {
        corner::face(h)
    }

    /// The first half-edge of `f`: the one that starts at its first vertex.
    #[inline(always)]
    fn first(&self, f: Self::Face) -> Self::HalfEdge {
        corner::first(f)
    }

    /// The half-edges of `f`, counter-clockwise.
    #[inline]
    fn face_half_edges(&self, f: Self::Face) -> [Self::HalfEdge; 3] {
        let h = self.first(f);
        [h, self.next(h), self.prev(h)]
    }

    /// The vertices of `f`, counter-clockwise.
    #[inline]
    fn face_vertices(&self, f: Self::Face) -> [Self::Vertex; 3] {
        self.face_half_edges(f).map(|h| self.origin(h))
    }

    /// Number of half-edges: three for each face.
    fn half_edge_count(&self) -> usize {
        3 * self.face_count()
    }

    /// One more than the largest index of a half-edge: the size of a [`Map`](crate::Map) over half-edges.
    /// Not less than [`half_edge_count`](Self::half_edge_count), and more where handles have gaps.
    fn half_edge_bound(&self) -> usize {
        self.half_edge_count()
    }

    /// Every vertex.
    fn vertices(&self) -> Handles<Self::Vertex> {
        Handles::below(self.vertex_count())
    }

    /// Every half-edge.
    fn half_edges(&self) -> impl Iterator<Item = Self::HalfEdge> {
        (0..self.half_edge_bound()).map(Self::HalfEdge::new)
    }

    /// Every face.
    fn faces(&self) -> Handles<Self::Face> {
        Handles::below(self.face_count())
    }

    /// The faces as three vertex indices each, as [`FromFaces`](crate::FromFaces) takes them. O(faces).
    fn to_faces(&self) -> Vec<[u32; 3]> {
        self.faces().map(|f| self.face_vertices(f).map(|v| v.index() as u32)).collect()
    }
}

//! [`Adjacency`]: what lies across an edge.
use crate::Topology;

/// Knows what lies across an edge (Compact Half-Edge level 1 and up).
///
/// ```compile_fail,E0277
/// # use onering_core::*;
/// struct Soup;
/// impl Topology for Soup {
///     type Vertex = VertexId;
///     type HalfEdge = HalfEdgeId;
///     type Face = FaceId;
///     fn vertex_count(&self) -> usize { 3 }
///     fn face_count(&self) -> usize { 1 }
///     fn origin(&self, h: HalfEdgeId) -> VertexId { VertexId::new(h.index()) }
/// }
/// fn boundary_length(mesh: &impl Adjacency) -> usize {
///     mesh.half_edges().filter(|&h| mesh.is_boundary(h)).count()
/// }
/// boundary_length(&Soup); // the error names `WithOpposites::new(mesh)` and the backends that have it
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not know what lies across an edge",
    label = "this mesh has no `opposite`",
    note = "wrap it in `WithOpposites::new(mesh)`, or choose a backend with an `opposite` column, such as `CheL1` or `DirectedEdgesSmall`",
    note = "for `onering::Mesh`, turn on the feature `adjacency` or a preset that has it, such as `che-l1`"
)]
pub trait Adjacency: Topology {
    /// The half-edge that runs the other way along the same edge, where the edge has exactly two and they run
    /// in opposite directions; `None` on the boundary, at an edge of three or more faces, and across an edge
    /// whose two faces run along it in the same direction. O(1), but for compact stars, where it is a look at the ring
    /// of the target.
    fn opposite(&self, h: Self::HalfEdge) -> Option<Self::HalfEdge>;

    /// Every half-edge along the edge of `h`, in either direction, each once: `h` first, then the others in
    /// ascending order, so the least of an edge is among the first two.
    #[inline]
    fn edge_fan(&self, h: Self::HalfEdge) -> impl Iterator<Item = Self::HalfEdge> {
        core::iter::once(h).chain(self.opposite(h))
    }

    /// Whether no other face lies along the edge of `h`. Not the same as `opposite(h)` being `None`, which is
    /// so at an edge of three or more faces as well.
    #[inline(always)]
    fn is_boundary(&self, h: Self::HalfEdge) -> bool {
        self.opposite(h).is_none()
    }

    /// The next half-edge out of the same vertex, counter-clockwise; `None` where `opposite` ends the turn.
    #[inline(always)]
    fn rotate_ccw(&self, h: Self::HalfEdge) -> Option<Self::HalfEdge> {
        self.opposite(self.prev(h))
    }

    /// One step of a counter-clockwise turn: the vertex between `h` and the next half-edge out of the same vertex,
    /// which is the third of the face of `h`, and that half-edge, as [`rotate_ccw`](Self::rotate_ccw) gives it.
    #[inline(always)]
    fn turn(&self, h: Self::HalfEdge) -> (Self::Vertex, Option<Self::HalfEdge>) {
        let p = self.prev(h);
        (self.origin(p), self.opposite(p))
    }

    /// The next half-edge out of the same vertex, clockwise; `None` where `opposite` ends the turn.
    #[inline(always)]
    fn rotate_cw(&self, h: Self::HalfEdge) -> Option<Self::HalfEdge> {
        self.opposite(h).map(|o| self.next(o))
    }
}

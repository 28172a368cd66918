//! [`EdgeMap`]: names for undirected edges.
use crate::{Adjacency, Handle, handle::Handles};

/// Names undirected edges (Compact Half-Edge level 2).
///
/// All half-edges of an [`edge_fan`](Adjacency::edge_fan) lie along one edge.
///
/// ```compile_fail,E0277
/// # use onering_core::*;
/// fn labels(mesh: &impl EdgeMap) -> Vec<bool> {
///     vec![false; mesh.edge_count()]
/// }
/// fn label(mesh: &impl Adjacency) {
///     labels(mesh); // the error names what computes edges, and the backends that keep them
/// }
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no names for edges",
    label = "this mesh has no edge map",
    note = "compute one with `edges::edge_map(&mesh)`, or choose a backend that keeps one, such as `CheL2`, `CheL2EdgeTable` or `WingedEdge`",
    note = "for `onering::Mesh`, turn on the feature `edge-map` or a preset that has it, such as `che-l2`"
)]
pub trait EdgeMap: Adjacency {
    /// Names an edge.
    type Edge: Handle;

    /// Number of edges. Edge handles have the indices below it.
    fn edge_count(&self) -> usize;

    /// The edge that `h` lies along. O(1), but O(log edges) where edges are kept as a sorted list (CHE level 2).
    fn edge(&self, h: Self::HalfEdge) -> Self::Edge;

    /// One half-edge along `e`. O(1).
    fn half_edge(&self, e: Self::Edge) -> Self::HalfEdge;

    /// Every edge.
    fn edges(&self) -> Handles<Self::Edge> {
        Handles::below(self.edge_count())
    }

    /// The two ends of `e`, in the direction of [`half_edge`](Self::half_edge).
    #[inline]
    fn edge_vertices(&self, e: Self::Edge) -> [Self::Vertex; 2] {
        let h = self.half_edge(e);
        [self.origin(h), self.target(h)]
    }
}

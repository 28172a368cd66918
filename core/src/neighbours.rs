//! [`Neighbours`]: a graph of vertices, whether there are faces or not.
use crate::{Handle, Incidence, Topology};

/// Knows the neighbours of each vertex: every [`Incidence`], and the bare vertex graph of TopTri
/// (Figueiredo et al. 2014), which has no faces.
///
/// It is not among the names at the root of the crate, because a mesh has its `neighbours` from `Incidence`:
/// only an algorithm that serves graphs as well names this trait.
#[diagnostic::on_unimplemented(
    message = "`{Self}` does not know the neighbours of a vertex",
    label = "neither a mesh that can start from a vertex nor a graph",
    note = "wrap a mesh in `WithOutgoing::new(mesh)` (or `Searched::new(mesh)`), choose a backend with an `outgoing` column, such as `CheL2` or `DirectedEdgesSmall`, or the graph `VertexGraph`"
)]
pub trait Neighbours {
    /// Names a vertex.
    type Node: Handle;

    /// Number of vertices.
    fn node_count(&self) -> usize;

    /// All neighbours of `v`, each once, in no order that a caller may rely on.
    fn neighbours(&self, v: Self::Node) -> impl Iterator<Item = Self::Node>;
}

impl<T: Incidence> Neighbours for T {
    type Node = T::Vertex;

    fn node_count(&self) -> usize {
        Topology::vertex_count(self)
    }

    #[inline]
    fn neighbours(&self, v: T::Vertex) -> impl Iterator<Item = T::Vertex> {
        Incidence::neighbours(self, v)
    }
}

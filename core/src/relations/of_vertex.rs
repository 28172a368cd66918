//! What is around a vertex.
use crate::{Incidence, neighbours::Neighbours, ring};

/// V -> V: the vertices that share an edge with `v`.
///
/// # Arguments
/// `mesh`, which may be a bare graph, and a vertex of it.
///
/// # Returns
/// The neighbours of `v`, each once. On a mesh, those of [`Incidence::neighbours`].
///
/// # Complexity
/// O(d) for d faces at `v`: d + 1 steps on one fan, 4 d where fans are several.
///
/// # Panics
/// Where `v` is out of range.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, Topology, VertexId, relations};
/// let mesh = Mesh::from_faces(5, &[[0, 1, 2], [2, 1, 3], [2, 3, 4]])?;
/// let around = relations::vertex_vertices(&mesh, VertexId::new(2)).map(Handle::index);
/// let mut around: Vec<usize> = around.collect();
/// around.sort();
/// assert_eq!(around, [0, 1, 3, 4]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Woo (1985), by Emme (2012), section 2.2; `vGetAdjacentVertices` of Figueiredo et al. (2014), Table 1.
#[inline]
pub fn vertex_vertices<G: Neighbours + ?Sized>(mesh: &G, v: G::Node) -> impl Iterator<Item = G::Node> {
    mesh.neighbours(v)
}

/// V -> E: the edges that end at `v`.
///
/// # Arguments
/// `mesh`, and a vertex of it.
///
/// # Returns
/// The edges at `v`, each once, named as [`edge`](crate::relations::edge) does: out of `v` or into it.
///
/// # Complexity
/// O(d) for d faces at `v`: 3 d steps.
///
/// # Panics
/// Where `v` is out of range.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, Topology, VertexId, relations};
/// let mesh = Mesh::from_faces(5, &[[0, 1, 2], [2, 1, 3], [2, 3, 4]])?;
/// assert_eq!(relations::vertex_edges(&mesh, VertexId::new(2)).count(), 4);
/// assert_eq!(relations::vertex_edges(&mesh, VertexId::new(0)).count(), 2);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Woo (1985), by Emme (2012), section 2.2; `vGetIncidentEdges` of Figueiredo et al. (2014), Table 1.
#[inline]
pub fn vertex_edges<M: Incidence + ?Sized>(mesh: &M, v: M::Vertex) -> impl Iterator<Item = M::HalfEdge> {
    ring::each_edge_once(mesh, v)
}

/// V -> F: the faces with the corner `v`.
///
/// # Arguments
/// `mesh`, and a vertex of it.
///
/// # Returns
/// The faces of the [`star`](Incidence::star) of `v`, fan after fan, each counter-clockwise.
///
/// # Complexity
/// O(d) for d faces at `v`: d steps.
///
/// # Panics
/// Where `v` is out of range.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, Topology, VertexId, relations};
/// let mesh = Mesh::from_faces(5, &[[0, 1, 2], [2, 1, 3], [2, 3, 4]])?;
/// let faces = relations::vertex_faces(&mesh, VertexId::new(3)).map(Handle::index);
/// assert_eq!(faces.sum::<usize>(), 1 + 2);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Woo (1985), by Emme (2012), section 2.2; `vGetIncidentFaces` of Figueiredo et al. (2014), Table 1.
#[inline]
pub fn vertex_faces<M: Incidence + ?Sized>(mesh: &M, v: M::Vertex) -> impl Iterator<Item = M::Face> {
    mesh.star(v).map(|h| mesh.face(h))
}

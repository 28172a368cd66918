//! Stars and links: the faces around a vertex or an edge, and what closes them off from the rest of the mesh.
//!
//! The star of a vertex as half-edges is [`Incidence::star`], that of an edge [`Adjacency::edge_fan`].
use crate::{Adjacency, Incidence};

/// The link of vertex `v` as half-edges: in each face of its [`star`](Incidence::star) the one that does not
/// touch `v`, face on the left, fan after fan, each counter-clockwise. O(degree).
///
/// On a closed manifold this is one cycle around `v`, at a boundary one path.
///
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, Topology, VertexId, star};
/// let mesh = Mesh::from_faces(4, &[[0, 1, 2], [0, 2, 3], [0, 3, 1]])?;
/// let around = star::link(&mesh, VertexId::new(0)).map(|h| [mesh.origin(h), mesh.target(h)]);
/// assert_eq!(format!("{:?}", around.collect::<Vec<_>>()), "[[v1, v2], [v2, v3], [v3, v1]]");
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn link<M: Incidence + ?Sized>(mesh: &M, v: M::Vertex) -> impl Iterator<Item = M::HalfEdge> {
    mesh.star(v).map(|h| mesh.next(h))
}

/// The vertices of the link of vertex `v`, each once: in a mesh of triangles, all its
/// [`neighbours`](Incidence::neighbours). O(degree).
///
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, VertexId, star};
/// let mesh = Mesh::from_faces(4, &[[0, 1, 2], [0, 2, 3]])?;
/// assert_eq!(star::link_vertices(&mesh, VertexId::new(0)).count(), 3);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn link_vertices<M: Incidence + ?Sized>(mesh: &M, v: M::Vertex) -> impl Iterator<Item = M::Vertex> {
    mesh.neighbours(v)
}

/// The link of the edge of `h`: in each face along it the vertex that is not on it, that of `h` first. Two on
/// the inside of a manifold and one on its boundary. A vertex comes twice where two faces have the same three
/// vertices. O(faces along the edge).
///
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, Handle, HalfEdgeId, star};
/// let mesh = Mesh::from_faces(4, &[[0, 1, 2], [2, 1, 3]])?;
/// let across = star::edge_link(&mesh, HalfEdgeId::new(1));
/// assert_eq!(format!("{:?}", across.collect::<Vec<_>>()), "[v0, v3]");
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn edge_link<M: Adjacency + ?Sized>(mesh: &M, h: M::HalfEdge) -> impl Iterator<Item = M::Vertex> {
    mesh.edge_fan(h).map(|g| mesh.origin(mesh.prev(g)))
}

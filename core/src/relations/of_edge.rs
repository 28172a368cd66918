//! What is around an edge.
use super::vertex_edges;
use crate::{Adjacency, Incidence, Topology};

/// The name of the edge that `h` lies along: its least half-edge.
///
/// # Arguments
/// `mesh`, and any half-edge of it along the edge.
///
/// # Returns
/// The least half-edge of the [`edge_fan`](Adjacency::edge_fan): the same for all half-edges along one edge.
///
/// # Complexity
/// O(1): the others in a fan are ascending.
///
/// # Panics
/// Where `h` is out of range.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, Topology, HalfEdgeId, relations};
/// let mesh = Mesh::from_faces(5, &[[0, 1, 2], [2, 1, 3], [2, 3, 4]])?;
/// let [a, b] = [1, 3].map(HalfEdgeId::new); // from 1 to 2, and from 2 to 1
/// assert_eq!((relations::edge(&mesh, a), relations::edge(&mesh, b)), (a, a));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// As [`edges::each`](crate::edges::each) names edges.
#[inline]
pub fn edge<M: Adjacency + ?Sized>(mesh: &M, h: M::HalfEdge) -> M::HalfEdge {
    mesh.edge_fan(h).nth(1).map_or(h, |least_other| h.min(least_other))
}

/// E -> V: the two ends of the edge of `h`.
///
/// # Arguments
/// `mesh`, and any half-edge of it along the edge.
///
/// # Returns
/// The origin and the target of `h`.
///
/// # Complexity
/// O(1): two steps.
///
/// # Panics
/// Where `h` is out of range.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, Topology, HalfEdgeId, relations};
/// let mesh = Mesh::from_faces(5, &[[0, 1, 2], [2, 1, 3], [2, 3, 4]])?;
/// let ends = relations::edge_vertices(&mesh, HalfEdgeId::new(1)).map(Handle::index);
/// assert_eq!(ends, [1, 2]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Woo (1985), by Emme (2012), section 2.2; in TopTri the two ends are the name of an edge.
#[inline]
pub fn edge_vertices<M: Topology + ?Sized>(mesh: &M, h: M::HalfEdge) -> [M::Vertex; 2] {
    [mesh.origin(h), mesh.target(h)]
}

/// E -> E: the edges that share an end with the edge of `h`.
///
/// # Arguments
/// `mesh`, and any half-edge of it along the edge.
///
/// # Returns
/// The other edges at the two ends, each once, named as [`edge`] does: those at the origin of `h` first.
///
/// # Complexity
/// O(d + d') for the faces at the two ends: 3 (d + d') steps.
///
/// # Panics
/// Where `h` is out of range.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, Topology, HalfEdgeId, relations};
/// let mesh = Mesh::from_faces(5, &[[0, 1, 2], [2, 1, 3], [2, 3, 4]])?;
/// assert_eq!(relations::edge_edges(&mesh, HalfEdgeId::new(1)).count(), 2 + 3);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Woo (1985), by Emme (2012), section 2.2; `eGetAdjacentEdges` of Figueiredo et al. (2014), Table 1.
#[inline]
pub fn edge_edges<M: Incidence + ?Sized>(mesh: &M, h: M::HalfEdge) -> impl Iterator<Item = M::HalfEdge> {
    let [origin, target] = edge_vertices(mesh, h);
    let asked = edge(mesh, h);
    // The edge from a vertex to itself, of a degenerate face, has one end.
    let further = (target != origin).then_some(target);
    let at_ends = vertex_edges(mesh, origin).chain(further.into_iter().flat_map(|v| vertex_edges(mesh, v)));
    at_ends.filter(move |&e| e != asked)
}

/// E -> F: the faces along the edge of `h`.
///
/// # Arguments
/// `mesh`, and any half-edge of it along the edge.
///
/// # Returns
/// That of `h` first: one on the boundary, two on the inside of a manifold, any number elsewhere.
///
/// # Complexity
/// O(k) for k faces along the edge: k steps.
///
/// # Panics
/// Where `h` is out of range.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, Topology, HalfEdgeId, relations};
/// let mesh = Mesh::from_faces(5, &[[0, 1, 2], [2, 1, 3], [2, 3, 4]])?;
/// let faces = relations::edge_faces(&mesh, HalfEdgeId::new(1)).map(Handle::index);
/// assert_eq!(faces.collect::<Vec<_>>(), [0, 1]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Woo (1985), by Emme (2012), section 2.2; `eGetIncidentFaces` of Figueiredo et al. (2014), Table 1.
#[inline]
pub fn edge_faces<M: Adjacency + ?Sized>(mesh: &M, h: M::HalfEdge) -> impl Iterator<Item = M::Face> {
    mesh.edge_fan(h).map(|g| mesh.face(g))
}

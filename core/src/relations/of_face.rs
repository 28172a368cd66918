//! What is around a face.
use super::edge;
use crate::{Adjacency, Topology};

/// F -> V: the vertices of face `f`.
///
/// # Arguments
/// `mesh`, and a face of it.
///
/// # Returns
/// Its three corners, counter-clockwise: [`Topology::face_vertices`].
///
/// # Complexity
/// O(1): three steps.
///
/// # Panics
/// Where `f` is out of range.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, Topology, FaceId, relations};
/// let mesh = Mesh::from_faces(5, &[[0, 1, 2], [2, 1, 3], [2, 3, 4]])?;
/// let corners = relations::face_vertices(&mesh, FaceId::new(1)).map(Handle::index);
/// assert_eq!(corners, [2, 1, 3]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Woo (1985), by Emme (2012), section 2.2; in TopTri the three are the name of a face.
#[inline]
pub fn face_vertices<M: Topology + ?Sized>(mesh: &M, f: M::Face) -> [M::Vertex; 3] {
    mesh.face_vertices(f)
}

/// F -> E: the edges of face `f`.
///
/// # Arguments
/// `mesh`, and a face of it.
///
/// # Returns
/// Its three sides, counter-clockwise, each named as [`edge`](crate::relations::edge) does.
///
/// # Complexity
/// O(1): three steps.
///
/// # Panics
/// Where `f` is out of range.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, Topology, FaceId, relations};
/// let mesh = Mesh::from_faces(5, &[[0, 1, 2], [2, 1, 3], [2, 3, 4]])?;
/// let sides = relations::face_edges(&mesh, FaceId::new(1)).map(Handle::index);
/// assert_eq!(sides, [1, 4, 5]); // the first is a side of face 0 as well
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Woo (1985), by Emme (2012), section 2.2.
#[inline]
pub fn face_edges<M: Adjacency + ?Sized>(mesh: &M, f: M::Face) -> [M::HalfEdge; 3] {
    mesh.face_half_edges(f).map(|h| edge(mesh, h))
}

/// F -> F: the faces across the edges of face `f`.
///
/// # Arguments
/// `mesh`, and a face of it.
///
/// # Returns
/// All other faces along its three edges, side after side, each once: a face with the same three vertices comes with the
/// first side.
///
/// # Complexity
/// O(k + k' + k'') for the faces along its three edges, `f` itself included.
///
/// # Panics
/// Where `f` is out of range.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, Topology, FaceId, relations};
/// let mesh = Mesh::from_faces(5, &[[0, 1, 2], [2, 1, 3], [2, 3, 4]])?;
/// let across = relations::face_faces(&mesh, FaceId::new(1)).map(Handle::index);
/// assert_eq!(across.collect::<Vec<_>>(), [0, 2]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Woo (1985), by Emme (2012), section 2.2; `fGetAdjacentFaces` of Figueiredo et al. (2014), Table 1.
#[inline]
pub fn face_faces<M: Adjacency + ?Sized>(mesh: &M, f: M::Face) -> impl Iterator<Item = M::Face> {
    let apex = |h| mesh.origin(mesh.prev(h));
    let across = move |(side, h): (usize, M::HalfEdge)| {
        // Who shares two edges with `f` has its third vertex too, and came with the first side.
        mesh.edge_fan(h).skip(1).filter(move |&g| side == 0 || apex(g) != apex(h))
    };
    let others = mesh.face_half_edges(f).into_iter().enumerate().flat_map(across);
    others.map(|g| mesh.face(g)).filter(move |&g| g != f)
}

//! The dual graph: faces as nodes, joined across edges.
use crate::{Adjacency, Topology, neighbours::Neighbours};

/// The dual graph of a mesh: its nodes are the faces, and two are neighbours where they share an edge.
///
/// It holds nothing but a reference, and each answer is found anew from the mesh. What asks for [`Neighbours`] runs on
/// faces by it: [`k_ring`](crate::k_ring) gives faces by their distance, [`degrees`](crate::degrees) counts
/// neighbours, [`reorder::breadth_first`](crate::reorder::breadth_first) puts faces in order.
///
/// All faces of an edge are neighbours of one another, in whatever direction they run and however many they are. Two faces that
/// share two edges or three are neighbours once, told at the first of those edges in the face that is asked. No face
/// is its own neighbour. Faces that meet in a vertex only are none.
///
/// # Complexity
/// `neighbours` is O(faces along the three edges).
///
/// # Example
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FaceId, FromFaces, Handle, dual::Dual, k_ring};
/// let strip = Mesh::from_faces(6, &[[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]])?;
/// let ring = k_ring::k_ring(&Dual::new(&strip), FaceId::new(0), 2);
/// assert_eq!((ring.level(1), ring.level(2)), (&[FaceId::new(1)][..], &[FaceId::new(2)][..]));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Standard (Poincaré duality).
#[derive(Debug)]
pub struct Dual<'a, M: ?Sized> {
    mesh: &'a M,
}

impl<'a, M: Adjacency + ?Sized> Dual<'a, M> {
    /// The dual graph of `mesh`.
    pub fn new(mesh: &'a M) -> Self {
        Self { mesh }
    }
}

impl<M: ?Sized> Clone for Dual<'_, M> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<M: ?Sized> Copy for Dual<'_, M> {}

impl<M: Adjacency + ?Sized> Neighbours for Dual<'_, M> {
    type Node = M::Face;

    fn node_count(&self) -> usize {
        self.mesh.face_count()
    }

    #[inline]
    fn neighbours(&self, f: M::Face) -> impl Iterator<Item = M::Face> {
        let mesh = self.mesh;
        let sides = mesh.face_half_edges(f);
        sides.into_iter().flat_map(move |h| {
            mesh.edge_fan(h).skip(1).filter(move |&g| is_first(mesh, sides, h, g)).map(move |g| mesh.face(g))
        })
    }
}

/// Whether `h` is the first of the `sides` of its face that lies along an edge of the face of `g`, `g` is that face's
/// first half-edge there, and the face another one.
#[inline]
fn is_first<M: Topology + ?Sized>(mesh: &M, sides: [M::HalfEdge; 3], h: M::HalfEdge, g: M::HalfEdge) -> bool {
    let f = mesh.face(g);
    let along = |side| mesh.face_half_edges(f).into_iter().find(|&k| is_parallel(mesh, side, k));
    f != mesh.face(h)
        && along(h) == Some(g)
        && sides.into_iter().take_while(|&side| side != h).all(|side| along(side).is_none())
}

/// Whether two half-edges lie along the same edge. A side of a degenerate face that returns to its own vertex lies along
/// none.
#[inline]
fn is_parallel<M: Topology + ?Sized>(mesh: &M, h: M::HalfEdge, g: M::HalfEdge) -> bool {
    let [a, b, c, d] = [mesh.origin(h), mesh.target(h), mesh.origin(g), mesh.target(g)];
    a != b && ((a, b) == (c, d) || (a, b) == (d, c))
}

//! Vertices and faces in an order that keeps neighbours together in memory.
//!
//! On a mesh larger than the cache, order matters more than structure: a sweep over all one-rings takes many times as
//! long where neighbours lie anywhere. An order of the vertices comes from positions ([`hilbert`], [`morton`]) or from
//! the graph ([`breadth_first`], [`cuthill_mckee`]); [`reorder`] renumbers the mesh by it.
//!
//! ```
//! # use onering::{CheL0, CheL2};
//! use onering_core::{FromFaces, reorder};
//! let mesh = CheL0::from_faces(4, &[[3, 1, 0], [0, 2, 3]])?;
//! let positions = vec![[0.0, 0.0, 0.0], [9.0, 0.0, 0.0], [0.0, 1.0, 0.0], [9.0, 1.0, 0.0]];
//! let order = reorder::hilbert(&positions.clone().into())?;
//! let reordered = reorder::reorder(&mesh, &order);
//! assert_eq!(reordered.vertex_source, [0, 2, 3, 1]);
//! assert_eq!(reordered.faces, [[2, 3, 0], [0, 1, 2]]);
//! let positions = reordered.carry_vertices(&positions);
//! let mesh = CheL2::from_face_vec(4, reordered.faces)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
use crate::{Handle, Map, Topology};
use alloc::{vec, vec::Vec};

mod curve;
mod graph;
mod radix;

pub use curve::{hilbert, morton};
pub use graph::{breadth_first, cuthill_mckee, reverse_cuthill_mckee, try_cuthill_mckee};

/// A mesh in another order, and the maps back: what [`reorder`] gives.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Reordering {
    /// The faces in their new order, over the new numbers of the vertices. Each starts with the corner with which it
    /// did.
    pub faces: Vec<[u32; 3]>,
    /// For each face the one of the mesh that it was.
    pub face_source: Vec<u32>,
    /// For each vertex the one of the mesh that it was.
    pub vertex_source: Vec<u32>,
    /// For each vertex of the mesh the one that it is now.
    pub vertex_target: Vec<u32>,
}

impl Reordering {
    /// The values of the mesh's vertices (positions, colours, ...) in the new order. O(vertices).
    ///
    /// # Panics
    /// If `values` has fewer than the mesh has vertices.
    pub fn carry_vertices<T: Clone>(&self, values: &[T]) -> Vec<T> {
        self.vertex_source.iter().map(|&v| values[v as usize].clone()).collect()
    }

    /// The values of the mesh's faces in the new order. O(faces).
    ///
    /// # Panics
    /// If `values` has fewer than the mesh has faces.
    pub fn carry_faces<T: Clone>(&self, values: &[T]) -> Vec<T> {
        self.face_source.iter().map(|&f| values[f as usize].clone()).collect()
    }
}

/// Renumbers the vertices of a mesh, and sorts its faces by them.
///
/// # Arguments
/// Any mesh, and all its vertices, each once, in the order that they shall have.
///
/// # Returns
/// The faces in the order of their least new vertices, those of the same in the order that they had; and the maps. It
/// is the same mesh: nothing but numbers and order changes.
///
/// # Complexity
/// O(vertices + faces), by counting; 4 bytes of scratch for each vertex and 12 for each face.
///
/// # Panics
/// If `order` is no permutation of the vertices.
///
/// # Example
/// See the [module](self).
///
/// # Source
/// Standard.
pub fn reorder<M: Topology + ?Sized>(mesh: &M, order: &[M::Vertex]) -> Reordering {
    let target = positions_in(order, mesh.vertex_count());
    // Once: on a shuffled mesh each new number is a cache miss.
    let renumbered: Vec<[u32; 3]> = mesh.faces().map(|f| mesh.face_vertices(f).map(|v| target[v])).collect();
    let least = |&[a, b, c]: &[u32; 3]| a.min(b).min(c) as usize;
    // Where the faces of each least vertex begin, and then where the next of them goes.
    let mut starts = vec![0_u32; mesh.vertex_count() + 1];
    renumbered.iter().for_each(|face| starts[least(face) + 1] += 1);
    (1..starts.len()).for_each(|v| starts[v] += starts[v - 1]);
    let mut faces = vec![[0; 3]; mesh.face_count()];
    let mut face_source = vec![0; mesh.face_count()];
    for (f, face) in mesh.faces().zip(&renumbered) {
        let at = &mut starts[least(face)];
        faces[*at as usize] = *face;
        face_source[*at as usize] = f.index() as u32;
        *at += 1;
    }
    Reordering { faces, face_source, vertex_source: sources(order), vertex_target: target.into_vec() }
}

/// Renumbers the vertices and the faces of a mesh, each as it is told to.
///
/// # Arguments
/// Any mesh; all its vertices, and all its faces, each once, in the order that they shall have: that of
/// [`breadth_first`] over the [`Dual`](crate::dual::Dual) graph, for one.
///
/// # Returns
/// The faces and the maps.
///
/// # Complexity
/// O(vertices + faces).
///
/// # Panics
/// If `vertices` or `faces` is no permutation.
///
/// # Example
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, Topology, dual::Dual, reorder};
/// let mesh = Mesh::from_faces(6, &[[0, 1, 2], [4, 3, 5], [2, 1, 3], [2, 3, 4]])?;
/// let faces = reorder::breadth_first(&Dual::new(&mesh));
/// let vertices: Vec<_> = mesh.vertices().collect();
/// assert_eq!(reorder::reorder_both(&mesh, &vertices, &faces).face_source, [0, 2, 3, 1]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Standard.
pub fn reorder_both<M: Topology + ?Sized>(mesh: &M, vertices: &[M::Vertex], faces: &[M::Face]) -> Reordering {
    let target = positions_in(vertices, mesh.vertex_count());
    positions_in(faces, mesh.face_count());
    Reordering {
        faces: faces.iter().map(|&f| mesh.face_vertices(f).map(|v| target[v])).collect(),
        face_source: sources(faces),
        vertex_source: sources(vertices),
        vertex_target: target.into_vec(),
    }
}

/// For each element its place in `order`, which has to have each once.
fn positions_in<H: Handle>(order: &[H], count: usize) -> Map<H, u32> {
    assert_eq!(order.len(), count, "an order has each element once");
    let mut place = Map::filled(count, u32::MAX);
    for (i, &h) in order.iter().enumerate() {
        assert_eq!(place[h], u32::MAX, "{h:?} is in the order twice");
        place[h] = i as u32;
    }
    place
}

fn sources<H: Handle>(order: &[H]) -> Vec<u32> {
    order.iter().map(|h| h.index() as u32).collect()
}

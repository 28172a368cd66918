//! A part of a mesh as a mesh of its own.
use crate::{Handle, Topology};
use alloc::{vec, vec::Vec};

/// Some faces of a mesh over the vertices that they name, and the maps back: what [`submesh`] gives.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Submesh {
    /// How many vertices the faces name.
    pub vertex_count: usize,
    /// The faces, in the order in which they were asked for, corners as they were.
    pub faces: Vec<[u32; 3]>,
    /// For each face the one of the mesh that it was.
    pub face_source: Vec<u32>,
    /// For each vertex the one of the mesh that it was; rising.
    pub vertex_source: Vec<u32>,
}

impl Submesh {
    /// The values of the mesh's vertices (positions, colours, ...) for those here. O(vertices here).
    ///
    /// # Panics
    /// If `values` has fewer than the mesh has vertices.
    pub fn carry_vertices<T: Clone>(&self, values: &[T]) -> Vec<T> {
        self.vertex_source.iter().map(|&v| values[v as usize].clone()).collect()
    }

    /// The values of the mesh's faces for those here. O(faces here).
    ///
    /// # Panics
    /// If `values` has fewer than the mesh has faces.
    pub fn carry_faces<T: Clone>(&self, values: &[T]) -> Vec<T> {
        self.face_source.iter().map(|&f| values[f as usize].clone()).collect()
    }
}

/// The mesh that these faces are by themselves.
///
/// # Arguments
/// Any mesh, and faces of it: `mesh.faces().filter(...)`, a region, a component. A face that comes twice is there twice.
///
/// # Returns
/// The faces over vertices numbered anew, in their old order and without those that no face names, and the maps back.
///
/// # Complexity
/// With k faces O(k log k), whatever the size of the mesh, 40 bytes of scratch for each of them; O(k + vertices) with 4
/// bytes for each vertex where the faces are so many that this is less.
///
/// # Panics
/// If a face is out of range.
///
/// # Example
/// ```
/// # use onering::CheL0 as Mesh;
/// use onering_core::{FromFaces, Topology, submesh};
/// let mesh = Mesh::from_faces(7, &[[0, 1, 2], [4, 5, 6], [6, 5, 3]])?;
/// let part = submesh::submesh(&mesh, mesh.faces().skip(1));
/// assert_eq!(part.faces, [[1, 2, 3], [3, 2, 0]]);
/// assert_eq!((part.vertex_source, part.face_source), (vec![3, 4, 5, 6], vec![1, 2]));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Standard.
pub fn submesh<M: Topology + ?Sized>(mesh: &M, faces: impl IntoIterator<Item = M::Face>) -> Submesh {
    let mut part = Submesh::default();
    for f in faces {
        part.face_source.push(f.index() as u32);
        part.faces.push(mesh.face_vertices(f).map(|v| v.index() as u32));
    }
    // A table costs a write and a read for each vertex of the mesh, sorting some steps for each corner.
    if mesh.vertex_count() / 16 < part.faces.len() {
        number_by_table(&mut part, mesh.vertex_count());
    } else {
        number_by_sorting(&mut part);
    }
    part.vertex_count = part.vertex_source.len();
    part
}

/// Numbers the vertices anew by a table over all of them.
fn number_by_table(part: &mut Submesh, vertex_count: usize) {
    let mut number = vec![u32::MAX; vertex_count];
    part.faces.as_flattened().iter().for_each(|&v| number[v as usize] = 0);
    for (v, number) in number.iter_mut().enumerate().filter(|(_, number)| **number == 0) {
        *number = part.vertex_source.len() as u32;
        part.vertex_source.push(v as u32);
    }
    part.faces.as_flattened_mut().iter_mut().for_each(|v| *v = number[*v as usize]);
}

/// Numbers the vertices anew in the order that sorting the corners by them gives.
fn number_by_sorting(part: &mut Submesh) {
    let corners = part.faces.as_flattened_mut();
    let mut by_vertex: Vec<(u32, usize)> = corners.iter().copied().zip(0..).collect();
    by_vertex.sort_unstable();
    for same in by_vertex.chunk_by(|a, b| a.0 == b.0) {
        same.iter().for_each(|&(_, corner)| corners[corner] = part.vertex_source.len() as u32);
        part.vertex_source.push(same[0].0);
    }
}

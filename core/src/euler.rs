//! The Euler characteristic, and what follows from it.
use crate::{Adjacency, boundary, components, edges, orientation, umbrella};

/// Vertices - edges + faces, isolated vertices left out and an edge counted once however many faces it has.
/// O(half-edges); one byte for each vertex.
///
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, euler};
/// let tetrahedron = Mesh::from_faces(4, &[[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])?;
/// assert_eq!(euler::euler_characteristic(&tetrahedron), 2);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn euler_characteristic<M: Adjacency + ?Sized>(mesh: &M) -> isize {
    let [v, e, f] = [umbrella::used_vertex_count(mesh), edges::edge_count(mesh), mesh.face_count()];
    v as isize - e as isize + f as isize
}

/// Whether the mesh has faces and no edge of one face only. Edges of three or more faces and any orientation
/// are allowed. O(half-edges).
///
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, euler};
/// let faces = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
/// assert!(euler::is_closed(&Mesh::from_faces(4, &faces)?));
/// assert!(!euler::is_closed(&Mesh::from_faces(4, &faces[..3])?));
/// assert!(!euler::is_closed(&Mesh::from_faces(4, &[])?));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn is_closed<M: Adjacency + ?Sized>(mesh: &M) -> bool {
    mesh.face_count() > 0 && !mesh.half_edges().any(|h| mesh.is_boundary(h))
}

/// The genus, summed over all components: `(2 components - boundary loops - Euler characteristic) / 2`, from
/// the classification of surfaces. `None` where a surface has none to speak of: without faces, where the mesh
/// is not [manifold](umbrella::is_manifold), or where it is not [orientable](orientation::is_orientable).
/// The faces need not agree in orientation as they are. Nearly linear; some 16 bytes at most for each half-edge.
///
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, euler};
/// // The torus of seven vertices (Moebius, Csaszar): every two are neighbours.
/// let torus: Vec<_> = (0..7).flat_map(|i| [[0, 1, 3], [0, 3, 2]].map(|f| f.map(|k| (i + k) % 7))).collect();
/// assert_eq!(euler::genus(&Mesh::from_faces(7, &torus)?), Some(1));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn genus<M: Adjacency + ?Sized>(mesh: &M) -> Option<usize> {
    if mesh.face_count() == 0 || !umbrella::is_manifold(mesh) || !orientation::is_orientable(mesh) {
        return None;
    }
    let components = components::components(mesh).count();
    genus_of(components, boundary::loops(mesh)?, euler_characteristic(mesh))
}

/// The genus of an orientable surface by its figures, from 2 - 2g = V - E + F + boundary loops, summed over the
/// components.
pub(crate) fn genus_of(components: usize, loops: usize, euler_characteristic: isize) -> Option<usize> {
    let twice = 2 * components as isize - loops as isize - euler_characteristic;
    usize::try_from(twice / 2).ok()
}

//! Whether faces agree in orientation, and whether they can be made to.
use crate::{Adjacency, Map, edges::across};
use alloc::vec::Vec;

/// Whether the faces agree as they are: every edge of exactly two faces is run along in both directions.
/// Edges of three or more faces are not asked. O(half-edges).
///
/// ```
/// # use onering::DirectedEdgesSmall as Mesh;
/// use onering_core::{FromFaces, orientation};
/// assert!(orientation::is_oriented(&Mesh::from_faces(4, &[[0, 1, 2], [2, 1, 3]])?));
/// assert!(!orientation::is_oriented(&Mesh::from_faces(4, &[[0, 1, 2], [1, 2, 3]])?));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn is_oriented<M: Adjacency + ?Sized>(mesh: &M) -> bool {
    mesh.half_edges().all(|h| mesh.opposite(h).is_some() || across(mesh, h).is_none())
}

/// Whether the faces agree or can be made to by turning some over: orientations are carried across edges of
/// exactly two faces only, so that three faces at an edge forbid nothing. O(half-edges); a mesh that is
/// oriented takes no scratch, another one 5 bytes at most for each face.
///
/// ```
/// # use onering::DirectedEdgesSmall as Mesh;
/// use onering_core::{FromFaces, orientation};
/// let moebius = [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 0], [4, 0, 1]];
/// assert!(!orientation::is_orientable(&Mesh::from_faces(5, &moebius)?));
/// assert!(orientation::is_orientable(&Mesh::from_faces(5, &moebius[..4])?));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn is_orientable<M: Adjacency + ?Sized>(mesh: &M) -> bool {
    is_oriented(mesh) || turned(mesh).is_some()
}

/// Which faces to turn over for the mesh to be [oriented](is_oriented), the first face of each patch staying
/// as it is; `None` where the mesh is not orientable. O(half-edges); 5 bytes at most for each face.
///
/// ```
/// # use onering::DirectedEdgesSmall as Mesh;
/// use onering_core::{FromFaces, orientation};
/// let mesh = Mesh::from_faces(4, &[[0, 1, 2], [1, 2, 3]])?;
/// assert_eq!(orientation::turned(&mesh).unwrap().as_slice(), [false, true]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn turned<M: Adjacency + ?Sized>(mesh: &M) -> Option<Map<M::Face, bool>> {
    let mut turned: Map<M::Face, Option<bool>> = Map::filled(mesh.face_count(), None);
    let mut reached = Vec::new();
    for first in mesh.faces() {
        if turned[first].is_none() {
            turned[first] = Some(false);
            reached.push(first);
        }
        while let Some(f) = reached.pop() {
            for h in mesh.face_half_edges(f) {
                let Some(g) = across(mesh, h) else { continue };
                let same_direction = mesh.origin(h) == mesh.origin(g);
                let wanted = turned[f].map(|t| t != same_direction);
                let found = &mut turned[mesh.face(g)];
                if found.is_none() {
                    *found = wanted;
                    reached.push(mesh.face(g));
                } else if *found != wanted {
                    return None;
                }
            }
        }
    }
    Some(turned.as_slice().iter().map(|&t| t == Some(true)).collect())
}

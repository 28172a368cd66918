//! Small meshes, and the shapes of what they are asked.
#[path = "../common/shapes.rs"]
mod shapes;

use onering::*;
pub(crate) use shapes::{Faces, MOEBIUS, TETRAHEDRON, grid, shuffled, wheel};

pub(crate) fn v(i: usize) -> VertexId {
    VertexId::new(i)
}

pub(crate) fn h(i: usize) -> HalfEdgeId {
    HalfEdgeId::new(i)
}

pub(crate) fn f(i: usize) -> FaceId {
    FaceId::new(i)
}

pub(crate) fn indices<H: Handle>(handles: impl Iterator<Item = H>) -> Vec<usize> {
    handles.map(Handle::index).collect()
}

pub(crate) fn sorted<H: Handle>(handles: impl Iterator<Item = H>) -> Vec<usize> {
    let mut all = indices(handles);
    all.sort_unstable();
    all
}

/// The Moebius band, with all pairs of faces in disagreement.
pub(crate) const MOEBIUS_TWISTED: [[u32; 3]; 5] = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]];

/// Two tetrahedra that share vertex 0.
pub(crate) fn two_tetrahedra() -> Faces {
    let second = TETRAHEDRON.map(|f| f.map(|v| if v == 0 { 0 } else { v + 3 }));
    [TETRAHEDRON, second].concat()
}

/// `n` faces along the edge 0-1, in turns of either direction.
pub(crate) fn book(n: u32) -> Faces {
    (0..n).map(|i| if i % 2 == 0 { [0, 1, i + 2] } else { [1, 0, i + 2] }).collect()
}

//! Meshes that every backend holds.
use crate::conformance::Case;
use alloc::{vec, vec::Vec};

/// The tetrahedron, with its first vertex on three of the faces.
pub(super) const TETRAHEDRON: [[u32; 3]; 4] = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];

const OCTAHEDRON: [[u32; 3]; 8] =
    [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1], [5, 2, 1], [5, 3, 2], [5, 4, 3], [5, 1, 4]];

const ANNULUS: [[u32; 3]; 6] = [[0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [2, 0, 3], [2, 3, 5]];

pub(super) fn cases() -> Vec<Case> {
    vec![
        Case::new("empty", 0, &[], 0, 0),
        Case::new("points only", 5, &[], 0, 0),
        Case::new("one triangle", 3, &[[0, 1, 2]], 3, 1),
        Case::new("one triangle, last vertex first", 3, &[[2, 1, 0]], 3, 1),
        Case::new("isolated vertex", 4, &[[0, 1, 3]], 3, 1),
        Case::new("isolated vertices at both ends", 6, &[[4, 2, 3], [1, 3, 2]], 5, 1),
        Case::new("strip", 4, &[[0, 1, 2], [1, 3, 2]], 5, 1),
        Case::new("long strip", 6, &[[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 5, 4]], 9, 1),
        Case::new("open fan, middle face first", 5, &[[0, 2, 3], [0, 3, 4], [0, 1, 2]], 7, 1),
        Case::new("closed fan", 5, &[[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]], 8, 1),
        Case::new("tetrahedron", 4, &TETRAHEDRON, 6, 0),
        Case::new("tetrahedron without a face", 4, &TETRAHEDRON[..3], 6, 1),
        Case::new("octahedron", 6, &OCTAHEDRON, 12, 0),
        // Every vertex has two faces, and two edges to neighbours that are neighbours across both faces.
        Case::new("pillow: a face and its reverse", 3, &[[0, 1, 2], [0, 2, 1]], 3, 0),
        Case::new("annulus", 6, &ANNULUS, 12, 2),
        Case::new("two components", 7, &[&TETRAHEDRON[..], &[[4, 5, 6]]].concat(), 9, 1),
        Case::new("two triangles", 6, &[[0, 1, 2], [3, 4, 5]], 6, 2),
    ]
}

//! Meshes that some backends refuse, with the error of each that does.
use super::manifolds::TETRAHEDRON;
use crate::{
    BuildError,
    conformance::{Case, Flaw},
};
use alloc::{vec, vec::Vec};

pub(super) fn cases() -> Vec<Case> {
    let mut cases = vertices();
    cases.extend(edges());
    cases.extend(directions());
    cases.extend(faces());
    cases
}

/// Regular edges, but vertices of several fans.
fn vertices() -> Vec<Case> {
    let touching = [&TETRAHEDRON[..], &[[0, 4, 5], [0, 6, 4], [0, 5, 6], [4, 6, 5]]].concat();
    vec![
        Case::new("bowtie", 5, &[[0, 1, 2], [0, 3, 4]], 6, 2).several_fans(0, 2),
        Case::new("two tetrahedra that touch in a vertex", 7, &touching, 12, 0).several_fans(0, 2),
        Case::new("a closed fan before an open one", 6, &[&TETRAHEDRON[..], &[[5, 4, 0]]].concat(), 9, 1)
            .several_fans(0, 2),
        Case::new("three open fans at the last vertex", 7, &[[0, 1, 6], [6, 2, 3], [4, 6, 5]], 9, 3)
            .several_fans(6, 3),
        // The boundary runs through vertex 0 twice, in one curve.
        Case::new("pinched ring", 5, &[[0, 1, 2], [1, 3, 2], [1, 4, 3], [3, 4, 0]], 9, 1).several_fans(0, 2),
    ]
}

/// Edges of three or more faces. Each face beyond two begins a fan at both ends.
fn edges() -> Vec<Case> {
    let tetrahedra = [&TETRAHEDRON[..], &[[0, 1, 4], [0, 5, 1], [0, 4, 5], [1, 5, 4]]].concat();
    let closed_beside =
        [&[[0, 1, 2], [1, 0, 3], [0, 1, 4]], &[[0, 5, 6], [0, 7, 5], [0, 6, 7], [5, 7, 6]][..]];
    vec![
        Case::new("three faces on an edge", 5, &[[0, 1, 2], [1, 0, 3], [0, 1, 4]], 7, None)
            .non_manifold_edge([0, 1], 3, 2)
            .several_fans(0, 3),
        Case::new("three faces that run alike on an edge", 5, &[[0, 1, 2], [0, 1, 3], [0, 1, 4]], 7, None)
            .non_manifold_edge([0, 1], 3, 2)
            .several_fans(0, 3),
        Case::new("two tetrahedra that share an edge", 6, &tetrahedra, 11, None)
            .non_manifold_edge([0, 1], 4, 4)
            .several_fans(0, 2),
        Case::new("three faces on an edge beside a closed fan", 8, &closed_beside.concat(), 13, None)
            .non_manifold_edge([0, 1], 3, 2)
            .several_fans(0, 4),
        // The third half-edge of the first face's second edge comes before that of its first.
        Case::new("a face three times", 3, &[[0, 1, 2], [1, 2, 0], [2, 1, 0]], 3, None)
            .non_manifold_edge([1, 2], 3, 2)
            .several_fans(0, 3),
        Case::new("two edges of three faces", 7, &TWO_EDGES, 14, None)
            .non_manifold_edge([2, 3], 3, 3)
            .several_fans(0, 3),
    ]
}

/// Edge 0-1 comes first, but the third face on edge 2-3 does.
const TWO_EDGES: [[u32; 3]; 6] = [[0, 1, 4], [2, 3, 4], [3, 2, 5], [2, 3, 6], [1, 0, 5], [0, 1, 6]];

/// Two faces that run along an edge in the same direction.
fn directions() -> Vec<Case> {
    let flipped = [[0, 1, 2], [0, 2, 3], [0, 4, 3], [0, 4, 1]];
    let moebius = [[0, 1, 2], [1, 3, 2], [2, 3, 4], [3, 0, 4], [4, 0, 1]];
    vec![
        Case::new("two faces that disagree", 4, &[[0, 1, 2], [0, 1, 3]], 5, None)
            .same_direction([0, 1], [0, 1])
            .several_fans(0, 2),
        Case::new("closed fan with a flipped face", 5, &flipped, 8, None)
            .same_direction([3, 0], [1, 2])
            .several_fans(0, 2),
        Case::new("Moebius band", 5, &moebius, 10, None).same_direction([0, 1], [0, 4]).several_fans(0, 2),
        Case::new("a face twice", 3, &[[0, 1, 2], [1, 2, 0]], 3, None)
            .same_direction([1, 2], [0, 1])
            .several_fans(0, 2),
        // Edge 0-1 comes first, but the second face on edge 2-3 before the third on it.
        Case::new("three faces on an edge, and two that disagree", 7, &MIXED, 12, None)
            .same_direction([2, 3], [1, 3])
            .non_manifold_edge([0, 1], 3, 4)
            .several_fans(0, 3),
    ]
}

const MIXED: [[u32; 3]; 5] = [[0, 1, 2], [2, 3, 4], [1, 0, 5], [2, 3, 5], [0, 1, 6]];

/// Faces that name no vertex, or one twice: a side that returns to its own vertex is no edge.
fn faces() -> Vec<Case> {
    vec![
        Case::new("degenerate face", 5, &[[0, 1, 2], [3, 3, 4]], 4, None).degenerate(1, 3),
        Case::new("degenerate face, ends alike", 5, &[[4, 3, 4], [0, 1, 2]], 4, None).degenerate(0, 4),
        Case::new("degenerate face on an edge", 3, &[[0, 1, 2], [1, 2, 2]], 3, None)
            .degenerate(1, 2)
            .non_manifold_edge([1, 2], 3, 1)
            .several_fans(1, 2),
        Case::new("a face at one vertex", 2, &[[1, 1, 1]], 0, None)
            .degenerate(0, 1)
            .non_manifold_edge([1, 1], 3, 0)
            .several_fans(1, 3),
        Case::new("vertex out of range", 3, &[[0, 1, 2], [1, 3, 2]], 5, None).out_of_range(1, 3),
        Case::new("the largest index", 4, &[[0, u32::MAX, 2]], 3, None).out_of_range(0, u32::MAX),
        Case::new("a face without vertices", 0, &[[0, 0, 0]], 0, None).out_of_range(0, 0),
        Case::new("degenerate face before one out of range", 3, &[[0, 1, 1], [0, 1, 7]], 3, None)
            .degenerate(0, 1)
            .out_of_range(1, 7),
        Case::new("face out of range before a degenerate one", 3, &[[0, 1, 7], [0, 1, 1]], 3, None)
            .out_of_range(0, 7)
            .degenerate(1, 1),
    ]
}

impl Case {
    fn several_fans(self, vertex: u32, fans: usize) -> Self {
        self.with(Flaw::SeveralFans, BuildError::SeveralFans { vertex, fans })
    }

    fn non_manifold_edge(self, vertices: [u32; 2], faces: usize, face: usize) -> Self {
        self.with(Flaw::NonManifoldEdge, BuildError::NonManifoldEdge { vertices, faces, face })
    }

    fn same_direction(self, vertices: [u32; 2], faces: [usize; 2]) -> Self {
        self.with(Flaw::SameDirection, BuildError::SameDirection { vertices, faces })
    }

    fn degenerate(self, face: usize, vertex: u32) -> Self {
        self.with(Flaw::Degenerate, BuildError::DegenerateFace { face, vertex })
    }

    fn out_of_range(self, face: usize, vertex: u32) -> Self {
        let vertex_count = self.vertices;
        self.with(Flaw::OutOfRange, BuildError::VertexOutOfRange { face, vertex, vertex_count })
    }
}

//! What holds for every structure that renumbers.
use crate::naive;
use crate::renumbered::{mixed, renumbered};
use crate::shapes::{Faces, grid};
use onering::conformance::{self as laws, Case};
use onering::{BuildError, HalfEdgeId, Handle, Incidence, Renumbering, VertexId};
use proptest::prelude::*;
use std::fmt::Debug;

pub(crate) type Encoder<M> = fn(usize, &[[u32; 3]]) -> Result<(M, Renumbering), BuildError>;

/// A structure that renumbers, and what it promises beyond the laws of its traits.
pub(crate) trait Renumbers: Incidence<Vertex = VertexId, HalfEdge = HalfEdgeId> + Debug {
    /// `case` is in the numbers of the mesh.
    fn keeps_promises(&self, case: &Case);
}

/// The laws, on a case that the structure holds.
pub(crate) fn obeys<M: Renumbers>(case: &Case, (mesh, maps): &(M, Renumbering)) {
    let case = Case { faces: renumbered(&case.faces, maps), ..case.clone() };
    laws::topology(&case, mesh);
    laws::topology(&case, &mesh);
    laws::adjacency(&case, mesh);
    laws::adjacency(&case, &mesh);
    laws::incidence(&case, mesh);
    laws::incidence(&case, &mesh);
    laws::graph(&case, mesh);
    mesh.keeps_promises(&case);
}

pub(crate) fn obeys_on_the_corpus<M: Renumbers>(encode: Encoder<M>) {
    for case in laws::corpus() {
        match (encode(case.vertices, &case.faces), case.refusal(&[])) {
            (Ok(encoded), None) => obeys(&case, &encoded),
            (Err(error), Some(expected)) => assert_eq!(error, *expected, "{}", case.name),
            (encoded, expected) => panic!("{}: {encoded:?}, expected {expected:?}", case.name),
        }
    }
}

/// Whatever the list: a mesh that obeys the laws, or the error that there is to be.
pub(crate) fn obeys_or_refuses<M: Renumbers>(encode: Encoder<M>, vertices: usize, faces: &[[u32; 3]]) {
    let encoded = encode(vertices, faces);
    assert_eq!(encoded.as_ref().err(), naive::error(vertices, faces, &[]).as_ref());
    if let Ok(encoded) = encoded {
        obeys(&Case::counted("at random", vertices, faces.to_vec()), &encoded);
    }
}

/// Pieces of a disk, a torus and a band: manifold more often than not.
pub(crate) fn pieces() -> impl Strategy<Value = (usize, Faces)> {
    let shape = (1..5u32, 3..5u32, any::<bool>(), any::<bool>());
    (shape, 1..40usize, any::<u64>()).prop_map(|((n, m, around, along), kept, seed)| {
        let (vertices, faces) = grid(n.max(if around { 3 } else { 1 }), m, [around, along], false);
        let mut faces = mixed(vertices, &faces, seed);
        faces.truncate(kept);
        (vertices, faces)
    })
}

/// A fan of so many faces around vertex 0, in no order.
pub(crate) fn shuffled_fan(faces: usize) -> Faces {
    let face = |i: usize| [0, 1 + i * 61_803 % faces, 1 + (i * 61_803 + 1) % faces].map(|v| v as u32);
    (0..faces).map(face).collect()
}

pub(crate) fn refuses_impossible_counts<M: Renumbers>(encode: Encoder<M>) {
    let error = encode(usize::MAX, &[]).err();
    assert!(matches!(error, Some(BuildError::TooManyVertices { .. })), "{error:?}");
    let error = BuildError::VertexOutOfRange { face: 0, vertex: 0, vertex_count: 0 };
    assert_eq!(encode(0, &[[0, 1, 2]]).err(), Some(error));
    let (mesh, maps) = encode(0, &[]).unwrap();
    assert_eq!((mesh.vertex_count(), mesh.half_edge_bound(), maps), (0, 0, Renumbering::default()));
    let (mesh, _) = encode(100, &[]).unwrap();
    assert_eq!((mesh.vertex_count(), mesh.half_edges().count()), (100, 0));
}

pub(crate) fn carries_attributes<M: Renumbers>(encode: Encoder<M>) {
    let (mesh, maps) = encode(4, &[[3, 1, 0], [0, 2, 3]]).unwrap();
    let names = maps.carry_vertices(&["a", "b", "c", "d"]);
    let faces = maps.carry_faces(&[["d", "b", "a"], ["a", "c", "d"]]);
    for (f, named) in mesh.faces().zip(faces) {
        for h in mesh.face_half_edges(f) {
            let side = maps.half_edge_source(&mesh, h).index() % 3;
            assert_eq!(names[mesh.origin(h).index()], named[side]);
        }
    }
}

//! Structures that renumber, beside the list of faces that they were made of.
use crate::naive;
use crate::shapes::{Faces, Random, grid};
use onering::conformance::{self as laws, Case};
use onering::{BuildError, HalfEdgeId, Handle, Incidence, Renumbering, VertexId};
use proptest::prelude::*;
use std::{collections::HashMap, fmt::Debug};

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

/// Whether these are maps there and back between the same numbers.
fn are_inverse(source: &[u32], target: &[u32]) -> bool {
    let comes_back = |(i, &to): (usize, &u32)| source.get(to as usize) == Some(&(i as u32));
    source.len() == target.len() && target.iter().enumerate().all(comes_back)
}

/// The faces of a list in the numbers that the maps tell: nothing of the structure itself is asked.
pub(crate) fn renumbered(faces: &[[u32; 3]], maps: &Renumbering) -> Faces {
    assert!(are_inverse(&maps.vertex_source, &maps.vertex_target), "{maps:?}");
    let mut sources = maps.face_source.clone();
    sources.sort_unstable();
    assert!(sources.into_iter().eq(0..faces.len() as u32), "each face is there once: {maps:?}");
    let turned = |(mut face, &corner): ([u32; 3], &u8)| {
        face.rotate_left(corner.into());
        face.map(|v| maps.vertex_target[v as usize])
    };
    maps.carry_faces(faces).into_iter().zip(&maps.first_corner).map(turned).collect()
}

/// Compares a mesh too large for the laws with its list of faces.
pub(crate) fn is_of_list<M: Incidence>(name: &str, mesh: &M, vertices: usize, faces: &[[u32; 3]]) {
    assert_eq!((mesh.vertex_count(), mesh.face_count()), (vertices, faces.len()), "{name}");
    assert_eq!(mesh.to_faces(), faces, "{name}");
    let sides = || faces.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let places: HashMap<(u32, u32), usize> = sides().zip(0..).collect();
    let half_edges: Vec<M::HalfEdge> = mesh.faces().flat_map(|f| mesh.face_half_edges(f)).collect();
    for ((a, b), &h) in sides().zip(&half_edges) {
        let across = places.get(&(b, a)).map(|&o| half_edges[o]);
        assert_eq!(mesh.opposite(h), across, "{name}: {h:?}");
        assert_eq!([mesh.origin(h), mesh.target(h)].map(|v| v.index() as u32), [a, b], "{name}: {h:?}");
    }
    let mut degrees = vec![0; vertices];
    faces.as_flattened().iter().for_each(|&v| degrees[v as usize] += 1);
    for v in mesh.vertices() {
        assert_eq!(mesh.star(v).count(), degrees[v.index()], "{name}: {v:?}");
        assert!(mesh.star(v).all(|h| mesh.origin(h) == v), "{name}: {v:?}");
        let start = mesh.outgoing(v);
        let is_closed = start.is_some_and(|h| mesh.opposite(h).is_some());
        let open = start.is_some() && !is_closed;
        assert_eq!(mesh.one_ring(v).count(), degrees[v.index()] + usize::from(open), "{name}: {v:?}");
    }
}

/// Vertices, faces and corners in another order.
pub(crate) fn mixed(vertices: usize, faces: &[[u32; 3]], seed: u64) -> Faces {
    let mut random = Random(seed);
    let mut names: Vec<u32> = (0..vertices as u32).collect();
    (1..vertices).rev().for_each(|i| names.swap(i, random.below(i + 1)));
    let mut faces: Faces = faces.iter().map(|face| face.map(|v| names[v as usize])).collect();
    (1..faces.len()).rev().for_each(|i| faces.swap(i, random.below(i + 1)));
    faces.iter_mut().for_each(|face| face.rotate_left(random.below(3)));
    faces
}

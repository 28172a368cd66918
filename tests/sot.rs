//! The sorted opposite table renumbers, so the laws run on each case in the numbers that its maps tell.
#[path = "common/encoders.rs"]
mod encoders;
#[allow(dead_code, reason = "fans are for the law of their order")]
#[path = "common/naive.rs"]
mod naive;
#[path = "common/random.rs"]
mod random;
#[path = "common/renumbered.rs"]
mod renumbered;
#[path = "common/shapes.rs"]
mod shapes;

use encoders::{Renumbers, shuffled_fan};
use onering::conformance::{self as laws, Case};
use onering::*;
use proptest::prelude::*;
use renumbered::{is_of_list, mixed, renumbered};
use shapes::{Faces, grid, shuffled};
use std::collections::HashMap;

impl Renumbers for Sot {
    fn keeps_promises(&self, case: &Case) {
        laws::footprint(case, self);
        laws::footprint(case, &self.clone());
        is_sorted(self);
    }
}

/// What gives it its name: a matched vertex is the first of the face of its number, and nothing else is stored.
fn is_sorted(mesh: &Sot) {
    assert!(mesh.matched_count() <= mesh.face_count().min(mesh.vertex_count()));
    for i in 0..mesh.matched_count() {
        assert_eq!(mesh.origin(HalfEdgeId::new(3 * i)), VertexId::new(i));
    }
}

/// The table over a mesh too large for the laws, compared with the list.
fn agrees(name: &str, vertices: usize, faces: &[[u32; 3]]) -> Sot {
    let (mesh, maps) = Sot::encode(vertices, faces).unwrap_or_else(|error| panic!("{name}: {error}"));
    is_of_list(name, &mesh, vertices, &renumbered(faces, &maps));
    is_sorted(&mesh);
    mesh
}

#[test]
fn laws_of_the_corpus() {
    encoders::obeys_on_the_corpus(Sot::encode);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 4000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn laws_of_any_list((vertices, faces) in prop_oneof![random::lists(), encoders::pieces()]) {
        encoders::obeys_or_refuses(Sot::encode, vertices, &faces);
    }
}

/// Name, number of vertices, faces, and of how many vertices none has a face of its own, counted by hand.
type Family = (&'static str, usize, Faces, usize);

const OCTAHEDRON: [[u32; 3]; 8] =
    [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];

fn families() -> Vec<Family> {
    let corpus = |name: &str| laws::corpus().into_iter().find(|case| case.name == name).unwrap();
    let of_corpus = |name: &'static str, unmatched| {
        let case = corpus(name);
        (name, case.vertices, case.faces, unmatched)
    };
    let of_grid = |name, (vertices, faces): (usize, Faces), unmatched| (name, vertices, faces, unmatched);
    let sphere = (0..4).fold(CheL1::from_faces(6, &OCTAHEDRON).unwrap(), |mesh, _| divided(&mesh));
    vec![
        of_corpus("tetrahedron", 0),
        of_corpus("octahedron", 0),
        ("sphere", sphere.vertex_count(), sphere.to_faces(), 0),
        of_grid("torus", grid(20, 30, [true, true], false), 0),
        of_corpus("genus 2", 0),
        of_grid("disk", grid(25, 31, [false, false], false), 0),
        of_grid("annulus", grid(30, 12, [true, false], false), 0),
        // As many faces as vertices less two.
        of_corpus("one triangle", 2),
        of_grid("strip", grid(20, 1, [false, false], false), 2),
        of_corpus("two triangles", 4),
        // A triangle has a face for one of three.
        of_corpus("two components", 2),
        of_corpus("pillow: a face and its reverse", 1),
        of_corpus("isolated vertices at both ends", 2),
    ]
}

/// Every face into four.
fn divided(mesh: &CheL1) -> CheL1 {
    let mut midpoints = HashMap::new();
    let mut count = mesh.vertex_count() as u32;
    let mut faces = Vec::new();
    for [a, b, c] in mesh.to_faces() {
        let [x, y, z] = [(a, b), (b, c), (c, a)].map(|(u, v)| {
            *midpoints.entry((u.min(v), u.max(v))).or_insert_with(|| {
                count += 1;
                count - 1
            })
        });
        faces.extend([[a, x, z], [x, b, y], [z, y, c], [x, y, z]]);
    }
    CheL1::from_face_vec(count as usize, faces).unwrap()
}

#[test]
fn families_in_any_order() {
    for (name, vertices, faces, unmatched) in families() {
        for seed in 0..6 {
            let faces = if seed == 0 { faces.clone() } else { mixed(vertices, &faces, seed) };
            let mesh = agrees(name, vertices, &faces);
            assert_eq!(mesh.heap_bytes(), 12 * faces.len() + 4 * unmatched, "{name}");
        }
    }
}

/// Pillows have vertices that neither a face nor the boundary names: many of them, each found.
#[test]
fn many_pillows() {
    let pillow = |i: u32| [[3 * i, 3 * i + 1, 3 * i + 2], [3 * i, 3 * i + 2, 3 * i + 1]];
    let faces = shuffled((0..1000).flat_map(pillow).collect());
    let mesh = agrees("pillows", 3001, &faces);
    assert_eq!(mesh.heap_bytes(), 12 * 2000 + 4 * 1000);
}

/// A fan of many faces in no order takes linear time to encode, and to walk where no origin is asked for.
#[test]
fn a_hub() {
    const FACES: usize = 100_000;
    let faces = shuffled_fan(FACES);
    let (mesh, maps) = Sot::encode(FACES + 1, &faces).unwrap();
    let hub = VertexId::new(maps.vertex_target[0] as usize);
    assert_eq!((mesh.star(hub).count(), mesh.one_ring(hub).count()), (FACES, FACES));
    // 100,001 vertices with 100,000 faces: one on the rim is left without.
    assert_eq!(mesh.heap_bytes(), 12 * FACES + 4);
}

#[test]
fn impossible_counts() {
    encoders::refuses_impossible_counts(Sot::encode);
}

#[test]
fn attributes() {
    encoders::carries_attributes(Sot::encode);
}

#[test]
#[should_panic(expected = "vertex 3 of 3")]
fn a_vertex_out_of_range() {
    let (mesh, _) = Sot::encode(3, &[[0, 1, 2]]).unwrap();
    mesh.outgoing(VertexId::new(3));
}

#[test]
fn is_shared_and_copied() {
    fn check<M: Send + Sync + Clone + std::fmt::Debug + 'static>() {}
    check::<Sot>();
}

//! The dual graph against a search for shared edges.
#![allow(unreachable_pub, reason = "a test has no outside")]
#[path = "common/random.rs"]
mod random;
#[path = "algorithms/samples.rs"]
#[allow(dead_code, reason = "each test uses a part of it")]
mod samples;
#[path = "common/shapes.rs"]
mod shapes;

use onering::dual::Dual;
use onering::neighbours::Neighbours;
use onering::*;
use proptest::prelude::*;
use std::collections::BTreeSet;

/// The edges of a face; a degenerate one has sides that are none, from a vertex to itself.
fn edges([a, b, c]: [u32; 3]) -> BTreeSet<[u32; 2]> {
    let sides = [[a, b], [b, c], [c, a]].into_iter().filter(|[a, b]| a != b);
    sides.map(|[a, b]| [a.min(b), a.max(b)]).collect()
}

fn slow(faces: &[[u32; 3]], f: usize) -> Vec<usize> {
    let shares = |&g: &usize| g != f && !edges(faces[f]).is_disjoint(&edges(faces[g]));
    (0..faces.len()).filter(shares).collect()
}

fn agrees<M: Adjacency>(mesh: &M, faces: &[[u32; 3]], name: &str) {
    let dual = Dual::new(mesh);
    assert_eq!(dual.node_count(), faces.len(), "{name}");
    for f in mesh.faces() {
        let mut found: Vec<usize> = dual.neighbours(f).map(Handle::index).collect();
        found.sort_unstable();
        assert_eq!(found, slow(faces, f.index()), "{name}, {f:?}");
    }
}

fn check<M: Adjacency + FromFaces>() {
    for (sample, mesh) in samples::held::<M>() {
        agrees(&mesh, &sample.faces, &sample.name);
        let parts = components::components(&mesh);
        let mut ring = k_ring::KRing::new();
        for f in mesh.faces() {
            let found = ring.search(&Dual::new(&mesh), f, usize::MAX).count(usize::MAX) + 1;
            assert_eq!(found, parts.sizes()[parts.of(f)], "{}, {f:?}", sample.name);
        }
    }
}

macro_rules! with_adjacency {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {$(
        $(with_adjacency!(@$has $name $mesh);)*
    )+};
    (@adjacency $name:ident $mesh:ty) => {
        #[test]
        fn $name() {
            check::<$mesh>();
        }
    };
    (@$other:ident $name:ident $mesh:ty) => {};
}
onering::with_backends!(with_adjacency);

/// On a torus of squares cut alike, faces are the vertices of a honeycomb: 3, 6, 9 and 12 at distance 1 to 4.
#[test]
fn levels_of_a_honeycomb() {
    let (n, faces) = shapes::grid(12, 12, [true, true], false);
    let mesh = CheL1::from_faces(n, &faces).unwrap();
    let dual = Dual::new(&mesh);
    for f in mesh.faces() {
        let ring = k_ring::k_ring(&dual, f, 4);
        assert_eq!([1, 2, 3, 4].map(|k| ring.level(k).len()), [3, 6, 9, 12]);
    }
    assert_eq!(degrees::degrees(&dual).mean(), Some(3.0));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    /// Degenerate faces as well.
    #[test]
    fn any_list((vertices, faces) in random::lists()) {
        if let Ok(mesh) = SharedVertex::from_faces(vertices, &faces) {
            agrees(&Searched::new(mesh), &faces, "searched");
        }
    }
}

//! Compact stars renumber, so the laws run on each case in the numbers that their maps tell.
#[path = "common/encoders.rs"]
mod encoders;
#[allow(dead_code, reason = "fans are for the law of their order")]
#[path = "common/naive.rs"]
mod naive;
#[path = "common/random.rs"]
mod random;
#[allow(dead_code, reason = "figures are for what is counted")]
#[path = "common/real.rs"]
mod real;
#[path = "common/renumbered.rs"]
mod renumbered;
#[path = "common/shapes.rs"]
mod shapes;

use encoders::{Encoder, Renumbers, shuffled_fan};
use onering::conformance::Case;
use onering::repair::{RepairOptions, repair};
use onering::*;
use proptest::prelude::*;
use real::{MESHES, Real};
use renumbered::{is_of_list, mixed, renumbered};
use shapes::{Faces, grid};
use std::collections::HashSet;

const ENCODERS: [Encoder<CompactStars>; 2] = [CompactStars::encode, CompactStars::encode_in_order];

impl Renumbers for CompactStars {
    fn keeps_promises(&self, case: &Case) {
        takes_its_formula(case.name, self, case.vertices, &case.faces);
        keeps_its_order(case.name, self, &case.faces);
    }
}

/// The bytes that the documentation tells, in numbers of the list alone.
fn takes_its_formula(name: &str, mesh: &CompactStars, vertices: usize, faces: &[[u32; 3]]) {
    let sides = || faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let across: HashSet<[u32; 2]> = sides().collect();
    let boundary = sides().filter(|&[a, b]| !across.contains(&[b, a]));
    let boundary: HashSet<u32> = boundary.flatten().collect();
    let used: HashSet<u32> = faces.as_flattened().iter().copied().collect();
    let places = 3 * faces.len() + 2 * boundary.len() + vertices - used.len();
    let longest = sides().map(|[a, b]| a.abs_diff(b)).max().unwrap_or(0);
    let bits = 1 + (0..=32).find(|bits| 1_u64 << bits > u64::from(longest)).unwrap();
    assert_eq!(mesh.difference_bits() as usize, bits, "{name}");
    assert_eq!(mesh.half_edge_bound(), places, "{name}");
    let differences = (places * bits).div_ceil(8) + 8;
    let starts = 12 * (places + 1).div_ceil(64) + 4 * (vertices + 1).div_ceil(8);
    let firsts = 12 * places.div_ceil(64) + 4 * faces.len().div_ceil(32);
    assert_eq!(mesh.heap_bytes(), differences + starts + firsts, "{name}");
}

/// Half-edges by vertex, faces by their least vertex and named from there.
fn keeps_its_order(name: &str, mesh: &CompactStars, faces: &[[u32; 3]]) {
    assert!(mesh.half_edges().is_sorted_by_key(|h| mesh.origin(h)), "{name}");
    assert!(mesh.half_edges().is_sorted(), "{name}");
    assert!(faces.is_sorted_by_key(|face| face[0]), "{name}");
    assert!(faces.iter().all(|&[a, b, c]| a < b.min(c)), "{name}");
}

/// A mesh too large for the laws, compared with the list.
fn agree(name: &str, vertices: usize, faces: &[[u32; 3]], encode: Encoder<CompactStars>) -> CompactStars {
    let (mesh, maps) = encode(vertices, faces).unwrap_or_else(|error| panic!("{name}: {error}"));
    let faces = renumbered(faces, &maps);
    is_of_list(name, &mesh, vertices, &faces);
    takes_its_formula(name, &mesh, vertices, &faces);
    keeps_its_order(name, &mesh, &faces);
    mesh
}

#[test]
fn laws_of_the_corpus() {
    ENCODERS.into_iter().for_each(encoders::obeys_on_the_corpus);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn laws_of_any_list((vertices, faces) in prop_oneof![random::lists(), encoders::pieces()]) {
        ENCODERS.into_iter().for_each(|encode| encoders::obeys_or_refuses(encode, vertices, &faces));
    }
}

#[test]
fn vertices_keep_their_numbers_where_asked() {
    let (vertices, faces) = grid(9, 7, [true, false], false);
    let faces = mixed(vertices, &faces, 5);
    let (_, maps) = CompactStars::encode_in_order(vertices, &faces).unwrap();
    assert!(maps.vertex_source.iter().copied().eq(0..vertices as u32));
    assert_eq!(maps.vertex_target, maps.vertex_source);
}

/// Steps of up to 17 bits where vertices lie anywhere, and 9 where they are put in order: about two across the band.
#[test]
fn the_order_decides_how_many_bits() {
    let (vertices, faces) = grid(1000, 100, [true, false], false);
    let faces = mixed(vertices, &faces, 1);
    let [ordered, as_it_is] = ENCODERS.map(|encode| agree("a shuffled band", vertices, &faces, encode));
    assert_eq!([ordered.difference_bits(), as_it_is.difference_bits()], [10, 18]);
    assert!(2 * ordered.heap_bytes() < 11 * faces.len(), "{} bytes", ordered.heap_bytes());
}

/// Vertices of many more neighbours than places in a word or between hints, at either end of their neighbours' numbers,
/// and isolated ones between them.
#[test]
fn hubs() {
    let fan = |centre: u32, rim: u32, n: u32, end: u32| -> Faces {
        (0..end).map(|i| [centre, rim + i, rim + (i + 1) % n]).collect()
    };
    let faces =
        [fan(0, 1, 5000, 5000), fan(17_000, 6000, 3000, 3000), fan(17_500, 10_000, 4000, 3999)].concat();
    for encode in ENCODERS {
        agree("hubs", 18_000, &faces, encode);
        agree("shuffled hubs", 18_000, &mixed(18_000, &faces, 3), encode);
    }
}

/// A fan of many faces in no order takes linear time to encode, and to walk where nothing is looked for.
#[test]
fn a_large_hub() {
    const FACES: usize = 100_000;
    let faces = shuffled_fan(FACES);
    let (mesh, maps) = CompactStars::encode(FACES + 1, &faces).unwrap();
    let hub = VertexId::new(maps.vertex_target[0] as usize);
    assert_eq!((mesh.star(hub).count(), mesh.one_ring(hub).count()), (FACES, FACES));
    let neighbours: HashSet<_> = mesh.one_ring(hub).collect();
    assert_eq!(neighbours.len(), FACES);
    takes_its_formula("a large hub", &mesh, FACES + 1, &renumbered(&faces, &maps));
}

#[test]
fn impossible_counts() {
    ENCODERS.into_iter().for_each(encoders::refuses_impossible_counts);
}

#[test]
fn attributes() {
    ENCODERS.into_iter().for_each(encoders::carries_attributes);
}

#[test]
fn real_meshes() {
    for Real { name, mesh, .. } in &*MESHES {
        let mended = repair(mesh.positions.len(), &mesh.faces, &RepairOptions { weld: None }).unwrap();
        let stars = agree(name, mended.vertex_count, &mended.faces, CompactStars::encode);
        if mended.faces.len() > 10_000 {
            assert!(stars.heap_bytes() < 8 * mended.faces.len(), "{name}: {} bytes", stars.heap_bytes());
        }
    }
}

#[test]
#[should_panic(expected = "vertex 3 of 3")]
fn a_vertex_out_of_range() {
    let (mesh, _) = CompactStars::encode(3, &[[0, 1, 2]]).unwrap();
    mesh.outgoing(VertexId::new(3));
}

/// Whatever it is asked: `what` panics with its name.
fn panics_out_of_range<T>(what: fn(&CompactStars, HalfEdgeId) -> T) {
    let (mesh, _) = CompactStars::encode(3, &[[0, 1, 2]]).unwrap();
    let asked = std::panic::catch_unwind(|| drop(what(&mesh, HalfEdgeId::new(9))));
    let message = asked.expect_err("h9 of nine");
    assert_eq!(message.downcast_ref::<String>().map(String::as_str), Some("h9 is out of range"));
}

#[test]
fn a_half_edge_out_of_range() {
    panics_out_of_range(CompactStars::origin);
    panics_out_of_range(CompactStars::target);
    panics_out_of_range(CompactStars::next);
    panics_out_of_range(CompactStars::prev);
    panics_out_of_range(CompactStars::face);
    panics_out_of_range(CompactStars::opposite);
    panics_out_of_range(CompactStars::rotate_ccw);
    panics_out_of_range(CompactStars::rotate_cw);
    panics_out_of_range(CompactStars::is_boundary);
}

#[test]
#[should_panic(expected = "face 1 of 1")]
fn a_face_out_of_range() {
    let (mesh, _) = CompactStars::encode(3, &[[0, 1, 2]]).unwrap();
    mesh.first(FaceId::new(1));
}

#[test]
fn are_shared_and_copied() {
    fn check<M: Send + Sync + Clone + std::fmt::Debug + 'static>() {}
    check::<CompactStars>();
}

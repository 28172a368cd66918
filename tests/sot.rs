//! The sorted opposite table renumbers, so the laws run on each case in the numbers that its maps tell.
#[allow(dead_code, reason = "fans are for the law of their order")]
#[path = "common/naive.rs"]
mod naive;
#[path = "common/random.rs"]
mod random;
#[path = "common/shapes.rs"]
mod shapes;

use onering::conformance::{self as laws, Case};
use onering::sot::Renumbering;
use onering::*;
use proptest::prelude::*;
use shapes::{Faces, Random, grid, shuffled};
use std::collections::HashMap;

/// Whether these are maps there and back between the same numbers.
fn are_inverse(source: &[u32], target: &[u32]) -> bool {
    let comes_back = |(i, &to): (usize, &u32)| source.get(to as usize) == Some(&(i as u32));
    source.len() == target.len() && target.iter().enumerate().all(comes_back)
}

/// The faces of a list in the numbers that the maps tell: nothing of the table itself is asked.
fn renumbered(faces: &[[u32; 3]], maps: &Renumbering) -> Faces {
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

/// The laws, on a case that it holds.
fn obeys(case: &Case, (mesh, maps): &(Sot, Renumbering)) {
    let case = Case { faces: renumbered(&case.faces, maps), ..case.clone() };
    laws::topology(&case, mesh);
    laws::topology(&case, &mesh);
    laws::adjacency(&case, mesh);
    laws::adjacency(&case, &mesh);
    laws::incidence(&case, mesh);
    laws::incidence(&case, &mesh);
    laws::graph(&case, mesh);
    laws::footprint(&case, mesh);
    laws::footprint(&case, &mesh.clone());
    is_sorted(mesh);
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
    let faces = renumbered(faces, &maps);
    assert_eq!((mesh.vertex_count(), mesh.face_count()), (vertices, faces.len()), "{name}");
    assert_eq!(mesh.to_faces(), faces, "{name}");
    let sides = || faces.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let places: HashMap<(u32, u32), usize> = sides().zip(0..).collect();
    let across = sides().map(|(a, b)| places.get(&(b, a)).copied());
    assert!(mesh.half_edges().map(|h| mesh.opposite(h).map(Handle::index)).eq(across), "{name}");
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
    is_sorted(&mesh);
    mesh
}

#[test]
fn laws_of_the_corpus() {
    for case in laws::corpus() {
        match (Sot::encode(case.vertices, &case.faces), case.refusal(&[])) {
            (Ok(encoded), None) => obeys(&case, &encoded),
            (Err(error), Some(expected)) => assert_eq!(error, *expected, "{}", case.name),
            (encoded, expected) => panic!("{}: {encoded:?}, expected {expected:?}", case.name),
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 2000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn laws_of_any_list((vertices, faces) in random::lists()) {
        let encoded = Sot::encode(vertices, &faces);
        let expected = naive::error(vertices, &faces, &[]);
        prop_assert_eq!(encoded.as_ref().err(), expected.as_ref());
        if let Ok(encoded) = encoded {
            obeys(&Case::counted("at random", vertices, faces), &encoded);
        }
    }

    /// Pieces of a disk, a torus and a band: manifold more often than not.
    #[test]
    fn laws_of_pieces(shape in (1..5u32, 3..5u32, any::<bool>(), any::<bool>()), kept in 0..40usize, seed in any::<u64>()) {
        let (n, m, around, along) = shape;
        let (vertices, faces) = grid(n.max(if around { 3 } else { 1 }), m, [around, along], false);
        let mut faces = mixed(vertices, &faces, seed);
        faces.truncate(kept.max(1));
        if let Ok(encoded) = Sot::encode(vertices, &faces) {
            obeys(&Case::counted("a piece", vertices, faces), &encoded);
        }
    }
}

/// Vertices, faces and corners in another order.
fn mixed(vertices: usize, faces: &[[u32; 3]], seed: u64) -> Faces {
    let mut random = Random(seed);
    let mut names: Vec<u32> = (0..vertices as u32).collect();
    (1..vertices).rev().for_each(|i| names.swap(i, random.below(i + 1)));
    let mut faces: Faces = faces.iter().map(|face| face.map(|v| names[v as usize])).collect();
    (1..faces.len()).rev().for_each(|i| faces.swap(i, random.below(i + 1)));
    faces.iter_mut().for_each(|face| face.rotate_left(random.below(3)));
    faces
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
    let face = |i: usize| [0, 1 + i * 61_803 % FACES, 1 + (i * 61_803 + 1) % FACES].map(|v| v as u32);
    let faces: Faces = (0..FACES).map(face).collect();
    let (mesh, maps) = Sot::encode(FACES + 1, &faces).unwrap();
    let hub = VertexId::new(maps.vertex_target[0] as usize);
    assert_eq!((mesh.star(hub).count(), mesh.one_ring(hub).count()), (FACES, FACES));
    // 100,001 vertices with 100,000 faces: one on the rim is left without.
    assert_eq!(mesh.heap_bytes(), 12 * FACES + 4);
}

#[test]
fn counts_at_the_ends() {
    let error = Sot::encode(usize::MAX, &[]).err();
    assert!(matches!(error, Some(BuildError::TooManyVertices { .. })), "{error:?}");
    let error = BuildError::VertexOutOfRange { face: 0, vertex: 0, vertex_count: 0 };
    assert_eq!(Sot::encode(0, &[[0, 1, 2]]).err(), Some(error));
    let (mesh, maps) = Sot::encode(0, &[]).unwrap();
    assert_eq!((mesh.vertex_count(), mesh.heap_bytes(), maps), (0, 0, Renumbering::default()));
}

#[test]
fn attributes_are_carried() {
    let (mesh, maps) = Sot::encode(4, &[[3, 1, 0], [0, 2, 3]]).unwrap();
    let names = maps.carry_vertices(&["a", "b", "c", "d"]);
    let faces = maps.carry_faces(&[["d", "b", "a"], ["a", "c", "d"]]);
    for (f, named) in mesh.faces().zip(faces) {
        for h in mesh.face_half_edges(f) {
            let side = maps.half_edge_source(h).index() % 3;
            assert_eq!(names[mesh.origin(h).index()], named[side]);
        }
    }
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

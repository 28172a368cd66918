//! `repair`: after it, whatever went in, every backend accepts the mesh, and everything is accounted for.

mod common;

use common::random::{crowds, crumpled};
use common::{TETRAHEDRON, corpus, grid};
use onering_core::BuildError;
use onering_core::defects::Defects;
use onering_core::repair::{RepairError, RepairOptions, Repaired, repair};
use proptest::prelude::*;
use std::collections::{HashMap, HashSet};

fn mend(vertex_count: usize, faces: &[[u32; 3]]) -> Repaired {
    repair(vertex_count, faces, &RepairOptions::default()).expect("no list is beyond repair")
}

fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

/// The promise, checked by dictionaries and without `Defects`.
fn check_sound(vertex_count: usize, faces: &[[u32; 3]]) {
    let mut opposite = HashMap::new();
    for (f, &face) in faces.iter().enumerate() {
        assert!(face.iter().all(|&v| (v as usize) < vertex_count), "f{f} {face:?} is out of range");
        for [a, b] in sides(face) {
            assert_ne!(a, b, "f{f} is degenerate");
            // A third face, or a second in the same direction, would take a side that is taken.
            assert_eq!(opposite.insert([a, b], f), None, "two faces on {a} to {b}");
        }
    }
    let sets: HashSet<_> = faces.iter().map(|&face| sorted(face)).collect();
    assert_eq!(sets.len(), faces.len(), "two faces have the same vertices");
    for v in 0..vertex_count as u32 {
        let mut star: HashSet<usize> = (0..faces.len()).filter(|&f| faces[f].contains(&v)).collect();
        let mut stack: Vec<usize> = star.iter().next().copied().into_iter().collect();
        while let Some(f) = stack.pop() {
            if star.remove(&f) {
                let at_v = sides(faces[f]).into_iter().filter(|side| side.contains(&v));
                stack.extend(at_v.filter_map(|[a, b]| opposite.get(&[b, a])));
            }
        }
        assert!(star.is_empty(), "v{v} has several fans");
    }
}

fn sorted(mut face: [u32; 3]) -> [u32; 3] {
    face.sort();
    face
}

/// The maps back lead to the faces that went in, and each of those is kept or named as dropped.
fn check_accounts(vertex_count: usize, faces: &[[u32; 3]], repaired: &Repaired) {
    assert_eq!(
        (repaired.vertex_source.len(), repaired.face_source.len()),
        (repaired.vertex_count, repaired.faces.len())
    );
    assert_eq!(repaired.vertex_count, vertex_count + repaired.vertices_added);
    assert!(
        repaired.vertex_source.iter().take(vertex_count).eq(&(0..vertex_count as u32).collect::<Vec<_>>())
    );
    let flipped: HashSet<u32> = repaired.flipped.iter().copied().collect();
    assert_eq!(flipped.len(), repaired.flipped.len());
    for (face, &f) in repaired.faces.iter().zip(&repaired.face_source) {
        let [a, b, c] = face.map(|v| repaired.vertex_source[v as usize]);
        let back = if flipped.contains(&f) { [a, c, b] } else { [a, b, c] };
        assert_eq!(back, faces[f as usize], "f{f}");
    }
    let dropped = &repaired.dropped;
    let all = [&repaired.face_source, &dropped.out_of_range, &dropped.degenerate, &dropped.duplicate];
    assert!(all.iter().all(|list| list.is_sorted()));
    let mut all: Vec<u32> = all.into_iter().flatten().copied().collect();
    all.sort();
    assert!(all.into_iter().eq(0..faces.len() as u32), "every face is in one list");
}

/// What is said to be cut is what came apart, by the maps back.
fn check_cuts(repaired: &Repaired) {
    let source = |v: u32| repaired.vertex_source[v as usize];
    let copied: HashSet<u32> =
        repaired.vertex_source.iter().rev().take(repaired.vertices_added).copied().collect();
    assert_eq!(repaired.vertices_cut, copied.len());
    let mut parts: HashMap<_, HashSet<_>> = HashMap::new();
    for [a, b] in repaired.faces.iter().flat_map(|&face| sides(face)) {
        let (a, b) = if source(a) < source(b) { (a, b) } else { (b, a) };
        parts.entry([source(a), source(b)]).or_default().insert([a, b]);
    }
    assert_eq!(repaired.edges_cut, parts.values().filter(|edges| edges.len() > 1).count());
}

/// All that holds for any list.
fn check(vertex_count: usize, faces: &[[u32; 3]]) -> Repaired {
    let repaired = mend(vertex_count, faces);
    check_sound(repaired.vertex_count, &repaired.faces);
    check_accounts(vertex_count, faces, &repaired);
    check_cuts(&repaired);
    let (before, after) = (
        Defects::of(vertex_count, faces).unwrap(),
        Defects::of(repaired.vertex_count, &repaired.faces).unwrap(),
    );
    assert!(after.is_clean() && after.manifold && after.orientable, "{after}");
    assert_eq!((after.duplicate_faces, after.min_flips), (0, 0));
    assert_eq!(repaired.dropped.out_of_range, before.lists.out_of_range_faces);
    assert_eq!(repaired.dropped.degenerate, before.lists.degenerate_faces);
    assert_eq!(repaired.dropped.duplicate, before.lists.duplicate_faces);
    if before.duplicate_faces == 0 && before.orientable {
        assert_eq!((repaired.flipped.len(), repaired.seam_edges), (before.min_flips, 0));
    }
    assert_eq!(repaired.is_unchanged(), before.is_clean() && before.duplicate_faces == 0);
    let again = mend(repaired.vertex_count, &repaired.faces);
    assert!(again.is_unchanged() && again.faces == repaired.faces, "{again}");
    repaired
}

#[test]
fn the_corpus_is_repaired() {
    for (name, vertex_count, faces, _) in corpus() {
        println!("{name}: {}", check(vertex_count, &faces));
    }
}

#[test]
fn two_tetrahedra_come_apart_closed() {
    for (shared, added) in [(1, 1), (2, 2)] {
        let second = TETRAHEDRON.map(|face| face.map(|v| if v < shared { v } else { v + 4 - shared }));
        let faces: Vec<_> = TETRAHEDRON.into_iter().chain(second).collect();
        let repaired = check(8 - shared as usize, &faces);
        let after = Defects::of(repaired.vertex_count, &repaired.faces).unwrap();
        assert_eq!((after.components, after.closed, repaired.vertices_added), (2, true, added));
        // At an edge of four, two and two still are neighbours around both ends.
        assert_eq!(repaired.edges_cut, shared as usize - 1);
    }
}

#[test]
fn a_fin_comes_off_and_the_surface_stays_whole() {
    let (vertices, torus) = grid(5, 5, [true, true], false);
    let [a, b, _] = torus[7];
    let faces: Vec<_> = torus.into_iter().chain([[a, b, vertices as u32]]).collect();
    let repaired = check(vertices + 1, &faces);
    let after = Defects::of(repaired.vertex_count, &repaired.faces).unwrap();
    assert_eq!((after.components, after.boundary_edges, after.genus), (2, 3, Some(1)));
    assert_eq!((repaired.edges_cut, repaired.vertices_added), (1, 2));
}

#[test]
fn a_given_seam_is_the_one_that_is_cut() {
    let (vertices, strip) = grid(20, 4, [true, false], true);
    let repaired = check(vertices, &strip);
    assert_eq!((repaired.seam_edges, repaired.edges_cut, repaired.flipped.len()), (4, 4, 0));
    let after = Defects::of(repaired.vertex_count, &repaired.faces).unwrap();
    assert_eq!((after.euler, after.boundary_loops, after.components), (1, Some(1), 1));
}

#[test]
fn of_two_halves_the_first_face_stays() {
    let repaired = check(4, &[[0, 1, 2], [0, 1, 3]]);
    assert_eq!((repaired.flipped, repaired.faces), (vec![1], vec![[0, 1, 2], [0, 3, 1]]));
}

#[test]
fn welding_comes_first() {
    // Two triangles side by side with their own corners, one that shrinks to a line, one out of range.
    let positions =
        [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, -0.0, 0.0], [-0.0, 1.0, 0.0], [1.0; 3]];
    let faces = [[0, 1, 2], [4, 3, 5], [1, 3, 5], [0, 1, 6], [3, 4, 0]];
    let options = RepairOptions { weld: Some(&positions) };
    let repaired = repair(6, &faces, &options).expect("as many positions as vertices");
    assert_eq!(repaired.faces, [[0, 1, 2], [2, 1, 3]]);
    assert_eq!((repaired.vertex_source.as_slice(), repaired.vertices_welded), (&[0, 1, 2, 5][..], 2));
    assert_eq!((&repaired.dropped.degenerate[..], &repaired.dropped.out_of_range[..]), (&[2][..], &[3][..]));
    assert_eq!(repaired.dropped.duplicate, [4]);
    assert_eq!(repaired.carry_vertices(&positions)[3], [1.0; 3]);
    assert_eq!(
        repaired.to_string(),
        "2 vertices welded away, 1 out-of-range face dropped, 1 degenerate face dropped, 1 duplicate face dropped"
    );
}

#[test]
fn copies_of_a_welded_vertex_lead_back_to_its_first() {
    let positions = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0; 3], [5.0, 0.0, 0.0], [0.0, 5.0, 0.0]];
    let options = RepairOptions { weld: Some(&positions) };
    let repaired = repair(6, &[[0, 1, 2], [3, 4, 5]], &options).expect("as many positions as vertices");
    assert_eq!(repaired.faces, [[0, 1, 2], [5, 3, 4]]);
    assert_eq!(repaired.vertex_source, [0, 1, 2, 4, 5, 0]);
}

#[test]
fn what_cannot_be_numbered_or_matched_is_an_error() {
    let none = RepairOptions::default();
    let limit = u32::MAX as usize;
    let too_many = |vertices| Err(RepairError::Limit(BuildError::TooManyVertices { vertices, limit }));
    assert_eq!(repair(usize::MAX, &[], &none), too_many(usize::MAX));
    // The copy is the one vertex too many; that is known before memory is taken.
    let bowtie = [[0, 1, 2], [0, 3, 4]];
    assert_eq!(repair(limit, &bowtie, &none), too_many(limit + 1));
    let weld = RepairOptions { weld: Some(&[[0.0; 3]; 4]) };
    assert_eq!(repair(5, &bowtie, &weld), Err(RepairError::PositionCount { vertices: 5, positions: 4 }));
    assert_eq!(repair(5, &bowtie, &weld).unwrap_err().to_string(), "4 positions to weld for 5 vertices");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn crowded_lists_are_repaired((n, faces) in crowds(9)) {
        check(n, &faces);
    }

    #[test]
    fn crumpled_surfaces_are_repaired((n, faces) in crumpled()) {
        check(n, &faces);
    }

    /// Numbers far apart go another way.
    #[test]
    fn sparse_numbers_are_repaired((n, faces) in crowds(9), step in 40u32..100) {
        let far: Vec<_> = faces.iter().map(|face| face.map(|v| v * step)).collect();
        let (near, far) = (mend(n, &faces), check((n - 1) * step as usize + 1, &far));
        prop_assert_eq!((far.dropped, far.flipped, far.edges_cut), (near.dropped, near.flipped, near.edges_cut));
    }

    /// Welding in one go is welding by hand and repairing then.
    #[test]
    fn welding_is_what_it_says((n, faces) in crowds(9), grid in prop::collection::vec(-1i8..2, 11)) {
        let positions: Vec<[f32; 3]> = grid[..n].iter().map(|&x| [f32::from(x) * 0.0, f32::from(x), 1.0]).collect();
        let first = |v: u32| positions.iter().position(|p| *p == positions[v as usize]).map_or(v, |v| v as u32);
        let by_hand: Vec<_> = faces.iter().map(|f| f.map(|v| if (v as usize) < n { first(v) } else { v })).collect();
        let (welded, by_hand) = (repair(n, &faces, &RepairOptions { weld: Some(&positions) }), mend(n, &by_hand));
        let welded = welded.expect("as many positions as vertices");
        check_sound(welded.vertex_count, &welded.faces);
        let origin = |repaired: &Repaired| -> Vec<_> {
            repaired.faces.iter().map(|f| f.map(|v| repaired.vertex_source[v as usize])).collect()
        };
        prop_assert_eq!(origin(&welded), origin(&by_hand));
        prop_assert_eq!((welded.dropped, welded.flipped), (by_hand.dropped, by_hand.flipped));
        prop_assert_eq!(welded.vertices_added, by_hand.vertices_added);
    }
}

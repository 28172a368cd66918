//! `Defects::of`: known meshes, and random ones against a slow count.

mod common;
mod slow;

use common::random::{crowds, crumpled};
use common::{TETRAHEDRON, corpus, grid};
use onering_core::defects::{Defects, Figure};
use proptest::prelude::*;
use std::collections::BTreeMap;

fn figures(vertex_count: usize, faces: &[[u32; 3]]) -> BTreeMap<&'static str, Figure> {
    Defects::of(vertex_count, faces).unwrap().figures().collect()
}

#[test]
fn the_corpus_has_its_figures() {
    for (name, vertex_count, faces, want) in corpus() {
        let got = figures(vertex_count, &faces);
        for (figure, value) in want.split_whitespace().map(|w| w.split_once('=').expect(w)) {
            assert_eq!(got[figure].to_string(), value, "{figure} of {name}");
        }
        assert_eq!(got, slow::figures(vertex_count, &faces), "{name}");
    }
}

#[test]
fn the_elements_are_named() {
    let faces = [[0, 1, 2], [9, 0, 1], [1, 0, 3], [5, 5, 4], [0, 1, 4], [2, 0, 1], [7, 6, 8], [6, 7, 0]];
    let lists = Defects::of(9, &faces).unwrap().lists;
    assert_eq!(lists.out_of_range_faces, [1]);
    assert_eq!(lists.degenerate_faces, [3]);
    assert_eq!(lists.duplicate_faces, [5]);
    assert_eq!(lists.nonmanifold_edges, [[0, 1]]);
    assert_eq!(lists.inconsistent_edges, [[0, 2], [1, 2]]);
    assert_eq!(lists.repeated_halfedges, [[0, 1], [1, 2], [2, 0]]);
    assert_eq!(lists.bowtie_vertices, [0]);
    assert_eq!(lists.nonmanifold_vertices, [0, 1]);
    assert_eq!(lists.isolated_vertices, vec![5..6]);
}

#[test]
fn a_patch_without_orientation_is_named_by_its_first_face() {
    let (vertices, strip) = grid(6, 2, [true, false], true);
    let moved = strip.iter().map(|face| face.map(|v| v + 4));
    let faces: Vec<_> = TETRAHEDRON.into_iter().chain([[3, 3, 3]]).chain(moved).collect();
    let defects = Defects::of(vertices + 4, &faces).unwrap();
    assert_eq!((defects.patches, defects.lists.nonorientable_patches), (2, vec![5]));
}

#[test]
fn the_verdict_says_what_is_in_the_way() {
    assert_eq!(Defects::of(4, &TETRAHEDRON).unwrap().to_string(), "clean: every backend accepts it");
    assert!(Defects::of(3, &[[0, 1, 2], [0, 2, 1]]).unwrap().is_clean());
    let defects =
        Defects::of(5, &[[0, 0, 1], [0, 1, 2], [1, 0, 3], [0, 1, 4], [1, 1, 2], [1, 2, 9]]).unwrap();
    assert_eq!(defects.to_string(), "1 out-of-range face, 2 degenerate faces, 1 non-manifold edge");
}

#[test]
fn the_vertex_count_costs_nothing() {
    let faces = [[0, 4_000_000_000, 7], [u32::MAX, 7, 4_000_000_000], [u32::MAX, 1, 1]];
    let defects = Defects::of(usize::MAX, &faces).unwrap();
    assert_eq!((defects.edges, defects.components, defects.isolated_vertices), (5, 1, usize::MAX - 4));
    assert_eq!(defects.lists.isolated_vertices.last(), Some(&(u32::MAX as usize + 1..usize::MAX)));
    assert_eq!(defects.lists.isolated_vertices.len(), 4);
    assert_eq!(Defects::of(usize::MAX, &[]).unwrap().isolated_vertices, usize::MAX);
    assert_eq!(Defects::of(0, &faces).unwrap().out_of_range_faces, 3);
    // The same mesh with and without numbers that need compacting.
    let near = Defects::of(8, &[[0, 6, 4], [7, 4, 6], [7, 1, 1]]).unwrap();
    assert_eq!((near.euler, near.boundary_loops, near.degenerate_faces), (1, Some(1), 1));
    assert_eq!((defects.euler, defects.boundary_loops, defects.degenerate_faces), (1, Some(1), 1));
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn random_lists_count_as_the_slow_way((n, faces) in crowds(14)) {
        prop_assert_eq!(figures(n, &faces), slow::figures(n, &faces));
    }

    #[test]
    fn crumpled_surfaces_count_as_the_slow_way((n, faces) in crumpled()) {
        prop_assert_eq!(figures(n, &faces), slow::figures(n, &faces));
    }

    /// Numbers far apart go another way; what they name must not matter.
    #[test]
    fn sparse_numbers_change_nothing((n, faces) in crowds(14), step in 1u32..200_000_000) {
        let far: Vec<_> = faces.iter().map(|face| face.map(|v| v * step)).collect();
        let (near, far) = (Defects::of(n, &faces).unwrap(), Defects::of((n - 1) * step as usize + 1, &far).unwrap());
        let mut figures: BTreeMap<_, _> = far.figures().collect();
        figures.insert("isolated_vertices", near.isolated_vertices.into());
        prop_assert_eq!(figures, near.figures().collect());
        let scaled = |list: &[u32]| list.iter().map(|&v| v * step).collect::<Vec<_>>();
        prop_assert_eq!(far.lists.bowtie_vertices, scaled(&near.lists.bowtie_vertices));
        prop_assert_eq!(far.lists.duplicate_faces, near.lists.duplicate_faces);
    }
}

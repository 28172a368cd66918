//! The adjacency graph, with hand-counted expectations.
use crate::meshes::*;
use onering::*;

fn build(vertex_count: usize, faces: &[[u32; 3]]) -> AdjacencyGraph {
    let mesh = AdjacencyGraph::from_faces(vertex_count, faces).unwrap();
    assert_eq!(mesh.to_faces(), faces);
    mesh
}

#[test]
fn lists_are_rings_in_order() {
    let mesh = build(8, &wheel(6));
    assert_eq!(indices(mesh.one_ring(v(0))), [2, 3, 4, 5, 6, 1]);
    assert_eq!(indices(mesh.neighbours(v(1))), [2, 0, 6]);
    assert_eq!(mesh.one_ring(v(7)).count() + mesh.neighbours(v(7)).count(), 0);
    // 12 edges.
    assert_eq!(mesh.heap_bytes(), (24 * 6 + 4 * 8) + (4 * 9 + 8 * 12));
    assert_eq!(AdjacencyGraph::BYTES.per_triangle(), 26 + 14);
}

#[test]
fn the_first_of_several_fans_comes_first() {
    let bowtie = build(5, &[[0, 1, 2], [0, 3, 4]]);
    assert_eq!(indices(bowtie.neighbours(v(0))), [1, 2, 3, 4]);
    assert_eq!(indices(bowtie.one_ring(v(0))), [1, 2]);
    assert_eq!(indices(bowtie.one_ring(v(1))), [2, 0]);
    let tetrahedra = build(7, &two_tetrahedra());
    assert_eq!(
        (tetrahedra.one_ring(v(0)).count(), sorted(tetrahedra.neighbours(v(0)))),
        (3, vec![1, 2, 3, 4, 5, 6])
    );
}

#[test]
fn a_neighbour_that_fans_share_is_listed_once() {
    let mesh = build(5, &book(3));
    assert_eq!(indices(mesh.neighbours(v(0))), [1, 2, 3, 4]);
    assert_eq!(indices(mesh.one_ring(v(0))), [1, 2]);
    assert_eq!(sorted(mesh.edge_fan(h(3))), [0, 3, 6]);
    // A record of the edge, two of its ends; seven edges.
    assert_eq!(mesh.heap_bytes(), (24 * 3 + 4 * 5 + 4 * 4 + 2 * 4 * 4) + (4 * 6 + 8 * 7));
    let many = build(100_002, &book(100_000));
    assert_eq!((many.neighbours(v(0)).count(), many.neighbours(v(5)).count()), (100_001, 2));
}

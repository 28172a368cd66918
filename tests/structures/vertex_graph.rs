//! The graph of TopTri, with hand-counted expectations.
use crate::meshes::*;
use crate::random::lists;
use onering::*;
use proptest::prelude::*;
use std::collections::BTreeSet;

fn build(vertex_count: usize, faces: &[[u32; 3]]) -> VertexGraph {
    let graph = VertexGraph::from_faces(vertex_count, faces).unwrap();
    let (v, e) = (graph.vertex_count(), graph.edge_count());
    assert_eq!(graph.heap_bytes(), 4 * (v + 1) + 8 * e);
    assert_eq!(graph.edges().count(), e);
    graph
}

/// Figure 1 of the paper, its vertices counted from 0.
fn figure_1() -> VertexGraph {
    build(5, &[[0, 1, 2], [0, 2, 3], [0, 3, 4]])
}

fn lists_of<const N: usize>(all: impl Iterator<Item = [VertexId; N]>) -> Vec<[usize; N]> {
    all.map(|one| one.map(Handle::index)).collect()
}

#[test]
fn the_lists_of_figure_1() {
    let graph = figure_1();
    assert_eq!((graph.vertex_count(), graph.edge_count()), (5, 7));
    let expected: [&[usize]; 5] = [&[1, 2, 3, 4], &[0, 2], &[0, 1, 3], &[0, 2, 4], &[0, 3]];
    for (i, &list) in expected.iter().enumerate() {
        assert_eq!(indices(graph.neighbours(v(i))), list);
        assert_eq!(indices(neighbours::Neighbours::neighbours(&graph, v(i))), list);
    }
}

#[test]
fn the_six_queries_on_figure_1() {
    let graph = figure_1();
    assert_eq!(lists_of(graph.vertex_edges(v(1))), [[1, 0], [1, 2]]);
    assert_eq!(lists_of(graph.vertex_faces(v(0))), [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    assert_eq!(lists_of(graph.vertex_faces(v(2))), [[2, 0, 1], [2, 0, 3]]);
    assert_eq!(lists_of(graph.adjacent_edges([v(0), v(2)])), [[0, 1], [0, 3], [0, 4], [2, 1], [2, 3]]);
    assert_eq!(lists_of(graph.edge_faces([v(0), v(2)])), [[0, 2, 1], [0, 2, 3]]);
    assert_eq!(lists_of(graph.adjacent_faces([v(0), v(2), v(3)])), [[0, 2, 1], [3, 0, 4]]);
    // 1 and 3 share two neighbours, but no edge.
    assert_eq!(graph.edge_faces([v(1), v(3)]).count(), 0);
}

#[test]
fn a_cycle_is_not_always_a_face() {
    let bipyramid = [[0, 1, 3], [1, 2, 3], [2, 0, 3], [1, 0, 4], [2, 1, 4], [0, 2, 4]];
    let graph = build(5, &bipyramid);
    assert_eq!((graph.edge_count(), graph.faces().count()), (9, 7));
    assert!(lists_of(graph.faces()).contains(&[0, 1, 2]));
    assert_eq!((graph.vertex_faces(v(0)).count(), graph.vertex_faces(v(3)).count()), (5, 3));

    let open = build(4, &TETRAHEDRON[..3]);
    assert_eq!((open.edge_count(), open.faces().count()), (6, 4));
    assert_eq!(open.adjacent_faces([v(0), v(1), v(3)]).count(), 3);
}

#[test]
fn any_list_in_range_is_a_graph() {
    let graph = build(4, &[[0, 0, 1], [2, 2, 2], [1, 0, 1], [0, 1, 1]]);
    assert_eq!((graph.edge_count(), indices(graph.neighbours(v(0)))), (1, vec![1]));
    assert_eq!(graph.neighbours(v(2)).len(), 0);
    assert_eq!(build(9, &book(7)).edge_count(), 1 + 2 * 7);
    assert_eq!(build(0, &[]).heap_bytes(), 4);
    assert!(VertexGraph::from_faces(4, &TETRAHEDRON).unwrap().has_edge(v(3), v(0)));
}

#[test]
fn a_hub_is_linear() {
    let n = 100_000;
    let graph = VertexGraph::from_face_vec(n + 1, shuffled(wheel(n as u32))).unwrap();
    assert_eq!((graph.neighbours(v(0)).len(), graph.edge_count()), (n, 2 * n));
    assert_eq!((graph.vertex_faces(v(0)).count(), graph.faces().count()), (n, n));
    assert_eq!(indices(graph.neighbours(v(n))), [0, 1, n - 1]);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn queries_are_as_a_slow_search_says((n, faces) in lists()) {
        if let Ok(graph) = VertexGraph::from_faces(n, &faces) {
            check_graph(&graph, &faces);
        }
    }
}

fn check_graph(graph: &VertexGraph, faces: &[[u32; 3]]) {
    let n = graph.vertex_count();
    let sides = faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let joined: BTreeSet<_> = sides.flat_map(|[a, b]| [[a, b], [b, a]]).filter(|[a, b]| a != b).collect();
    let is_joined = |a: usize, b: usize| joined.contains(&[a as u32, b as u32]);
    let mut cycles = Vec::new();
    for a in 0..n {
        assert!(
            indices(graph.neighbours(v(a))).into_iter().eq((0..n).filter(|&b| is_joined(a, b))),
            "{faces:?}"
        );
        for b in (a + 1..n).filter(|&b| is_joined(a, b)) {
            cycles.extend((b + 1..n).filter(|&c| is_joined(a, c) && is_joined(b, c)).map(|c| [a, b, c]));
        }
    }
    assert_eq!(lists_of(graph.faces()), cycles, "{faces:?}");
    for a in 0..n {
        let through = cycles.iter().filter(|f| f.contains(&a)).count();
        assert_eq!(graph.vertex_faces(v(a)).count(), through, "{faces:?}");
    }
    for &[a, b, c] in &cycles {
        let shared = |f: &&[usize; 3]| f.iter().filter(|&x| [a, b, c].contains(x)).count() == 2;
        let adjacent = graph.adjacent_faces([v(a), v(b), v(c)]).count();
        assert_eq!(adjacent, cycles.iter().filter(shared).count(), "{faces:?}");
    }
}

//! The graph of TopTri, with hand-counted expectations.
use crate::meshes::*;
use onering::*;

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

fn lists<const N: usize>(all: impl Iterator<Item = [VertexId; N]>) -> Vec<[usize; N]> {
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
    assert_eq!(lists(graph.vertex_edges(v(1))), [[1, 0], [1, 2]]);
    assert_eq!(lists(graph.vertex_faces(v(0))), [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
    assert_eq!(lists(graph.vertex_faces(v(2))), [[2, 0, 1], [2, 0, 3]]);
    assert_eq!(lists(graph.adjacent_edges([v(0), v(2)])), [[0, 1], [0, 3], [0, 4], [2, 1], [2, 3]]);
    assert_eq!(lists(graph.edge_faces([v(0), v(2)])), [[0, 2, 1], [0, 2, 3]]);
    assert_eq!(lists(graph.adjacent_faces([v(0), v(2), v(3)])), [[0, 2, 1], [3, 0, 4]]);
    // 1 and 3 share two neighbours, but no edge.
    assert_eq!(graph.edge_faces([v(1), v(3)]).count(), 0);
}

#[test]
fn a_cycle_is_not_always_a_face() {
    let bipyramid = [[0, 1, 3], [1, 2, 3], [2, 0, 3], [1, 0, 4], [2, 1, 4], [0, 2, 4]];
    let graph = build(5, &bipyramid);
    assert_eq!((graph.edge_count(), graph.faces().count()), (9, 7));
    assert!(lists(graph.faces()).contains(&[0, 1, 2]));
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
    let error = VertexGraph::from_faces(3, &[[0, 1, 2], [0, 1, 3]]).err();
    assert_eq!(error, Some(BuildError::VertexOutOfRange { face: 1, vertex: 3, vertex_count: 3 }));
    assert!(VertexGraph::from_faces(usize::MAX, &[]).is_err());
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

//! Winged edges, with hand-counted expectations.
use crate::meshes::*;
use onering::*;

/// Two faces. Edges in order of their first side: 0-1, 1-2, 2-0, then 1-3, 3-2.
const STRIP: [[u32; 3]; 2] = [[0, 1, 2], [2, 1, 3]];

#[test]
fn half_edges_have_gaps_at_the_boundary() {
    let mesh = WingedEdge::from_faces(4, &STRIP).unwrap();
    assert_eq!(indices(mesh.half_edges()), [0, 2, 3, 4, 6, 8]);
    assert_eq!((mesh.half_edge_count(), mesh.half_edge_bound(), mesh.edge_count()), (6, 10, 5));
    assert_eq!(
        (mesh.opposite(h(2)), mesh.opposite(h(3)), mesh.opposite(h(0))),
        (Some(h(3)), Some(h(2)), None)
    );
    assert_eq!(mesh.heap_bytes(), 32 * 5 + 4 * 4 + 4 * 2);
}

#[test]
fn the_orientation_test_finds_the_side() {
    let mesh = WingedEdge::from_faces(4, &STRIP).unwrap();
    // Face 1 runs 2->1 (the second side of edge 1), 1->3, 3->2.
    assert_eq!((mesh.first(f(1)), mesh.next(h(3)), mesh.prev(h(3))), (h(3), h(6), h(8)));
    assert_eq!((mesh.face(h(2)), mesh.face(h(3))), (f(0), f(1)));
    assert_eq!((mesh.origin(h(3)), mesh.target(h(3))), (v(2), v(1)));
    for (mesh, faces) in
        [(mesh, &STRIP[..]), (WingedEdge::from_faces(4, &TETRAHEDRON).unwrap(), &TETRAHEDRON)]
    {
        assert_eq!(mesh.to_faces(), faces);
        assert!(mesh.half_edges().all(|h| mesh.next(mesh.prev(h)) == h && mesh.prev(mesh.next(h)) == h));
        assert!(mesh.half_edges().all(|h| mesh.target(h) == mesh.origin(mesh.next(h))));
    }
}

#[test]
fn edges_are_the_handles_halved() {
    let mesh = WingedEdge::from_faces(4, &STRIP).unwrap();
    assert_eq!(indices(mesh.half_edges().map(|h| mesh.edge(h))), [0, 1, 1, 2, 3, 4]);
    assert!(mesh.edges().all(|e| mesh.edge(mesh.half_edge(e)) == e));
    assert_eq!(mesh.edge_vertices(EdgeId::new(4)), [v(3), v(2)]);
}

#[test]
#[should_panic(expected = "no face")]
fn a_gap_is_no_half_edge() {
    let mesh = WingedEdge::from_faces(4, &STRIP).unwrap();
    mesh.next(h(1));
}

//! The half-edge structure, with hand-counted expectations.
use crate::meshes::*;
use onering::*;

#[test]
fn a_tetrahedron() {
    let mesh = HalfEdgeMesh::from_faces(5, &TETRAHEDRON).unwrap();
    assert_eq!(mesh.to_faces(), TETRAHEDRON);
    assert_eq!(mesh.heap_bytes(), 60 * 4 + 4 * 5);
    // 0->1 of (0, 1, 3) and of (1, 0, 2).
    assert_eq!(mesh.opposite(h(0)), Some(h(6)));
    assert_eq!((mesh.next(h(5)), mesh.prev(h(3)), mesh.face(h(5))), (h(3), h(5), f(1)));
    assert_eq!((sorted(mesh.one_ring(v(2))), mesh.outgoing(v(4))), (vec![0, 1, 3], None));
}

#[test]
fn an_open_fan_starts_at_its_clockwise_end() {
    let mesh = HalfEdgeMesh::from_faces(6, &[[0, 3, 4], [0, 1, 2], [0, 4, 5], [0, 2, 3]]).unwrap();
    assert_eq!(indices(mesh.one_ring(v(0))), [1, 2, 3, 4, 5]);
    assert_eq!(indices(mesh.star(v(0))), [3, 9, 0, 6]);
}

#[test]
fn everything_else_is_refused() {
    refuses_all::<HalfEdgeMesh>();
}

#[test]
fn a_hub_is_linear() {
    hub::<HalfEdgeMesh>();
}

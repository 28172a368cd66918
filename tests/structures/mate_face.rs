//! Mate-Face, with hand-counted expectations.
use crate::meshes::*;
use crate::random::lists;
use onering::*;
use proptest::prelude::*;

fn build(vertex_count: usize, faces: &[[u32; 3]]) -> MateFace {
    let mesh = MateFace::from_faces(vertex_count, faces).unwrap();
    assert_eq!(mesh.to_faces(), faces);
    mesh
}

/// (fans, faces, neighbours in the first ring, neighbours) of a vertex.
fn counts(mesh: &MateFace, i: usize) -> [usize; 4] {
    let all = mesh.neighbours(v(i)).count();
    [mesh.fans(v(i)).count(), mesh.star(v(i)).count(), mesh.one_ring(v(i)).count(), all]
}

fn mates(mesh: &MateFace, face: usize) -> [Option<usize>; 3] {
    [0, 1, 2].map(|side| mesh.mate(f(face), side).map(Handle::index))
}

#[test]
fn mates_are_across_the_side_opposite_a_vertex() {
    let mesh = build(4, &TETRAHEDRON);
    // Cell 1 is (1, 2, 3): across (2, 3) lies cell 3, across (3, 1) cell 0, across (1, 2) cell 2.
    assert_eq!(mates(&mesh, 1), [Some(3), Some(0), Some(2)]);
    let strip = build(4, &[[0, 1, 2], [2, 1, 3]]);
    assert_eq!((mates(&strip, 0), mates(&strip, 1)), ([Some(1), None, None], [None, None, Some(0)]));
    assert_eq!(mesh.heap_bytes(), 24 * 4 + 4 * 4);
}

#[test]
fn a_closed_ring_is_counter_clockwise() {
    let mesh = build(7, &wheel(6));
    assert_eq!(indices(mesh.one_ring(v(0))), [2, 3, 4, 5, 6, 1]);
    assert_eq!(indices(mesh.one_ring(v(1))), [2, 0, 6]);
    assert_eq!(mesh.outgoing(v(0)), Some(h(0)));
}

#[test]
fn moebius_strip() {
    for faces in [MOEBIUS, MOEBIUS_TWISTED] {
        let mesh = build(5, &faces);
        assert!((0..5).all(|i| counts(&mesh, i) == [1, 3, 4, 4]));
        assert!((0..5).all(|i| mesh.star(v(i)).all(|h| mesh.origin(h) == v(i))));
        assert_eq!(mesh.half_edges().filter(|&h| mesh.is_boundary(h)).count(), 5);
        assert_eq!(mesh.heap_bytes(), 24 * 5 + 4 * 5);
    }
    let paired = |faces: [[u32; 3]; 5]| {
        let mesh = build(5, &faces);
        mesh.half_edges().filter(|&h| mesh.opposite(h).is_some()).count()
    };
    assert_eq!((paired(MOEBIUS), paired(MOEBIUS_TWISTED)), (8, 0));
}

#[test]
fn klein_bottle_has_one_closed_fan_at_each_vertex() {
    let (vertices, faces) = grid(4, 4, [true, true], true);
    let mesh = build(vertices, &faces);
    assert!((0..16).all(|i| counts(&mesh, i) == [1, 6, 6, 6]));
    assert!(mesh.half_edges().all(|h| !mesh.is_boundary(h) && mesh.edge_fan(h).count() == 2));
    assert!(mesh.half_edges().any(|h| mesh.opposite(h).is_none()));
}

#[test]
fn a_flipped_face_stays_in_the_fan() {
    let mut faces = wheel(6);
    faces[2].swap(1, 2);
    let mesh = build(7, &faces);
    assert_eq!(counts(&mesh, 0), [1, 6, 6, 6]);
    assert_eq!(indices(mesh.one_ring(v(0))), [2, 3, 4, 5, 6, 1]);
    // Face 2 is (0, 4, 3): its spokes are half-edges 6 and 8, next to 2->0 of face 1 ... and 0->4 of face 3.
    assert_eq!((mesh.opposite(h(6)), mesh.opposite(h(8))), (None, None));
    assert_eq!((indices(mesh.edge_fan(h(6))), indices(mesh.edge_fan(h(8)))), (vec![6, 9], vec![8, 5]));
    assert!(!mesh.is_boundary(h(6)) && mesh.is_boundary(h(7)));
}

#[test]
fn an_open_fan_of_two_faces_that_disagree_starts_at_an_end() {
    let mesh = build(4, &[[0, 1, 2], [0, 1, 3]]);
    assert_eq!((counts(&mesh, 0), counts(&mesh, 1)), ([1, 2, 3, 3], [1, 2, 3, 3]));
    assert_eq!((indices(mesh.one_ring(v(0))), indices(mesh.one_ring(v(1)))), (vec![2, 1, 3], vec![2, 0, 3]));
}

#[test]
fn several_fans_are_listed_open_ones_first() {
    let bowtie = build(5, &[[0, 1, 2], [0, 3, 4]]);
    assert_eq!(counts(&bowtie, 0), [2, 2, 2, 4]);
    assert_eq!(bowtie.heap_bytes(), 24 * 2 + 4 * 5 + 4 * 3);

    let tetrahedra = build(7, &two_tetrahedra());
    assert_eq!(counts(&tetrahedra, 0), [2, 6, 3, 6]);
    assert_eq!(indices(tetrahedra.fans(v(0))), [0, 12]);
    assert_eq!(tetrahedra.heap_bytes(), 24 * 8 + 4 * 7 + 4 * 3);

    let with_flap = build(6, &[&TETRAHEDRON[..], &[[4, 5, 0]]].concat());
    assert_eq!(indices(with_flap.fans(v(0))), [14, 0]);
    assert_eq!(counts(&with_flap, 0), [2, 4, 2, 5]);
}

#[test]
fn two_faces_can_be_mates_on_all_sides() {
    let pillow = build(3, &[[0, 1, 2], [0, 2, 1]]);
    assert_eq!(mates(&pillow, 0), [Some(1); 3]);
    assert_eq!([0, 1, 2].map(|i| pillow.opposite(h(i)).unwrap().index()), [5, 4, 3]);
    assert_eq!(indices(pillow.one_ring(v(0))), [2, 1]);
    assert!((0..3).all(|i| counts(&pillow, i) == [1, 2, 2, 2]));

    let twice = build(3, &[[0, 1, 2], [1, 2, 0]]);
    assert!(twice.half_edges().all(|h| twice.opposite(h).is_none() && !twice.is_boundary(h)));
    assert_eq!(indices(twice.edge_fan(h(0))), [0, 5]);
    assert!((0..3).all(|i| counts(&twice, i) == [1, 2, 2, 2]));
}

#[test]
fn a_hub_of_faces_that_disagree_is_linear() {
    // Half of the faces flipped: no walk by opposites would get round.
    let n = 100_000;
    let mut faces = shuffled(wheel(n as u32));
    faces.iter_mut().step_by(2).for_each(|f| f.swap(1, 2));
    let mesh = MateFace::from_face_vec(n + 1, faces).unwrap();
    assert_eq!(counts(&mesh, 0), [1, n, n, n]);
}

#[test]
fn many_fans_at_one_vertex_are_linear() {
    let n = 100_000;
    let faces = (0..n as u32).map(|i| [2 * i + 1, 0, 2 * i + 2]).collect();
    let mesh = MateFace::from_face_vec(2 * n + 1, shuffled(faces)).unwrap();
    assert_eq!(counts(&mesh, 0), [n, n, 2, 2 * n]);
    assert_eq!(mesh.heap_bytes(), 24 * n + 4 * (2 * n + 1) + 4 * (n + 1));
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    /// Fans go on across edges of two faces that disagree, and those that end at a boundary come first.
    #[test]
    fn open_fans_come_first((n, faces) in lists()) {
        let Ok(mesh) = MateFace::from_faces(n, &faces) else { return Ok(()) };
        for v in mesh.vertices() {
            let starts: Vec<_> = mesh.fans(v).collect();
            let mut open = Vec::new();
            for h in mesh.star(v) {
                if starts.get(open.len()) == Some(&h) {
                    open.push(false);
                }
                *open.last_mut().unwrap() |= mesh.is_boundary(h) || mesh.is_boundary(mesh.prev(h));
            }
            prop_assert!(open.is_sorted_by(|a, b| a >= b), "{v:?} of {faces:?}: {open:?}");
        }
    }
}

//! Each known defect of the original implementations and of the printed algorithms has a test here that would
//! catch it, run on every backend that has the ability. Expectations are counted by hand.
//!
//! "CHE" is the C++ code of Lage, Lewiner, Lopes and Velho for their compact half-edge (2006). Algorithms 1 and 2
//! are those of Biscaro et al. (2016).
#[path = "common/shapes.rs"]
mod shapes;

use onering::*;
use std::sync::LazyLock;

/// More steps than any walk here has: a walk that does not end fails instead of hanging.
const MANY: usize = 1000;

/// A closed fan of six faces around vertex 0. The rim is on the boundary.
static WHEEL: LazyLock<Vec<[u32; 3]>> = LazyLock::new(|| shapes::wheel(6));

/// Two boundary curves of four: inner vertices 0 to 3, outer ones 4 to 7.
const ANNULUS: [[u32; 3]; 8] =
    [[0, 4, 5], [0, 5, 1], [1, 5, 6], [1, 6, 2], [2, 6, 7], [2, 7, 3], [3, 7, 4], [3, 4, 0]];

/// Three boundary curves.
const THREE_TRIANGLES: [[u32; 3]; 3] = [[0, 1, 2], [3, 4, 5], [6, 7, 8]];

/// No boundary.
const OCTAHEDRON: [[u32; 3]; 8] =
    [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1], [5, 2, 1], [5, 3, 2], [5, 4, 3], [5, 1, 4]];

fn build<M: FromFaces>(faces: &[[u32; 3]]) -> M {
    let vertices = faces.as_flattened().iter().max().map_or(0, |&v| v as usize + 1);
    M::from_faces(vertices, faces).unwrap()
}

fn holds(backend: &str, defect: &str) -> bool {
    registry::BACKENDS.iter().find(|entry| entry.name == backend).unwrap().holds.contains(&defect)
}

fn indices<H: Handle>(handles: impl Iterator<Item = H>) -> Vec<usize> {
    handles.take(MANY).map(Handle::index).collect()
}

/// The half-edge that runs from `a` to `b`, the first in the list.
fn along<M: Topology>(mesh: &M, a: usize, b: usize) -> M::HalfEdge {
    let runs = |&h: &M::HalfEdge| (mesh.origin(h).index(), mesh.target(h).index()) == (a, b);
    mesh.half_edges().find(runs).unwrap()
}

/// CHE: `compute_CH` stops after the first curve.
fn all_curves_are_found<M: FromFaces + Adjacency>() {
    let lengths = |faces: &[[u32; 3]]| {
        let mesh: M = build(faces);
        let length = |h| boundary::Curve::new(&mesh, h).take(MANY).count();
        boundary::curves(&mesh).into_iter().map(length).collect::<Vec<_>>()
    };
    assert_eq!(lengths(&WHEEL), [6]);
    assert_eq!(lengths(&ANNULUS), [4, 4]);
    assert_eq!(lengths(&THREE_TRIANGLES), [3, 3, 3]);
    assert!(lengths(&OCTAHEDRON).is_empty());
}

/// CHE, both stored: `compute_CH`, and `CH(k)`, which returns `VH[k]`: the start of the vertex with the number of
/// the curve.
fn a_curve_starts_on_itself<M: FromFaces + Boundaries>() {
    for (faces, curves) in
        [(&WHEEL[..], 1), (&ANNULUS[..], 2), (&THREE_TRIANGLES[..], 3), (&OCTAHEDRON[..], 0)]
    {
        let mesh: M = build(faces);
        assert_eq!(mesh.curve_count(), curves);
        for c in mesh.curves() {
            assert!(mesh.is_boundary(mesh.curve_start(c)));
            assert_eq!(mesh.curve_of(mesh.curve_start(c)), Some(c));
            assert!(mesh.curve(c).take(MANY).all(|h| mesh.curve_of(h) == Some(c)));
        }
    }
    // Vertex 0 is inside: its outgoing is on no curve, and curve 0 is the rim.
    let wheel: M = build(&WHEEL);
    let rim = wheel.curve(Handle::new(0)).map(|h| wheel.origin(h));
    assert_eq!(indices(rim), [1, 2, 3, 4, 5, 6]);
}

/// CHE: the faces around a vertex, level 1: a stray semicolon leaves the last one only. From any of its
/// half-edges, both turns together see them all.
fn both_turns_see_every_face<M: FromFaces + Adjacency>() {
    let around = |mesh: &M, h| {
        let ccw = core::iter::successors(Some(h), |&g| mesh.rotate_ccw(g).filter(|&g| g != h));
        let cw = core::iter::successors(mesh.rotate_cw(h), |&g| mesh.rotate_cw(g).filter(|&g| g != h));
        let mut seen = indices(ccw.chain(cw));
        seen.sort_unstable();
        seen.dedup(); // a closed fan is seen twice
        seen
    };
    for faces in [&WHEEL[..], &ANNULUS[..], &OCTAHEDRON[..]] {
        let mesh: M = build(faces);
        for h in mesh.half_edges() {
            let same_origin = mesh.half_edges().filter(|&g| mesh.origin(g) == mesh.origin(h));
            assert_eq!(around(&mesh, h), indices(same_origin));
        }
    }
}

/// CHE: rotation from a boundary start stops after one face. Biscaro et al.: Algorithms 1 and 2 do not stop at a
/// boundary.
fn a_turn_from_the_boundary_sees_the_whole_fan<M: FromFaces + Incidence>() {
    let wheel: M = build(&WHEEL);
    let v = M::Vertex::new;
    for i in 1..=6 {
        assert_eq!(wheel.star(v(i)).take(MANY).count(), 2);
        assert_eq!(wheel.one_ring(v(i)).take(MANY).count(), 3);
        assert_eq!(wheel.opposite(wheel.outgoing(v(i)).unwrap()), None);
    }
    assert_eq!(indices(wheel.one_ring(v(1))), [2, 0, 6]);
    // Listed so that the start in the list is no end of the fan.
    let half: M = build(&[[0, 3, 4], [0, 1, 2], [0, 4, 5], [0, 2, 3]]);
    assert_eq!(indices(half.one_ring(v(0))), [1, 2, 3, 4, 5]);
    assert_eq!(indices(half.star(v(0)).map(|h| half.target(h))), [1, 2, 3, 4]);
}

/// Biscaro et al.: Algorithm 2 as printed, `opposite(next(h))`, turns about the neighbour.
fn a_turn_is_about_its_own_vertex<M: FromFaces + Incidence>() {
    for faces in [&WHEEL[..], &ANNULUS[..], &OCTAHEDRON[..]] {
        let mesh: M = build(faces);
        for v in mesh.vertices() {
            assert!(mesh.star(v).take(MANY).all(|h| mesh.origin(h) == v));
        }
    }
    let wheel: M = build(&WHEEL);
    assert_eq!(indices(wheel.one_ring(M::Vertex::new(0))), [2, 3, 4, 5, 6, 1]);
    let octahedron: M = build(&OCTAHEDRON);
    let mut ring = indices(octahedron.one_ring(M::Vertex::new(2)));
    ring.sort_unstable();
    assert_eq!(ring, [0, 1, 3, 5]);
}

/// CHE: faces on an edge of four are paired two by two in silence.
fn an_edge_of_four_faces_is_refused_or_held<M: FromFaces + Adjacency>(backend: &str) {
    let faces = [[0, 1, 2], [1, 0, 3], [0, 1, 4], [1, 0, 5]];
    if !holds(backend, "non_manifold_edge") {
        let error = BuildError::NonManifoldEdge { vertices: [0, 1], faces: 4, face: 2 };
        assert_eq!(M::from_faces(6, &faces).err(), Some(error));
        return;
    }
    let mesh: M = build(&faces);
    for f in mesh.faces() {
        let h = mesh.first(f);
        assert_eq!((mesh.opposite(h), mesh.is_boundary(h), mesh.edge_fan(h).count()), (None, false, 4));
        assert_eq!(mesh.edge_fan(h).next(), Some(h));
    }
}

/// CHE: two faces that run in the same direction are paired as opposites.
fn a_same_direction_pair_is_refused_or_held<M: FromFaces + Adjacency>(backend: &str) {
    let faces = [[0, 1, 2], [0, 1, 3]];
    if !holds(backend, "same_direction") {
        let error = BuildError::SameDirection { vertices: [0, 1], faces: [0, 1] };
        assert_eq!(M::from_faces(4, &faces).err(), Some(error));
        return;
    }
    let mesh: M = build(&faces);
    let [g, h] = [0, 1].map(|f| mesh.first(Handle::new(f)));
    for (h, other) in [(g, h), (h, g)] {
        assert_eq!((mesh.opposite(h), mesh.is_boundary(h)), (None, false));
        assert!(mesh.edge_fan(h).eq([h, other]));
    }
}

/// CHE: `orient()` reaches only the component of face 0. One face of each of three components is turned over here.
fn every_component_is_oriented<M: FromFaces + Adjacency>() {
    let mut faces = Vec::new();
    for first in [0, 4, 8] {
        faces.extend(shapes::TETRAHEDRON.map(|f| f.map(|v| v + first)));
        faces.last_mut().unwrap().swap(0, 1);
    }
    let repaired = repair::repair(12, &faces, &Default::default()).unwrap();
    assert_eq!(
        (repaired.faces.len(), repaired.vertex_count, &repaired.flipped[..]),
        (12, 12, &[3, 7, 11][..])
    );
    let mesh: M = build(&repaired.faces);
    assert!(mesh.half_edges().all(|h| mesh.opposite(h).is_some()));
}

/// CHE: queries across an edge use the link of a boundary half-edge unguarded.
fn there_is_nothing_across_a_boundary<M: FromFaces + Adjacency>() {
    let mesh: M = build(&[[0, 1, 2]]);
    for h in mesh.half_edges() {
        assert_eq!((mesh.opposite(h), mesh.rotate_ccw(h), mesh.rotate_cw(h)), (None, None, None));
        assert!(mesh.is_boundary(h) && mesh.edge_fan(h).eq([h]));
    }
    let wheel: M = build(&WHEEL);
    let (spoke, rim) = (along(&wheel, 0, 1), along(&wheel, 1, 2));
    assert_eq!((wheel.is_boundary(spoke), wheel.is_boundary(rim)), (false, true));
    assert_eq!(wheel.edge_fan(rim).count(), 1);
    assert_eq!(wheel.opposite(spoke), Some(along(&wheel, 1, 0)));
}

/// The same for edges: one of a boundary has a name and two ends as well.
fn a_boundary_edge_has_a_name<M: FromFaces + EdgeMap>() {
    let wheel: M = build(&WHEEL);
    assert_eq!(wheel.edge_count(), 12);
    let rim = along(&wheel, 1, 2);
    assert_eq!(wheel.half_edge(wheel.edge(rim)), rim);
    assert_eq!(wheel.edge_vertices(wheel.edge(rim)).map(Handle::index), [1, 2]);
}

/// TopTri (Figueiredo et al., 2014) takes every 3-cycle of its graph for a face. What is a `Topology` does not.
fn faces_are_those_of_the_input<M: FromFaces + Topology>() {
    let bipyramid = [[0, 1, 3], [1, 2, 3], [2, 0, 3], [1, 0, 4], [2, 1, 4], [0, 2, 4]];
    assert_eq!(build::<M>(&bipyramid).to_faces(), bipyramid);
    assert_eq!(build::<M>(&OCTAHEDRON[..7]).to_faces(), OCTAHEDRON[..7]);
}

macro_rules! run {
    ($mesh:ty: $($check:ident($($arg:expr)?))+) => {
        $(#[test] fn $check() { super::$check::<$mesh>($($arg)?); })+
    };
}

macro_rules! of_trait {
    (topology $text:literal $mesh:ty) => {
        run! { $mesh: faces_are_those_of_the_input() }
    };
    (adjacency $text:literal $mesh:ty) => {
        run! { $mesh:
            all_curves_are_found()
            both_turns_see_every_face()
            an_edge_of_four_faces_is_refused_or_held($text)
            a_same_direction_pair_is_refused_or_held($text)
            every_component_is_oriented()
            there_is_nothing_across_a_boundary()
        }
    };
    (incidence $text:literal $mesh:ty) => {
        run! { $mesh: a_turn_from_the_boundary_sees_the_whole_fan() a_turn_is_about_its_own_vertex() }
    };
    (edge_map $text:literal $mesh:ty) => {
        run! { $mesh: a_boundary_edge_has_a_name() }
    };
    (boundaries $text:literal $mesh:ty) => {
        run! { $mesh: a_curve_starts_on_itself() }
    };
    // A graph has no faces to get wrong: its own test says how 3-cycles differ.
    (graph $text:literal $mesh:ty) => {};
}

macro_rules! every_backend {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {
        $(mod $name { $(of_trait! { $has $text $mesh })* })+
    };
}
with_backends!(every_backend);

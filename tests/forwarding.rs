//! References and adaptors hand on every method: where a mesh overrides a provided one, it is the override that is
//! called.
use onering::{handle::Handles, *};
use std::cell::RefCell;

thread_local! {
    static CALLED: RefCell<Vec<&'static str>> = const { RefCell::new(Vec::new()) };
}

/// A triangle that says which of its methods was called.
#[derive(Clone, Copy, Debug)]
struct Probe;

fn called(method: &'static str) {
    CALLED.with_borrow_mut(|called| called.push(method));
}

macro_rules! probe {
    ($(fn $method:ident($($arg:ident: $kind:ty)?) -> $out:ty = $value:expr;)+) => {$(
        fn $method(&self $(, $arg: $kind)?) -> $out {
            called(stringify!($method));
            $(let _ = $arg;)?
            $value
        }
    )+};
}

fn h(index: usize) -> HalfEdgeId {
    HalfEdgeId::new(index)
}

fn v(index: usize) -> VertexId {
    VertexId::new(index)
}

impl Topology for Probe {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    probe! {
        fn vertex_count() -> usize = 3;
        fn face_count() -> usize = 1;
        fn half_edge_count() -> usize = 3;
        fn half_edge_bound() -> usize = 3;
        fn origin(x: HalfEdgeId) -> VertexId = v(x.index());
        fn target(x: HalfEdgeId) -> VertexId = v((x.index() + 1) % 3);
        fn next(x: HalfEdgeId) -> HalfEdgeId = h((x.index() + 1) % 3);
        fn prev(x: HalfEdgeId) -> HalfEdgeId = h((x.index() + 2) % 3);
        fn face(x: HalfEdgeId) -> FaceId = FaceId::new(0);
        fn first(x: FaceId) -> HalfEdgeId = h(0);
        fn face_half_edges(x: FaceId) -> [HalfEdgeId; 3] = [h(0), h(1), h(2)];
        fn face_vertices(x: FaceId) -> [VertexId; 3] = [v(0), v(1), v(2)];
        fn vertices() -> Handles<VertexId> = Handles::below(3);
        fn faces() -> Handles<FaceId> = Handles::below(1);
        fn half_edges() -> impl Iterator<Item = HalfEdgeId> = (0..3).map(h);
        fn to_faces() -> Vec<[u32; 3]> = vec![[0, 1, 2]];
    }
}

impl Adjacency for Probe {
    probe! {
        fn opposite(x: HalfEdgeId) -> Option<HalfEdgeId> = None;
        fn edge_fan(x: HalfEdgeId) -> impl Iterator<Item = HalfEdgeId> = std::iter::once(x);
        fn is_boundary(x: HalfEdgeId) -> bool = true;
        fn rotate_ccw(x: HalfEdgeId) -> Option<HalfEdgeId> = None;
        fn rotate_cw(x: HalfEdgeId) -> Option<HalfEdgeId> = None;
        fn turn(x: HalfEdgeId) -> (VertexId, Option<HalfEdgeId>) = (v(0), None);
    }
}

impl Incidence for Probe {
    probe! {
        fn outgoing(x: VertexId) -> Option<HalfEdgeId> = Some(h(x.index()));
        fn fans(x: VertexId) -> impl Iterator<Item = HalfEdgeId> = std::iter::once(h(x.index()));
        fn has_several_fans(x: VertexId) -> bool = false;
        fn star(x: VertexId) -> impl Iterator<Item = HalfEdgeId> = std::iter::once(h(x.index()));
        fn one_ring(x: VertexId) -> impl Iterator<Item = VertexId> = [v(1), v(2)].into_iter();
        fn neighbours(x: VertexId) -> impl Iterator<Item = VertexId> = [v(1), v(2)].into_iter();
    }
}

impl EdgeMap for Probe {
    type Edge = EdgeId;

    probe! {
        fn edge_count() -> usize = 3;
        fn edge(x: HalfEdgeId) -> EdgeId = EdgeId::new(x.index());
        fn half_edge(x: EdgeId) -> HalfEdgeId = h(x.index());
        fn edges() -> Handles<EdgeId> = Handles::below(3);
        fn edge_vertices(x: EdgeId) -> [VertexId; 2] = [v(0), v(1)];
    }
}

impl Boundaries for Probe {
    type Curve = CurveId;

    probe! {
        fn curve_count() -> usize = 1;
        fn curve_start(x: CurveId) -> HalfEdgeId = h(0);
        fn curve_of(x: HalfEdgeId) -> Option<CurveId> = Some(CurveId::new(0));
        fn curves() -> Handles<CurveId> = Handles::below(1);
        fn curve(x: CurveId) -> impl Iterator<Item = HalfEdgeId> = [h(0), h(1), h(2)].into_iter();
    }
}

/// Calls methods of a trait on a mesh, and checks that each call came to the probe as itself, and nothing else did.
macro_rules! hands_on {
    ($mesh:expr, $name:ident: $($method:ident($($arg:expr)?))+) => {$({
        CALLED.with_borrow_mut(Vec::clear);
        let _ = $name::$method($mesh $(, $arg)?);
        CALLED.with_borrow(|called| assert_eq!(called[..], [stringify!($method)]));
    })+};
}

fn topology(mesh: &impl Topology<Vertex = VertexId, HalfEdge = HalfEdgeId, Face = FaceId>) {
    let f = FaceId::new(0);
    hands_on!(mesh, Topology:
        vertex_count() face_count() half_edge_count() half_edge_bound() origin(h(1)) target(h(1)) next(h(1)) prev(h(1))
        face(h(1)) first(f) face_half_edges(f) face_vertices(f) vertices() half_edges() faces() to_faces());
}

fn adjacency(mesh: &impl Adjacency<HalfEdge = HalfEdgeId>) {
    hands_on!(mesh, Adjacency:
        opposite(h(1)) edge_fan(h(1)) is_boundary(h(1)) rotate_ccw(h(1)) rotate_cw(h(1)) turn(h(1)));
}

fn incidence(mesh: &impl Incidence<Vertex = VertexId>) {
    hands_on!(mesh, Incidence:
        outgoing(v(1)) fans(v(1)) has_several_fans(v(1)) star(v(1)) one_ring(v(1)) neighbours(v(1)));
}

fn edge_map(mesh: &impl EdgeMap<HalfEdge = HalfEdgeId, Edge = EdgeId>) {
    let e = EdgeId::new(0);
    hands_on!(mesh, EdgeMap: edge_count() edge(h(1)) half_edge(e) edges() edge_vertices(e));
}

fn boundaries(mesh: &impl Boundaries<HalfEdge = HalfEdgeId, Curve = CurveId>) {
    let c = CurveId::new(0);
    hands_on!(mesh, Boundaries: curve_count() curve_start(c) curve_of(h(1)) curves() curve(c));
}

#[test]
fn references() {
    let mesh = &&Probe;
    topology(&mesh);
    adjacency(&mesh);
    incidence(&mesh);
    edge_map(&mesh);
    boundaries(&mesh);
}

#[test]
fn with_outgoing() {
    let mesh = WithOutgoing::new(Probe).unwrap();
    topology(&mesh);
    adjacency(&mesh);
    edge_map(&mesh);
    boundaries(&mesh);
}

#[test]
fn with_opposites() {
    let mesh = WithOpposites::new(Probe).unwrap();
    topology(&mesh);
    incidence(&mesh);
    edge_map(&mesh);
    boundaries(&mesh);
}

#[test]
fn searched() {
    topology(&Searched::new(Probe));
}

//! A shared reference is as good as the mesh: it forwards every method, so that no override is lost.
use crate::{Adjacency, Boundaries, EdgeMap, Footprint, Incidence, Topology, footprint::Bytes};
use alloc::vec::Vec;

macro_rules! forward {
    ($(fn $method:ident($($arg:ident: $kind:ty)?) -> $out:ty;)+) => {$(
        #[inline(always)]
        fn $method(&self $(, $arg: $kind)?) -> $out {
            T::$method(*self $(, $arg)?)
        }
    )+};
}

impl<T: Topology> Topology for &T {
    type Vertex = T::Vertex;
    type HalfEdge = T::HalfEdge;
    type Face = T::Face;

    forward! {
        fn vertex_count() -> usize;
        fn face_count() -> usize;
        fn half_edge_count() -> usize;
        fn half_edge_bound() -> usize;
        fn origin(h: T::HalfEdge) -> T::Vertex;
        fn target(h: T::HalfEdge) -> T::Vertex;
        fn next(h: T::HalfEdge) -> T::HalfEdge;
        fn prev(h: T::HalfEdge) -> T::HalfEdge;
        fn face(h: T::HalfEdge) -> T::Face;
        fn first(f: T::Face) -> T::HalfEdge;
        fn face_half_edges(f: T::Face) -> [T::HalfEdge; 3];
        fn face_vertices(f: T::Face) -> [T::Vertex; 3];
        fn half_edges() -> impl Iterator<Item = T::HalfEdge>;
        fn to_faces() -> Vec<[u32; 3]>;
    }
}

impl<T: Adjacency> Adjacency for &T {
    forward! {
        fn opposite(h: T::HalfEdge) -> Option<T::HalfEdge>;
        fn edge_fan(h: T::HalfEdge) -> impl Iterator<Item = T::HalfEdge>;
        fn is_boundary(h: T::HalfEdge) -> bool;
        fn rotate_ccw(h: T::HalfEdge) -> Option<T::HalfEdge>;
        fn rotate_cw(h: T::HalfEdge) -> Option<T::HalfEdge>;
    }
}

impl<T: Incidence> Incidence for &T {
    forward! {
        fn outgoing(v: T::Vertex) -> Option<T::HalfEdge>;
        fn fans(v: T::Vertex) -> impl Iterator<Item = T::HalfEdge>;
        fn star(v: T::Vertex) -> impl Iterator<Item = T::HalfEdge>;
        fn one_ring(v: T::Vertex) -> impl Iterator<Item = T::Vertex>;
        fn neighbours(v: T::Vertex) -> impl Iterator<Item = T::Vertex>;
    }
}

impl<T: EdgeMap> EdgeMap for &T {
    type Edge = T::Edge;

    forward! {
        fn edge_count() -> usize;
        fn edge(h: T::HalfEdge) -> T::Edge;
        fn half_edge(e: T::Edge) -> T::HalfEdge;
        fn edge_vertices(e: T::Edge) -> [T::Vertex; 2];
    }
}

impl<T: Boundaries> Boundaries for &T {
    type Curve = T::Curve;

    forward! {
        fn curve_count() -> usize;
        fn curve_start(c: T::Curve) -> T::HalfEdge;
        fn curve_of(h: T::HalfEdge) -> Option<T::Curve>;
        fn curve(c: T::Curve) -> impl Iterator<Item = T::HalfEdge>;
    }
}

impl<T: Footprint> Footprint for &T {
    const BYTES: Bytes = T::BYTES;

    forward! {
        fn heap_bytes() -> usize;
    }
}

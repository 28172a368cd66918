//! Methods that a wrapper hands on to the mesh inside, each trait's list written once.
//!
//! Provided methods are in the lists too, so that no override of the mesh is lost. What has to be named at every
//! use is the type of the mesh inside and how to reach it: `topology_of!(T, self => &self.mesh)`.

macro_rules! forward {
    ($T:ident, $self:ident => $inner:expr; $(fn $method:ident($($arg:ident: $kind:ty)?) -> $out:ty;)+) => {$(
        #[inline(always)]
        fn $method(&$self $(, $arg: $kind)?) -> $out {
            $T::$method($inner $(, $arg)?)
        }
    )+};
}

/// The whole of `Topology`.
macro_rules! topology_of {
    ($T:ident, $self:ident => $inner:expr) => {
        type Vertex = $T::Vertex;
        type HalfEdge = $T::HalfEdge;
        type Face = $T::Face;

        forward! { $T, $self => $inner;
            fn vertex_count() -> usize;
            fn face_count() -> usize;
            fn half_edge_count() -> usize;
            fn half_edge_bound() -> usize;
            fn origin(h: $T::HalfEdge) -> $T::Vertex;
            fn target(h: $T::HalfEdge) -> $T::Vertex;
            fn next(h: $T::HalfEdge) -> $T::HalfEdge;
            fn prev(h: $T::HalfEdge) -> $T::HalfEdge;
            fn face(h: $T::HalfEdge) -> $T::Face;
            fn first(f: $T::Face) -> $T::HalfEdge;
            fn face_half_edges(f: $T::Face) -> [$T::HalfEdge; 3];
            fn face_vertices(f: $T::Face) -> [$T::Vertex; 3];
            fn vertices() -> Handles<$T::Vertex>;
            fn half_edges() -> impl Iterator<Item = $T::HalfEdge>;
            fn faces() -> Handles<$T::Face>;
            fn to_faces() -> Vec<[u32; 3]>;
        }
    };
}

/// The whole of `Adjacency`.
macro_rules! adjacency_of {
    ($T:ident, $self:ident => $inner:expr) => {
        forward! { $T, $self => $inner;
            fn opposite(h: $T::HalfEdge) -> Option<$T::HalfEdge>;
            fn edge_fan(h: $T::HalfEdge) -> impl Iterator<Item = $T::HalfEdge>;
            fn is_boundary(h: $T::HalfEdge) -> bool;
            fn rotate_ccw(h: $T::HalfEdge) -> Option<$T::HalfEdge>;
            fn rotate_cw(h: $T::HalfEdge) -> Option<$T::HalfEdge>;
            fn turn(h: $T::HalfEdge) -> ($T::Vertex, Option<$T::HalfEdge>);
        }
    };
}

/// The whole of `Incidence`.
macro_rules! incidence_of {
    ($T:ident, $self:ident => $inner:expr) => {
        forward! { $T, $self => $inner;
            fn outgoing(v: $T::Vertex) -> Option<$T::HalfEdge>;
            fn fans(v: $T::Vertex) -> impl Iterator<Item = $T::HalfEdge>;
            fn has_several_fans(v: $T::Vertex) -> bool;
            fn star(v: $T::Vertex) -> impl Iterator<Item = $T::HalfEdge>;
            fn one_ring(v: $T::Vertex) -> impl Iterator<Item = $T::Vertex>;
            fn neighbours(v: $T::Vertex) -> impl Iterator<Item = $T::Vertex>;
        }
    };
}

/// The whole of `EdgeMap`.
macro_rules! edge_map_of {
    ($T:ident, $self:ident => $inner:expr) => {
        type Edge = $T::Edge;

        forward! { $T, $self => $inner;
            fn edge_count() -> usize;
            fn edge(h: $T::HalfEdge) -> $T::Edge;
            fn half_edge(e: $T::Edge) -> $T::HalfEdge;
            fn edges() -> Handles<$T::Edge>;
            fn edge_vertices(e: $T::Edge) -> [$T::Vertex; 2];
        }
    };
}

/// The whole of `Boundaries`.
macro_rules! boundaries_of {
    ($T:ident, $self:ident => $inner:expr) => {
        type Curve = $T::Curve;

        forward! { $T, $self => $inner;
            fn curve_count() -> usize;
            fn curve_start(c: $T::Curve) -> $T::HalfEdge;
            fn curve_of(h: $T::HalfEdge) -> Option<$T::Curve>;
            fn curves() -> Handles<$T::Curve>;
            fn curve(c: $T::Curve) -> impl Iterator<Item = $T::HalfEdge>;
        }
    };
}

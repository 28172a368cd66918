//! Every backend, once. Tests, benchmarks, the shell and the table in the README are made from this list.
//!
//! To add a backend: write its file, name it in `lib.rs`, and add its line here.
use crate::footprint::{Bytes, Footprint};

/// Calls `$then!` with every backend: its name (as a module, and as a feature and at the shell), its type, the traits
/// that it has (`graph` is [`Neighbours`](crate::neighbours::Neighbours) alone), and the defects that it holds as they
/// are; it refuses the others with a `BuildError`. A vertex out of range is refused by all.
#[macro_export]
macro_rules! with_backends {
    ($then:path) => { $then! {
        shared_vertex         "shared-vertex"         $crate::SharedVertex         [topology]                                        [degenerate non_manifold_edge same_direction several_fans];
        che_l0                "che-l0"                $crate::CheL0                [topology]                                        [degenerate non_manifold_edge same_direction several_fans];
        che_l1                "che-l1"                $crate::CheL1                [topology adjacency]                              [several_fans];
        che_l2                "che-l2"                $crate::CheL2                [topology adjacency incidence edge_map]           [];
        che_l2_edge_table     "che-l2-edge-table"     $crate::CheL2EdgeTable       [topology adjacency incidence edge_map]           [];
        che_l3                "che-l3"                $crate::CheL3                [topology adjacency incidence edge_map boundaries] [];
        directed_edges_small  "directed-edges-small"  $crate::DirectedEdgesSmall   [topology adjacency incidence]                    [non_manifold_edge same_direction several_fans];
        directed_edges_medium "directed-edges-medium" $crate::DirectedEdgesMedium  [topology adjacency incidence]                    [non_manifold_edge same_direction several_fans];
        directed_edges_full   "directed-edges-full"   $crate::DirectedEdgesFull    [topology adjacency incidence]                    [non_manifold_edge same_direction several_fans];
        mate_face             "mate-face"             $crate::MateFace             [topology adjacency incidence]                    [same_direction several_fans];
        half_edge             "half-edge"             $crate::HalfEdgeMesh         [topology adjacency incidence]                    [];
        winged_edge           "winged-edge"           $crate::WingedEdge           [topology adjacency incidence edge_map]           [];
        vertex_graph          "vertex-graph"          $crate::VertexGraph          [graph]                                           [degenerate non_manifold_edge same_direction several_fans];
        adjacency_graph       "adjacency-graph"       $crate::AdjacencyGraph       [topology adjacency incidence]                    [non_manifold_edge same_direction several_fans];
    } };
}

/// What the registry says of one backend.
#[derive(Clone, Copy, Debug)]
pub struct Entry {
    /// Its name at the shell and as a cargo feature, such as `che-l2` (the vertex graph has no feature).
    pub name: &'static str,
    /// Its traits, from `topology` up; `graph` is the bare [`Neighbours`](crate::neighbours::Neighbours).
    pub traits: &'static [&'static str],
    /// The defects that it holds as they are.
    pub holds: &'static [&'static str],
    /// Its memory formula.
    pub bytes: Bytes,
}

macro_rules! entries {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {
        /// Every backend, in the order of the registry.
        pub const BACKENDS: &[Entry] = &[$(Entry {
            name: $text,
            traits: &[$(stringify!($has)),*],
            holds: &[$(stringify!($holds)),*],
            bytes: <$mesh as Footprint>::BYTES,
        }),+];
    };
}
with_backends!(entries);

/// Structures that renumber vertices and faces, and so are made by a function of their own that gives the maps as
/// well, not by [`FromFaces`](crate::FromFaces) as every one of [`BACKENDS`] is.
pub const RENUMBERING: &[Entry] = &[Entry {
    name: "sot",
    traits: &["topology", "adjacency", "incidence"],
    holds: &[],
    bytes: crate::Sot::BYTES,
}];

/// What the registry says of a structure that renumbers, and whose bytes depend on the order of the vertices as well as
/// on counts.
#[derive(Clone, Copy, Debug)]
pub struct Compressed {
    /// Its name.
    pub name: &'static str,
    /// Its traits, from `topology` up.
    pub traits: &'static [&'static str],
    /// The least and the most bytes of connectivity a triangle, rounded, that were measured on large closed meshes.
    pub bytes: [usize; 2],
    /// What they are made of; exactly, in its documentation.
    pub formula: &'static str,
}

/// Every [`Compressed`] structure.
pub const COMPRESSED: &[Compressed] = &[Compressed {
    name: "compact-stars",
    traits: &["topology", "adjacency", "incidence"],
    bytes: [5, 7],
    formula: "(3 w + 10) T / 8 + V / 2, with w bits a difference",
}];

/// Rows of the memory table that are no backends: name, bytes of connectivity a triangle where there is any, and
/// the formula.
pub const NOT_BACKENDS: [(&str, Option<usize>, &str); 2] =
    [("explicit triangles", None, "36 T, positions and all"), ("edge list", Some(36), "12 T + 16 E")];

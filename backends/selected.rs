//! `Mesh`: what the cargo features select. All `cfg` on features is here.
//!
//! A column is on where a preset or a feature of its own asks for it. The hand-written backends turn on, beside
//! another preset, the columns that have the same traits. What one preset holds, the union holds: one that takes
//! vertices of several fans, or anything, makes a row with outgoing half-edges, or opposites, one that holds. (But
//! for degenerate faces: no row with opposites holds those.)
use crate::{column, layout, link, storage::Owned};

macro_rules! columns {
    ($($column:ident: $on_if:meta => $module:ident::$on:ident, else $off:ident;)+) => {
        /// The row of `Mesh`: the union of the columns that the crates of a build asked for.
        #[derive(Clone, Copy, Debug)]
        pub enum Selected {}

        impl layout::Layout for Selected {
            const NAME: &'static str = "Mesh";
            #[cfg(feature = "edge-table")]
            type Edges = layout::Indexed;
            #[cfg(all(any(feature = "edge-map", feature = "winged-edge"), not(feature = "edge-table")))]
            type Edges = layout::Sorted;
            #[cfg(not(any(feature = "edge-map", feature = "winged-edge")))]
            type Edges = column::Absent;
            $(
                #[cfg($on_if)]
                type $column = $module::$on;
                #[cfg(not($on_if))]
                type $column = $module::$off;
            )+
        }
    };
}

/// Hands the conditions that several columns share to `columns!`.
macro_rules! selected {
    (with_opposite $opposite:tt, with_outgoing $outgoing:tt, takes_anything $anything:tt, holds $holds:tt) => {
        selected! { @ any $opposite, any $outgoing, any(
            any $holds,
            all(any $anything, any $opposite),
            all(feature = "che-l1", any $outgoing),
        ) }
    };
    (@ any $opposite:tt, any $outgoing:tt, any $holds:tt) => {
        columns! {
            Origin:   any(feature = "store-origin", not(feature = "store-target")) => column::Stored, else Computed;
            Target:   feature = "store-target" => column::Stored, else Computed;
            Next:     feature = "store-next" => column::Stored, else Computed;
            Prev:     feature = "store-prev" => column::Stored, else Computed;
            Opposite: any $opposite => column::Stored, else Absent;
            Outgoing: any $outgoing => column::Stored, else Absent;
            Curves:   feature = "boundary-curves" => column::Stored, else Absent;
            Links:    any(feature = "boundary-curves", any $holds) => link::Coded, else Plain;
            Defects:  any $holds => layout::Holds, else Refuses;
        }
    };
}

selected! {
    with_opposite (
        feature = "adjacency", feature = "mate-face", feature = "half-edge", feature = "winged-edge",
        feature = "adjacency-graph",
    ),
    with_outgoing (
        feature = "incidence", feature = "mate-face", feature = "half-edge", feature = "winged-edge",
        feature = "adjacency-graph",
    ),
    takes_anything (feature = "shared-vertex", feature = "che-l0"),
    holds (feature = "hold-defects", feature = "mate-face", feature = "adjacency-graph")
}

macro_rules! mesh {
    ($($feature:literal $mesh:ident, beside $($other:literal)+;)+) => {
        $(
            /// The mesh that the cargo features select: here the one backend that was asked for. For binaries; a
            /// library takes `impl Topology`.
            #[cfg(all(feature = $feature, not(any(feature = "_row", $(feature = $other),+))))]
            pub type Mesh<S = Owned> = crate::$mesh<S>;
        )+
        /// The mesh that the cargo features select: the row with the union of the columns that the crates of a build
        /// asked for. For binaries; a library takes `impl Topology`.
        #[cfg(not(any($(all(feature = $feature, not(any(feature = "_row", $(feature = $other),+)))),+)))]
        pub type Mesh<S = Owned> = crate::Table<Selected, S>;
    };
}

// A backend that is no row is `Mesh` where it is the only preset on. `_row` is on with every column.
mesh! {
    "mate-face"       MateFace,       beside "half-edge" "winged-edge" "adjacency-graph";
    "half-edge"       HalfEdgeMesh,   beside "mate-face" "winged-edge" "adjacency-graph";
    "winged-edge"     WingedEdge,     beside "mate-face" "half-edge" "adjacency-graph";
    "adjacency-graph" AdjacencyGraph, beside "mate-face" "half-edge" "winged-edge";
}

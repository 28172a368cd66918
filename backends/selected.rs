//! `Mesh`: what the cargo features select. All `cfg` on features is here.
use crate::{column, layout, link};

macro_rules! columns {
    ($($column:ident: $($feature:literal)+ => $module:ident::$on:ident, else $off:ident;)+) => {
        /// The row of `Mesh`: the union of the columns that the crates of a build asked for.
        #[derive(Clone, Copy, Debug)]
        pub enum Selected {}

        impl layout::Layout for Selected {
            const NAME: &'static str = "Mesh";
            #[cfg(any(feature = "store-origin", not(feature = "store-target")))]
            type Origin = column::Stored;
            #[cfg(not(any(feature = "store-origin", not(feature = "store-target"))))]
            type Origin = column::Computed;
            #[cfg(feature = "edge-table")]
            type Edges = layout::Indexed;
            #[cfg(all(feature = "edge-map", not(feature = "edge-table")))]
            type Edges = layout::Sorted;
            #[cfg(all(feature = "winged-edge", not(feature = "edge-map")))]
            type Edges = layout::Sorted;
            #[cfg(not(any(feature = "edge-map", feature = "winged-edge")))]
            type Edges = column::Absent;
            $(
                #[cfg(any($(feature = $feature),+))]
                type $column = $module::$on;
                #[cfg(not(any($(feature = $feature),+)))]
                type $column = $module::$off;
            )+
        }
    };
}

// The hand-written backends turn on, beside another preset, the columns that have the same traits.
columns! {
    Target:   "store-target" => column::Stored, else Computed;
    Next:     "store-next" => column::Stored, else Computed;
    Prev:     "store-prev" => column::Stored, else Computed;
    Opposite: "adjacency" "mate-face" "half-edge" "winged-edge" "adjacency-graph" => column::Stored, else Absent;
    Outgoing: "incidence" "mate-face" "half-edge" "winged-edge" "adjacency-graph" => column::Stored, else Absent;
    Curves:   "boundary-curves" => column::Stored, else Absent;
    Links:    "boundary-curves" "hold-defects" "mate-face" "adjacency-graph" => link::Coded, else Plain;
    Defects:  "hold-defects" "mate-face" "adjacency-graph" => layout::Holds, else Refuses;
}

macro_rules! mesh {
    ($($feature:literal $mesh:ident, beside $($other:literal)+;)+) => {
        $(
            /// The mesh that the cargo features select: here the one backend that was asked for. For binaries; a
            /// library takes `impl Topology`.
            #[cfg(all(feature = $feature, not(any(feature = "_row", $(feature = $other),+))))]
            pub type Mesh = crate::$mesh;
        )+
        /// The mesh that the cargo features select: the row with the union of the columns that the crates of a build
        /// asked for. For binaries; a library takes `impl Topology`.
        #[cfg(not(any($(all(feature = $feature, not(any(feature = "_row", $(feature = $other),+)))),+)))]
        pub type Mesh = crate::Table<Selected>;
    };
}

// A backend that is no row is `Mesh` where it is the only preset on. `_row` is on with every column.
mesh! {
    "mate-face"       MateFace,       beside "half-edge" "winged-edge" "adjacency-graph";
    "half-edge"       HalfEdgeMesh,   beside "mate-face" "winged-edge" "adjacency-graph";
    "winged-edge"     WingedEdge,     beside "mate-face" "half-edge" "adjacency-graph";
    "adjacency-graph" AdjacencyGraph, beside "mate-face" "half-edge" "winged-edge";
}

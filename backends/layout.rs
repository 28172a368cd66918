//! The one table that every tabular backend is made from.
//!
//! To add a row, add a line to [`with_layouts!`](crate::with_layouts) and one to the registry.
use crate::column::{Absent, Answered, Computed, Policy, Stored};
use crate::link::{Coded, Coding, Plain};

/// One row of the table: what a layout keeps and what it works out.
///
/// A user can write a row of his own. `Origin` or `Target` has to be [`Stored`], and a row that [`Holds`]
/// needs [`Coded`] links; both are checked when `Table` is compiled for it.
pub trait Layout: Copy + Send + Sync + 'static {
    /// Name of the row.
    const NAME: &'static str;
    /// Half-edge -> vertex it starts at.
    type Origin: Answered;
    /// Half-edge -> vertex it ends at.
    type Target: Answered;
    /// Half-edge -> next in face.
    type Next: Answered;
    /// Half-edge -> previous in face.
    type Prev: Answered;
    /// Half-edge -> half-edge across the edge.
    type Opposite: Policy;
    /// Vertex -> one half-edge out of it.
    type Outgoing: Policy;
    /// Edge -> one half-edge, and half-edge -> edge.
    type Edges: Edges;
    /// Boundary curve -> one half-edge along it.
    type Curves: Policy;
    /// How links are written.
    type Links: Coding;
    /// What is done with non-manifold edges and vertices.
    type Defects: Defects;
}

/// How a layout names edges: not at all ([`Absent`]), by a [`Sorted`] list, or with an [`Indexed`] one.
pub trait Edges: 'static {
    /// Edge -> its least half-edge, ascending.
    type List: Policy;
    /// Half-edge -> edge: where it is [`Computed`], by binary search in the list.
    type Index: Policy;
}

/// Edges are a sorted list of half-edges; the edge of a half-edge is found by binary search.
#[derive(Debug)]
pub enum Sorted {}

/// Edges are a sorted list of half-edges, with a table from half-edge to edge beside it.
#[derive(Debug)]
pub enum Indexed {}

impl Edges for Absent {
    type List = Absent;
    type Index = Absent;
}

impl Edges for Sorted {
    type List = Stored;
    type Index = Computed;
}

impl Edges for Indexed {
    type List = Stored;
    type Index = Stored;
}

/// What a layout does with edges of three or more faces, edges that both faces run along in the same direction,
/// and vertices of several fans.
pub trait Defects: 'static {
    /// The records of such elements.
    type Records: Policy;
}

/// Such a mesh is a `BuildError` (a vertex of several fans only where the layout has `outgoing`).
#[derive(Debug)]
pub enum Refuses {}

/// Such elements are kept in records (Campagna et al. 1998; Emme 2012, 4.3).
#[derive(Debug)]
pub enum Holds {}

impl Defects for Refuses {
    type Records = Absent;
}

impl Defects for Holds {
    type Records = Stored;
}

/// Calls `$then!` with the whole table. All other lists of layouts are made from this one.
#[macro_export]
macro_rules! with_layouts {
    ($then:path) => { $then! {
        //                    origin   target   next     prev     | opposite outgoing edges   curves | links defects
        SharedVertex         [Stored   Computed Computed Computed | Absent   Absent   Absent  Absent | Plain Refuses]
            "Shared vertex: three vertices a face, and nothing else.";
        CheL0                [Stored   Computed Computed Computed | Absent   Absent   Absent  Absent | Plain Refuses]
            "Compact half-edge, level 0 (Lage et al. 2005): triangle soup with shared vertices.";
        CheL1                [Stored   Computed Computed Computed | Stored   Absent   Absent  Absent | Plain Refuses]
            "Compact half-edge, level 1: adds what lies across each edge. The same arrays as a corner table.";
        CheL2                [Stored   Computed Computed Computed | Stored   Stored   Sorted  Absent | Plain Refuses]
            "Compact half-edge, level 2: adds a start for each vertex and the edge map, as a sorted list.";
        CheL2EdgeTable       [Stored   Computed Computed Computed | Stored   Stored   Indexed Absent | Plain Refuses]
            "Compact half-edge, level 2, with a table from half-edge to edge: `edge` without a search.";
        CheL3                [Stored   Computed Computed Computed | Stored   Stored   Sorted  Stored | Coded Refuses]
            "Compact half-edge, level 3: adds boundary curves, which boundary links name.";
        DirectedEdgesSmall   [Computed Stored   Computed Computed | Stored   Stored   Absent  Absent | Coded Holds]
            "Directed edges, small (Campagna et al. 1998): target and neighbour; the rest is worked out.";
        DirectedEdgesMedium  [Computed Stored   Computed Stored   | Stored   Stored   Absent  Absent | Coded Holds]
            "Directed edges, medium: adds the previous edge; next is the previous of the previous.";
        DirectedEdgesFull    [Stored   Stored   Stored   Stored   | Stored   Stored   Absent  Absent | Coded Holds]
            "Directed edges, full: everything is stored.";
    } };
}

macro_rules! define {
    ($($name:ident [$origin:ident $target:ident $next:ident $prev:ident
        | $opposite:ident $outgoing:ident $edges:ident $curves:ident | $links:ident $defects:ident] $doc:literal;)+) => {
        /// The rows of the table, as type-level names. `onering::CheL2` is `Table<rows::CheL2>`.
        pub mod rows {
            use super::*;
            $(
                #[doc = $doc]
                #[derive(Clone, Copy, Debug)]
                pub enum $name {}

                impl Layout for $name {
                    const NAME: &'static str = stringify!($name);
                    type Origin = $origin;
                    type Target = $target;
                    type Next = $next;
                    type Prev = $prev;
                    type Opposite = $opposite;
                    type Outgoing = $outgoing;
                    type Edges = $edges;
                    type Curves = $curves;
                    type Links = $links;
                    type Defects = $defects;
                }
            )+
        }
        /// The structures of the rows: `CheL2` is `Table<rows::CheL2>`. They are at the root of the crate as well.
        pub mod aliases {
            $(
                #[doc = $doc]
                pub type $name<S = crate::storage::Owned> = crate::Table<super::rows::$name, S>;
            )+
        }
    };
}
with_layouts!(define);

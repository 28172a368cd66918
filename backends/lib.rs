//! One `Topology` trait, every triangle-mesh data structure.
#![no_std]
extern crate alloc;

pub use onering_core::*;

mod adjacency_graph;
mod build;
pub mod column;
mod half_edge;
pub mod layout;
pub mod link;
mod mate_face;
#[macro_use]
pub mod registry;
mod table;
mod vertex_graph;
mod winged_edge;

pub use adjacency_graph::AdjacencyGraph;
pub use half_edge::HalfEdgeMesh;
pub use layout::*;
pub use mate_face::MateFace;
pub use table::Table;
pub use vertex_graph::VertexGraph;
pub use winged_edge::WingedEdge;

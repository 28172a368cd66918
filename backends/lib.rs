#![doc = include_str!("../README.md")]
//!
//! ## On these pages
//!
//! Traits and algorithms are those of `onering-core`; every structure is a type at the root, and [`Mesh`] is the one
//! that the cargo features select. [`registry`] lists them all, [`layout`] is the table that variants come from.
//! Feature `io` adds `onering::io`, which reads files: `onering::io::load("bunny.obj")`.
#![no_std]
extern crate alloc;
#[cfg(feature = "ring")]
extern crate std;

pub use onering_core::*;
#[cfg(feature = "io")]
pub use onering_io as io;

mod adjacency_graph;
mod build;
mod check;
pub mod column;
pub mod columns;
mod compact_stars;
mod half_edge;
pub mod layout;
pub mod link;
mod mate_face;
#[macro_use]
pub mod registry;
mod renumbering;
#[cfg(feature = "ring")]
pub mod ring;
mod selected;
mod sot;
pub mod storage;
mod table;
mod vertex_graph;
mod winged_edge;

pub use adjacency_graph::AdjacencyGraph;
pub use compact_stars::CompactStars;
pub use half_edge::HalfEdgeMesh;
pub use layout::aliases::*;
pub use mate_face::MateFace;
pub use renumbering::Renumbering;
pub use selected::{Mesh, Selected};
pub use sot::Sot;
pub use table::Table;
pub use vertex_graph::VertexGraph;
pub use winged_edge::WingedEdge;

//! One `Topology` trait, every triangle-mesh data structure.
//!
//! Write an algorithm once, over the weakest trait that serves; choose the structure by type, or by cargo feature
//! as [`Mesh`].
//!
//! ```
//! use onering::{DirectedEdgesSmall, FromFaces, Incidence, Topology};
//!
//! fn mean_degree(mesh: &impl Incidence) -> f64 {
//!     let degrees: usize = mesh.vertices().map(|v| mesh.one_ring(v).count()).sum();
//!     degrees as f64 / mesh.vertex_count() as f64
//! }
//!
//! let tetrahedron = [[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]];
//! let mesh = DirectedEdgesSmall::from_faces(4, &tetrahedron)?;
//! assert_eq!(mean_degree(&mesh), 3.0);
//! # Ok::<(), onering::BuildError>(())
//! ```
//!
//! The table of all structures, with their bytes and traits, is in the [`registry`]; variants come from the table in
//! [`layout`]. Everything of `onering-core` is here as well. Feature `io` adds `onering::io`, which reads files:
//! `onering::io::load("bunny.obj")`.
#![no_std]
extern crate alloc;

pub use onering_core::*;
#[cfg(feature = "io")]
pub use onering_io as io;

mod adjacency_graph;
mod build;
pub mod column;
mod half_edge;
pub mod layout;
pub mod link;
mod mate_face;
#[macro_use]
pub mod registry;
mod selected;
mod table;
mod vertex_graph;
mod winged_edge;

pub use adjacency_graph::AdjacencyGraph;
pub use half_edge::HalfEdgeMesh;
pub use layout::*;
pub use mate_face::MateFace;
pub use selected::{Mesh, Selected};
pub use table::Table;
pub use vertex_graph::VertexGraph;
pub use winged_edge::WingedEdge;

/// Runs the README's program.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

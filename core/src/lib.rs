//! Traits, handles and algorithms for triangle-mesh topology, with no storage of their own.
//!
//! ```text
//! Topology <- Adjacency <- Incidence          FromFaces (construction), Footprint (memory)
//!                 ^ EdgeMap   |
//!                 ^ Boundaries `-> neighbours::Neighbours (graphs as well)
//! ```
#![no_std]
extern crate alloc;

pub mod boundary;
pub mod components;
pub mod corner;
pub mod degrees;
pub mod edges;
pub mod euler;
pub mod fans;
pub mod footprint;
pub mod k_ring;
pub mod memory;
pub mod neighbours;
pub mod orientation;
pub mod pairing;
pub mod ring;
pub mod star;
pub mod umbrella;

mod adjacency;
mod boundaries;
mod disjoint_sets;
mod edge_map;
mod error;
mod from_faces;
mod handle;
mod incidence;
mod map;
mod reference;
mod slot;
mod topology;

pub use adjacency::Adjacency;
pub use boundaries::Boundaries;
pub use edge_map::EdgeMap;
pub use error::BuildError;
pub use footprint::Footprint;
pub use from_faces::FromFaces;
pub use handle::{CurveId, EdgeId, FaceId, HalfEdgeId, Handle, VertexId};
pub use incidence::Incidence;
pub use map::Map;
pub use pairing::Pairing;
pub use slot::Slot;
pub use topology::Topology;

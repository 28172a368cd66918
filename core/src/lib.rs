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
#[cfg(feature = "conformance")]
pub mod conformance;
pub mod corner;
pub mod defects;
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
pub mod repair;
pub mod ring;
pub mod star;
pub mod umbrella;

mod adjacency;
mod boundaries;
mod disjoint_sets;
mod edge_map;
mod error;
#[macro_use]
mod forward;
mod from_faces;
mod handle;
mod incidence;
mod map;
mod reference;
mod searched;
mod slot;
mod topology;
mod with_opposites;
mod with_outgoing;

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
pub use searched::Searched;
pub use slot::Slot;
pub use topology::Topology;
pub use with_opposites::WithOpposites;
pub use with_outgoing::WithOutgoing;

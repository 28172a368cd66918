//! Traits, handles and algorithms for triangle-mesh topology, with no storage of their own.
//!
//! ```text
//! Topology <- Adjacency <- Incidence          FromFaces (construction), Footprint (memory)
//!                 ^ EdgeMap   |
//!                 ^ Boundaries `-> neighbours::Neighbours (graphs as well)
//! ```
//!
//! | trait | required | first of the structures that has it |
//! |---|---|---|
//! | [`Topology`] | vertex_count, face_count, origin | any list of triangles over shared vertices |
//! | [`Adjacency`] | opposite | with what lies across each edge |
//! | [`Incidence`] | outgoing | with a start for each vertex |
//! | [`EdgeMap`] | edge_count, edge, half_edge | with names for edges |
//! | [`Boundaries`] | curve_count, curve_start, curve_of | with names for boundary curves |
//!
//! The structures themselves, and the table of what each takes and has, are in the crate `onering`. What a mesh lacks,
//! [`WithOpposites`], [`WithOutgoing`] and [`Searched`] add.
//!
//! - Input: [`Defects`] names what is wrong with a list of triangles, [`repair()`] mends it; [`Builder`] builds mesh after
//!   mesh in the same memory.
//! - Algorithms on connectivity: [`relations`], [`k_ring`], [`star`], [`boundary`], [`edges`], [`components`],
//!   [`umbrella`], [`orientation`], [`euler`], [`degrees`], [`dual`], [`submesh`].
//! - Algorithms that take positions: [`normals`], [`measure`], [`curvature`], [`smoothing`], [`distance`], [`nearest`],
//!   [`spring`], [`subdivision`], [`holes`], [`reorder`], [`region`]; for a user's own, [`vector`] and [`triangle`].
//! - Algorithms that take a scalar field: [`critical`], [`contours`].
//! - For the author of a structure: [`pairing`], [`fans`], [`ring`], [`corner`], [`memory`], and the laws in
//!   `conformance` (a feature).
#![no_std]
extern crate alloc;

pub mod boundary;
pub mod components;
#[cfg(feature = "conformance")]
pub mod conformance;
pub mod contours;
pub mod corner;
pub mod critical;
pub mod curvature;
pub mod defects;
pub mod degrees;
pub mod distance;
pub mod dual;
pub mod edges;
pub mod euler;
pub mod fans;
pub mod footprint;
pub mod holes;
pub mod k_ring;
pub mod measure;
pub mod memory;
pub mod nearest;
pub mod neighbours;
pub mod normals;
pub mod orientation;
pub mod pairing;
pub mod prelude;
pub mod region;
pub mod relations;
pub mod reorder;
pub mod repair;
pub mod ring;
pub mod smoothing;
pub mod spring;
pub mod star;
pub mod subdivision;
pub mod submesh;
pub mod triangle;
pub mod umbrella;
pub mod vector;

mod adjacency;
mod boundaries;
mod builder;
mod disjoint_sets;
mod edge_map;
mod error;
#[macro_use]
mod forward;
mod from_faces;
pub mod handle;
mod incidence;
mod map;
mod not_finite;
mod reference;
mod searched;
mod slot;
mod topology;
mod with_opposites;
mod with_outgoing;
mod workers;

pub use adjacency::Adjacency;
pub use boundaries::Boundaries;
pub use builder::{Builder, Recycle};
pub use defects::Defects;
pub use edge_map::EdgeMap;
pub use error::BuildError;
pub use footprint::Footprint;
pub use from_faces::FromFaces;
pub use handle::{CurveId, EdgeId, FaceId, HalfEdgeId, Handle, VertexId};
pub use incidence::Incidence;
pub use map::Map;
pub use not_finite::NotFinite;
pub use pairing::Pairing;
pub use repair::{RepairOptions, Repaired, repair};
pub use searched::Searched;
pub use slot::Slot;
pub use topology::Topology;
pub use with_opposites::WithOpposites;
pub use with_outgoing::WithOutgoing;

//! The laws, one file for each trait.
mod adjacency;
mod boundaries;
mod edge_map;
mod footprint;
mod from_faces;
mod graph;
mod incidence;
mod iteration;
mod topology;

pub use adjacency::adjacency;
pub use boundaries::boundaries;
pub use edge_map::edge_map;
pub use footprint::footprint;
pub use from_faces::from_faces;
pub use graph::graph;
pub use incidence::incidence;
pub use topology::topology;

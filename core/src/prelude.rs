//! What almost every program names: `use onering::prelude::*`.
pub use crate::{
    Adjacency, Boundaries, BuildError, EdgeMap, Footprint, FromFaces, Handle, Incidence, Map, Topology,
};

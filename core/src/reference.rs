//! A shared reference is as good as the mesh: it forwards every method, so that no override is lost.
use crate::{
    Adjacency, Boundaries, EdgeMap, Footprint, Incidence, Topology, footprint::Bytes, handle::Handles,
};
use alloc::vec::Vec;

impl<T: Topology> Topology for &T {
    topology_of!(T, self => *self);
}

impl<T: Adjacency> Adjacency for &T {
    adjacency_of!(T, self => *self);
}

impl<T: Incidence> Incidence for &T {
    incidence_of!(T, self => *self);
}

impl<T: EdgeMap> EdgeMap for &T {
    edge_map_of!(T, self => *self);
}

impl<T: Boundaries> Boundaries for &T {
    boundaries_of!(T, self => *self);
}

impl<T: Footprint> Footprint for &T {
    const BYTES: Bytes = T::BYTES;

    fn heap_bytes(&self) -> usize {
        T::heap_bytes(*self)
    }
}

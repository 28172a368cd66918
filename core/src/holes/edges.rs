//! The edges that no new face may lie along.
use crate::{Adjacency, Handle, Map, edges};
use alloc::collections::BTreeSet;

/// The edges that have their faces, as far as both ends are on the boundary: the others are out of reach.
pub(super) struct Edges(BTreeSet<[u32; 2]>);

impl Edges {
    /// Those of the mesh. O(half-edges), and O(n log n) in those that are kept.
    pub(super) fn of_boundary<M: Adjacency + ?Sized>(mesh: &M) -> Self {
        let mut on_boundary: Map<M::Vertex, bool> = Map::filled(mesh.vertex_count(), false);
        for h in mesh.half_edges().filter(|&h| mesh.is_boundary(h)) {
            on_boundary[mesh.origin(h)] = true;
            on_boundary[mesh.target(h)] = true;
        }
        let ends = edges::each(mesh).map(|h| [mesh.origin(h), mesh.target(h)]);
        let within = ends.filter(|ends| ends.iter().all(|&v| on_boundary[v]));
        Self(within.map(|ends| sorted(ends.map(|v| v.index() as u32))).collect())
    }

    pub(super) fn has(&self, ends: [u32; 2]) -> bool {
        self.0.contains(&sorted(ends))
    }

    /// Whether it is new.
    pub(super) fn insert(&mut self, ends: [u32; 2]) -> bool {
        self.0.insert(sorted(ends))
    }

    pub(super) fn remove(&mut self, ends: [u32; 2]) {
        self.0.remove(&sorted(ends));
    }
}

fn sorted([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

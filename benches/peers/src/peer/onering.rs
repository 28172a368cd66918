//! onering, all backends of its registry, with the pairing that is the default.

use super::{Peer, Run, Structure, run};
use crate::mesh::{Mesh, ring_sum};
use onering::{FromFaces, Handle, Incidence, VertexGraph, neighbours::Neighbours};

/// A backend that has no rings to walk.
struct NoRings<M>(#[allow(dead_code, reason = "held, so that its bytes are counted")] M);
/// A backend whose rings are walked in order.
struct Rings<M>(M);
/// The graph, whose neighbours are a slice.
struct Graph(VertexGraph);

fn build<M: FromFaces>(mesh: &Mesh) -> Result<M, String> {
    M::from_faces(mesh.positions.len(), &mesh.faces).map_err(|error| error.to_string())
}

impl<M: FromFaces> Structure for NoRings<M> {
    type Input<'a> = &'a Mesh;

    fn build(mesh: &Mesh) -> Result<Self, String> {
        build(mesh).map(Self)
    }

    fn sweep(&self) -> Option<u64> {
        None
    }
}

impl<M: FromFaces + Incidence> Structure for Rings<M> {
    type Input<'a> = &'a Mesh;

    fn build(mesh: &Mesh) -> Result<Self, String> {
        build(mesh).map(Self)
    }

    fn sweep(&self) -> Option<u64> {
        let ring = |v| ring_sum(u32_of(v), self.0.one_ring(v).map(u32_of));
        Some(self.0.vertices().map(ring).fold(0, u64::wrapping_add))
    }
}

impl Structure for Graph {
    type Input<'a> = &'a Mesh;

    fn build(mesh: &Mesh) -> Result<Self, String> {
        build(mesh).map(Self)
    }

    fn sweep(&self) -> Option<u64> {
        let ring = |v| ring_sum(u32_of(v), Neighbours::neighbours(&self.0, v).map(u32_of));
        Some((0..self.0.vertex_count()).map(Handle::new).map(ring).fold(0, u64::wrapping_add))
    }
}

#[inline(always)]
fn u32_of(v: impl Handle) -> u32 {
    v.index() as u32
}

/// One line of the registry: how far its traits go says whether it has rings.
macro_rules! wrapped {
    ([graph] $mesh:ty) => {
        run::<Graph>
    };
    ([topology] $mesh:ty) => {
        run::<NoRings<$mesh>>
    };
    ([topology adjacency] $mesh:ty) => {
        run::<NoRings<$mesh>>
    };
    ([topology adjacency incidence $($more:ident)*] $mesh:ty) => {
        run::<Rings<$mesh>>
    };
}

macro_rules! list {
    ($($module:ident $name:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {
        pub(super) const BACKENDS: &[Peer] = &[$(Peer {
            name: concat!("onering ", $name),
            run: wrapped!([$($has)*] $mesh) as fn(&Mesh) -> Result<Run, String>,
        }),+];
    };
}
onering::with_backends!(list);

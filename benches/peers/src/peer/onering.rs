//! onering, all backends of its registry, with the pairing that is the default.

use super::walk::{LEVELS, Walk};
use super::{Peer, Structure, run, run_and_walk};
use crate::mesh::{Mesh, mixed};
use crate::record::Run;
use onering::k_ring::KRing;
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

fn index(v: impl Handle) -> u32 {
    v.index() as u32
}

fn four_rings<G: Neighbours>(graph: &G, queries: &[u32]) -> u64 {
    let mut ring = KRing::new();
    let mut sum = 0_u64;
    for &query in queries {
        for &u in ring.search(graph, Handle::new(query as usize), LEVELS).within(LEVELS) {
            sum = sum.wrapping_add(mixed(query, index(u)));
        }
    }
    sum
}

impl<M: FromFaces> Structure for NoRings<M> {
    type Input<'a> = &'a Mesh;

    fn build(mesh: &Mesh) -> Result<Self, String> {
        build(mesh).map(Self)
    }
}

impl<M: FromFaces> Structure for Rings<M> {
    type Input<'a> = &'a Mesh;

    fn build(mesh: &Mesh) -> Result<Self, String> {
        build(mesh).map(Self)
    }
}

impl<M: FromFaces + Incidence> Walk for Rings<M> {
    type Vertex = M::Vertex;

    fn vertices(&self) -> impl Iterator<Item = M::Vertex> {
        self.0.vertices()
    }

    #[inline(always)]
    fn index(v: M::Vertex) -> u32 {
        index(v)
    }

    #[inline(always)]
    fn ring(&self, v: M::Vertex, visit: impl FnMut(M::Vertex)) {
        self.0.one_ring(v).for_each(visit);
    }

    fn four_rings(&self, _: &[Option<M::Vertex>], queries: &[u32]) -> u64 {
        four_rings(&self.0, queries)
    }
}

impl Structure for Graph {
    type Input<'a> = &'a Mesh;

    fn build(mesh: &Mesh) -> Result<Self, String> {
        build(mesh).map(Self)
    }
}

impl Walk for Graph {
    type Vertex = <VertexGraph as Neighbours>::Node;

    fn vertices(&self) -> impl Iterator<Item = Self::Vertex> {
        (0..self.0.vertex_count()).map(Handle::new)
    }

    #[inline(always)]
    fn index(v: Self::Vertex) -> u32 {
        index(v)
    }

    #[inline(always)]
    fn ring(&self, v: Self::Vertex, visit: impl FnMut(Self::Vertex)) {
        Neighbours::neighbours(&self.0, v).for_each(visit);
    }

    fn four_rings(&self, _: &[Option<Self::Vertex>], queries: &[u32]) -> u64 {
        four_rings(&self.0, queries)
    }
}

/// One line of the registry: how far its traits go says whether it has rings.
macro_rules! wrapped {
    ([graph] $mesh:ty) => {
        run_and_walk::<Graph>
    };
    ([topology] $mesh:ty) => {
        run::<NoRings<$mesh>>
    };
    ([topology adjacency] $mesh:ty) => {
        run::<NoRings<$mesh>>
    };
    ([topology adjacency incidence $($more:ident)*] $mesh:ty) => {
        run_and_walk::<Rings<$mesh>>
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

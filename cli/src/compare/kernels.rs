//! What is asked of a backend: the questions whose time is taken, and those whose answers are compared.
//!
//! A backend gets those that its traits can answer: the list of traits in the registry becomes a chain of calls,
//! `Kernels::new().topology().adjacency()`, each of which compiles only if the trait is there.

use super::rings::Rings;
use super::sample::scramble;
use crate::timing::Clock;
use onering::neighbours::Neighbours;
use onering::{Adjacency, Boundaries, EdgeMap, Handle, Incidence, Topology};

/// A question by name.
type Check<M> = (&'static str, fn(&M) -> u64);
type TimedRings<M> = fn(&M, &[u32], &Clock) -> Rings;

/// The questions that one backend can answer. All answers are sums, which no order of walking changes.
pub(crate) struct Kernels<M> {
    /// Compared, not timed.
    pub(crate) checks: Vec<Check<M>>,
    /// Words in records of vertices of several fans. Counted here, for structures differ in where a fan ends: some
    /// go on across two faces that run along an edge in the same direction.
    pub(crate) vertex_record_words: Option<fn(&M) -> usize>,
    /// Timed in itself, for the scratch that it keeps.
    pub(crate) rings: Option<TimedRings<M>>,
    /// The sum of all neighbours of all vertices.
    pub(crate) sweep: Option<fn(&M) -> u64>,
    /// The sum of all neighbours of these vertices.
    pub(crate) vertex_queries: Option<fn(&M, &[u32]) -> u64>,
    /// The sum of the faces across the edges of these faces.
    pub(crate) face_queries: Option<fn(&M, &[u32]) -> u64>,
}

impl<M> Kernels<M> {
    pub(crate) fn new() -> Self {
        Self {
            checks: Vec::new(),
            vertex_record_words: None,
            rings: None,
            sweep: None,
            vertex_queries: None,
            face_queries: None,
        }
    }

    /// Whether building pairs half-edges, so that there is a choice of strategy.
    pub(crate) fn pairs(&self) -> bool {
        self.face_queries.is_some()
    }
}

impl<M: Topology> Kernels<M> {
    pub(crate) fn topology(mut self) -> Self {
        self.checks.push(("faces", faces));
        self
    }
}

impl<M: Adjacency> Kernels<M> {
    pub(crate) fn adjacency(mut self) -> Self {
        self.checks.push(("edge_fan", edge_fans));
        self.checks.push(("opposite", opposites));
        self.checks.push(("boundary", boundary));
        self.face_queries = Some(across);
        self
    }
}

impl<M: Incidence> Kernels<M> {
    pub(crate) fn incidence(mut self) -> Self {
        self.checks.push(("star", stars));
        self.checks.push(("neighbours", neighbours));
        self.vertex_record_words = Some(vertex_record_words);
        self.rings = Some(Rings::of);
        self.sweep = Some(|mesh| sum(mesh.vertices(), |v| ring_sum(mesh, v)));
        self.vertex_queries =
            Some(|mesh, vertices| sum(vertices.iter(), |&v| ring_sum(mesh, M::Vertex::new(v as usize))));
        self
    }
}

impl<M: EdgeMap> Kernels<M> {
    pub(crate) fn edge_map(mut self) -> Self {
        self.checks.push(("edges", edges));
        self
    }
}

impl<M: Boundaries> Kernels<M> {
    pub(crate) fn boundaries(mut self) -> Self {
        // Every boundary half-edge lies along one curve.
        self.checks
            .push(("boundary", |mesh| sum(mesh.curves().flat_map(|c| mesh.curve(c)), |h| side(mesh, h))));
        self
    }
}

fn sum<T>(items: impl Iterator<Item = T>, f: impl FnMut(T) -> u64) -> u64 {
    items.map(f).fold(0, u64::wrapping_add)
}

/// One number of two.
pub(crate) fn mix(a: usize, b: usize) -> u64 {
    scramble(scramble(a as u64).wrapping_add(b as u64))
}

/// One number of a face and its vertices, whichever comes first.
pub(crate) fn mix_face(face: usize, [a, b, c]: [usize; 3]) -> u64 {
    let [a, b, c] = [a, b, c].min([b, c, a]).min([c, a, b]);
    mix(face, mix(a, mix(b, c) as usize) as usize)
}

/// One number of the faces along an edge, in any order.
pub(crate) fn mix_fan(faces: impl Iterator<Item = usize>) -> u64 {
    let (count, total) =
        faces.fold((0, 0_u64), |(count, total), face| (count + 1, total.wrapping_add(scramble(face as u64))));
    scramble(total.wrapping_add(count))
}

fn faces<M: Topology>(mesh: &M) -> u64 {
    sum(mesh.faces(), |f| mix_face(f.index(), mesh.face_vertices(f).map(Handle::index)))
}

fn side<M: Topology>(mesh: &M, h: M::HalfEdge) -> u64 {
    mix(mesh.origin(h).index(), mesh.target(h).index())
}

/// Linear also where all faces lie along one edge: its fan is walked from the least half-edge alone. The others come
/// ascending, so each of them meets the least one first.
fn edge_fans<M: Adjacency>(mesh: &M) -> u64 {
    let face = |h| mesh.face(h).index();
    sum(mesh.half_edges(), |h| match mesh.edge_fan(h).nth(1) {
        Some(least) if least.index() < h.index() => mix_fan([h, least].into_iter().map(face)),
        _ => mix_fan(mesh.edge_fan(h).map(face)),
    })
}

fn opposites<M: Adjacency>(mesh: &M) -> u64 {
    let across = |h| mesh.opposite(h).map_or(0, |o| mix(mesh.face(h).index(), mesh.face(o).index()));
    sum(mesh.half_edges(), across)
}

fn boundary<M: Adjacency>(mesh: &M) -> u64 {
    sum(mesh.half_edges().filter(|&h| mesh.is_boundary(h)), |h| side(mesh, h))
}

fn across<M: Adjacency>(mesh: &M, faces: &[u32]) -> u64 {
    let across = |h| mesh.opposite(h).map_or(0, |o| mesh.face(o).index() as u64);
    sum(faces.iter(), |&f| sum(mesh.face_half_edges(M::Face::new(f as usize)).into_iter(), across))
}

fn stars<M: Incidence>(mesh: &M) -> u64 {
    sum(mesh.vertices(), |v| sum(mesh.star(v), |h| mix(v.index(), mesh.face(h).index())))
}

fn neighbours<M: Incidence>(mesh: &M) -> u64 {
    sum(mesh.vertices(), |v| sum(mesh.neighbours(v), |n| mix(v.index(), n.index())))
}

fn vertex_record_words<M: Incidence>(mesh: &M) -> usize {
    let fans = mesh.vertices().map(|v| mesh.fans(v).count());
    fans.filter(|&fans| fans > 1).map(|fans| 1 + fans).sum()
}

#[inline]
fn ring_sum<M: Incidence>(mesh: &M, v: M::Vertex) -> u64 {
    sum(mesh.one_ring(v), |n| n.index() as u64)
}

fn edges<M: EdgeMap>(mesh: &M) -> u64 {
    sum(mesh.edges(), |e| {
        let [a, b] = mesh.edge_vertices(e).map(Handle::index);
        mix(a.min(b), a.max(b))
    })
}

/// A bare graph knows neighbours and nothing else.
impl<M: Neighbours> Kernels<M> {
    pub(crate) fn graph(mut self) -> Self {
        self.checks.push(("neighbours", |mesh| {
            let nodes = (0..mesh.node_count()).map(M::Node::new);
            sum(nodes, |v| sum(mesh.neighbours(v), |n| mix(v.index(), n.index())))
        }));
        self.rings = Some(Rings::of);
        self.sweep = Some(|mesh| sum((0..mesh.node_count()).map(M::Node::new), |v| node_sum(mesh, v)));
        self.vertex_queries =
            Some(|mesh, vertices| sum(vertices.iter(), |&v| node_sum(mesh, M::Node::new(v as usize))));
        self
    }
}

#[inline]
fn node_sum<M: Neighbours>(mesh: &M, v: M::Node) -> u64 {
    sum(mesh.neighbours(v), |n| n.index() as u64)
}

//! [`Searched`]: every answer by looking through all faces.
use crate::{Adjacency, Footprint, Incidence, Topology, footprint::Bytes, handle::Handles, ring::Fan};
use alloc::vec::Vec;

/// A mesh that looks through all faces for every answer: gives [`Adjacency`] and [`Incidence`] to any
/// [`Topology`], without a byte of memory. This is the "no data structure" that the papers compare with.
///
/// O(faces) a query across an edge, O(degree x faces) for the neighbours of a vertex, and O(degree^2 x faces) for its
/// fans, which have to be turned through to see where they start. It holds whatever the mesh holds:
/// non-manifold edges and vertices as directed edges do, and degenerate faces. A side that returns to its own
/// vertex has no opposite, and no vertex is a neighbour of itself.
///
/// There are no names for edges or boundary curves here: to count the elements before one takes O(faces^2) without
/// memory, and with memory it is another structure.
#[derive(Clone, Copy, Debug)]
pub struct Searched<T> {
    mesh: T,
}

impl<T: Topology> Searched<T> {
    /// Wraps `mesh`. Nothing is computed.
    pub fn new(mesh: T) -> Self {
        Self { mesh }
    }

    /// The mesh inside.
    pub fn mesh(&self) -> &T {
        &self.mesh
    }

    /// The mesh inside, by value.
    pub fn into_mesh(self) -> T {
        self.mesh
    }

    /// The half-edges along the same edge as `h` but `h` itself.
    fn others(&self, h: T::HalfEdge) -> impl Iterator<Item = T::HalfEdge> {
        let (a, b) = (self.origin(h), self.target(h));
        let is_along = move |&g: &T::HalfEdge| {
            let (c, d) = (self.origin(g), self.target(g));
            g != h && ((c, d) == (a, b) || (c, d) == (b, a))
        };
        self.half_edges().filter(is_along)
    }

    /// The half-edges out of `v`, in the order of the mesh.
    fn out_of(&self, v: T::Vertex) -> impl Iterator<Item = T::HalfEdge> {
        self.half_edges().filter(move |&h| self.origin(h) == v)
    }

    /// Whether a turn from `h` comes round, and meets no lesser half-edge.
    fn is_start_of_closed(&self, h: T::HalfEdge) -> bool {
        let mut last = h;
        let is_least = Fan::new(self, Some(h)).all(|g| {
            last = g;
            g >= h
        });
        is_least && self.rotate_ccw(last).is_some()
    }
}

impl<T: Topology> Topology for Searched<T> {
    topology_of!(T, self => &self.mesh);
}

impl<T: Topology> Adjacency for Searched<T> {
    fn opposite(&self, h: T::HalfEdge) -> Option<T::HalfEdge> {
        let mut others = self.others(h);
        let runs_back = |&g: &T::HalfEdge| self.origin(g) != self.origin(h);
        others.next().filter(runs_back).filter(|_| others.next().is_none())
    }

    fn edge_fan(&self, h: T::HalfEdge) -> impl Iterator<Item = T::HalfEdge> {
        core::iter::once(h).chain(self.others(h))
    }

    fn is_boundary(&self, h: T::HalfEdge) -> bool {
        self.others(h).next().is_none()
    }
}

impl<T: Topology> Incidence for Searched<T> {
    fn outgoing(&self, v: T::Vertex) -> Option<T::HalfEdge> {
        self.fans(v).next()
    }

    fn fans(&self, v: T::Vertex) -> impl Iterator<Item = T::HalfEdge> {
        let open = self.out_of(v).filter(|&h| self.opposite(h).is_none());
        open.chain(self.out_of(v).filter(|&h| self.is_start_of_closed(h)))
    }

    fn neighbours(&self, v: T::Vertex) -> impl Iterator<Item = T::Vertex> {
        // Each edge is told at its least half-edge.
        let touches = move |&h: &T::HalfEdge| (self.origin(h) == v) != (self.target(h) == v);
        let edges = self.half_edges().filter(touches).filter(|&h| self.others(h).all(|g| g > h));
        edges.map(move |h| if self.origin(h) == v { self.target(h) } else { self.origin(h) })
    }
}

impl<T: Footprint> Footprint for Searched<T> {
    const BYTES: Bytes = T::BYTES;

    fn heap_bytes(&self) -> usize {
        self.mesh.heap_bytes()
    }
}

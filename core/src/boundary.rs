//! Boundary curves of any [`Adjacency`]. Compact Half-Edge level 3 keeps them: see [`Boundaries`](crate::Boundaries).
use crate::{Adjacency, Map, Slot};
use alloc::vec::Vec;

/// The boundary half-edge that follows boundary half-edge `h` along its curve: the next one around its target.
/// `None` where an edge of three or more faces, or two faces that disagree in orientation, stop the turn.
/// O(degree of the target).
pub fn next_along<M: Adjacency + ?Sized>(mesh: &M, h: M::HalfEdge) -> Option<M::HalfEdge> {
    let mut g = mesh.next(h);
    while let Some(o) = mesh.opposite(g) {
        g = mesh.next(o);
    }
    mesh.is_boundary(g).then_some(g)
}

/// The first half-edge of every boundary curve, in ascending order. O(half-edges), one byte of scratch for each.
///
/// A closed curve starts at its least half-edge. One that ends early, on a mesh that is no manifold, starts at
/// its first.
pub fn curves<M: Adjacency + ?Sized>(mesh: &M) -> Vec<M::HalfEdge> {
    let mut seen: Map<M::HalfEdge, bool> = Map::filled(mesh.half_edge_bound(), false);
    for b in mesh.half_edges().filter(|&h| mesh.is_boundary(h)) {
        if let Some(g) = next_along(mesh, b) {
            seen[g] = true;
        }
    }
    // What nothing leads to begins a curve that ends early; what is then still unmarked lies on closed ones.
    let mut starts: Vec<_> = mesh.half_edges().filter(|&h| mesh.is_boundary(h) && !seen[h]).collect();
    seen.as_mut_slice().fill(false);
    for &start in &starts {
        Curve::new(mesh, start).for_each(|h| seen[h] = true);
    }
    for start in mesh.half_edges().filter(|&h| mesh.is_boundary(h)) {
        if !seen[start] {
            starts.push(start);
            Curve::new(mesh, start).for_each(|h| seen[h] = true);
        }
    }
    starts.sort_unstable();
    starts
}

/// The half-edges of one boundary curve, in order: iterator of [`Boundaries::curve`](crate::Boundaries::curve).
#[derive(Debug)]
pub struct Curve<'a, M: Adjacency + ?Sized> {
    mesh: &'a M,
    at: Slot<M::HalfEdge>,
    start: M::HalfEdge,
    begun: bool,
}

impl<'a, M: Adjacency + ?Sized> Curve<'a, M> {
    /// The curve from boundary half-edge `start` on, once round or to its end.
    pub fn new(mesh: &'a M, start: M::HalfEdge) -> Self {
        Self { mesh, at: Slot::some(start), start, begun: false }
    }
}

impl<M: Adjacency + ?Sized> Iterator for Curve<'_, M> {
    type Item = M::HalfEdge;

    fn next(&mut self) -> Option<M::HalfEdge> {
        let h = self.at.get().filter(|&h| !(self.begun && h == self.start))?;
        self.begun = true;
        self.at = next_along(self.mesh, h).into();
        Some(h)
    }
}

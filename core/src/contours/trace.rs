//! Segments strung into lines, level by level.
//!
//! A level crosses a face once, so one mark a face serves for all levels: the last level that was traced
//! through it. Every step marks a face, which bounds the work, whatever the mesh.
use super::{Contours, Crossing, Span, buckets};
use crate::{Adjacency, Map, edges};
use alloc::vec::Vec;

/// No level: a face that no line has been through.
const NEVER: u32 = u32::MAX;

pub(super) struct Tracer<'a, M: Adjacency + ?Sized> {
    mesh: &'a M,
    field: &'a Map<M::Vertex, f32>,
    levels: &'a [f32],
    ranks: Map<M::Vertex, u32>,
    traced: Map<M::Face, u32>,
    lines: Vec<Span>,
    crossings: Vec<Crossing<M::HalfEdge>>,
}

impl<'a, M: Adjacency + ?Sized> Tracer<'a, M> {
    pub(super) fn new(mesh: &'a M, field: &'a Map<M::Vertex, f32>, levels: &'a [f32]) -> Self {
        Self {
            mesh,
            field,
            levels,
            ranks: buckets::ranks(field, levels),
            traced: Map::filled(mesh.face_count(), NEVER),
            lines: Vec::new(),
            crossings: Vec::new(),
        }
    }

    pub(super) fn lines(mut self) -> Contours<M::HalfEdge> {
        let buckets = buckets::Buckets::new(self.mesh, &self.ranks, self.levels.len());
        for level in 0..self.levels.len() as u32 {
            let faces = buckets.of(level as usize);
            // Open lines first, from their ends: what is left then is closed, and may start anywhere. A line
            // has both its ends where sides run up only where faces disagree in orientation.
            for runs_down in [true, false] {
                self.trace_from(faces, level, |tracer, f| {
                    let start = tracer.side(f, level, runs_down);
                    edges::across(tracer.mesh, start).is_none().then_some(start)
                });
            }
            self.trace_from(faces, level, |tracer, f| Some(tracer.side(f, level, true)));
        }
        Contours { lines: self.lines, crossings: self.crossings }
    }

    /// Traces the lines that start in those of `faces` that are not traced yet, over the side that `start`
    /// gives.
    fn trace_from(
        &mut self,
        faces: &[M::Face],
        level: u32,
        start: impl Fn(&Self, M::Face) -> Option<M::HalfEdge>,
    ) {
        for &f in faces {
            if self.traced[f] != level
                && let Some(h) = start(self, f)
            {
                self.trace(h, level);
            }
        }
    }

    /// Traces one line, which comes into its first face over `h`.
    fn trace(&mut self, mut h: M::HalfEdge, level: u32) {
        let is_closed = loop {
            self.cross(h, level);
            self.traced[self.mesh.face(h)] = level;
            let out = self.way_out(h, level);
            match edges::across(self.mesh, out) {
                // Only the first face can be met again.
                Some(g) if self.traced[self.mesh.face(g)] == level => break true,
                Some(g) => h = g,
                None => {
                    self.cross(out, level);
                    break false;
                }
            }
        };
        let level = self.levels[level as usize];
        self.lines.push(Span { level, is_closed, end: self.crossings.len() });
    }

    fn is_above(&self, v: M::Vertex, level: u32) -> bool {
        self.ranks[v] > level
    }

    /// The side of `f` that runs down through the level, or the one that runs up: it is crossed, so it has
    /// both.
    fn side(&self, f: M::Face, level: u32, runs_down: bool) -> M::HalfEdge {
        let [a, b, c] = self.mesh.face_half_edges(f);
        let [x, y, z] = [a, b, c].map(|h| self.is_above(self.mesh.origin(h), level) == runs_down);
        match [x, y, z] {
            [true, false, _] => a,
            [_, true, false] => b,
            _ => c,
        }
    }

    /// The other crossed side of the face of `h`.
    fn way_out(&self, h: M::HalfEdge, level: u32) -> M::HalfEdge {
        let (next, prev) = (self.mesh.next(h), self.mesh.prev(h));
        let [target, apex] = [next, prev].map(|g| self.is_above(self.mesh.origin(g), level));
        if target == apex { prev } else { next }
    }

    fn cross(&mut self, h: M::HalfEdge, level: u32) {
        let [from, to] = [self.mesh.origin(h), self.mesh.target(h)].map(|v| f64::from(self.field[v]));
        let level = f64::from(self.levels[level as usize]);
        self.crossings.push(Crossing { half_edge: h, t: (level - from) / (to - from) });
    }
}

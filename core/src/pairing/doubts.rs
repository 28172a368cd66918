//! Settles the doubts of the chain: whether some edge of a vertex was taken for two.
//!
//! The chain knows of how many edges a vertex is the lower end. Where one turn around the vertex meets so many, and no two
//! of them lead to the same neighbour, each was one. That is so for nearly all that a filter is in doubt about.
use super::{chain::Vertices, joiner::Joiner};
use crate::{BuildError, HalfEdgeId, Handle, corner, memory};
use alloc::vec::Vec;
use smallvec::SmallVec;

/// Turns that are made step by step together, so that they wait for memory together.
const TOGETHER: usize = 32;

/// The lower vertices in doubt that remain: those that have an edge of three or more half-edges, or of two that run alike,
/// and some of several fans. O(n log n) in the half-edges around all vertices in doubt.
pub(super) fn unsettled(
    vertices: &Vertices,
    faces: &[[u32; 3]],
    joiner: &Joiner<'_>,
) -> Result<Vec<u32>, BuildError> {
    let filters = vertices.filters();
    let counted: usize = filters.iter().map(|filter| filter.edge_count() as usize).sum();
    // A filter counts up to 255.
    let counts =
        if counted == vertices.edge_count { None } else { Some(count(filters.len(), faces, joiner)?) };
    let edge_count = |low: usize| counts.as_ref().map_or(filters[low].edge_count(), |counts| counts[low]);
    let mut in_doubt = Vec::new();
    for low in 0..filters.len() {
        if filters[low].bit_count() != edge_count(low) {
            memory::push(&mut in_doubt, low as u32)?;
        }
    }
    let mut unsettled = Vec::new();
    for lows in in_doubt.chunks(TOGETHER) {
        let mut turns: SmallVec<[Turn; TOGETHER]> =
            lows.iter().map(|&low| Turn::new(low, vertices.half_edge(low), faces)).collect();
        loop {
            let mut is_done = true;
            for turn in &mut turns {
                is_done &= turn.is_done || turn.step(faces, joiner)?;
            }
            if is_done {
                break;
            }
        }
        for turn in &mut turns {
            if !turn.met_all(edge_count(turn.low as usize) as usize) {
                memory::push(&mut unsettled, turn.low)?;
            }
        }
    }
    Ok(unsettled)
}

/// Of how many edges each vertex is the lower end, as the chain sees them: one that is open, or a pair.
fn count(vertex_count: usize, faces: &[[u32; 3]], joiner: &Joiner<'_>) -> Result<Vec<u32>, BuildError> {
    let mut counts = memory::filled(vertex_count, 0)?;
    for h in 0..3 * faces.len() {
        if joiner.opposite(HalfEdgeId::new(h)).is_none_or(|o| h < o.index()) {
            counts[corner::origin(faces, h).min(corner::target(faces, h)) as usize] += 1;
        }
    }
    Ok(counts)
}

/// A turn around a vertex, counter-clockwise, and if it ends, clockwise from where it began.
struct Turn {
    low: u32,
    start: HalfEdgeId,
    at: HalfEdgeId,
    is_clockwise: bool,
    is_done: bool,
    /// The higher neighbours that it met: one for each edge.
    highs: SmallVec<[u32; 12]>,
}

impl Turn {
    /// `h` lies along an edge of `low`.
    fn new(low: u32, h: HalfEdgeId, faces: &[[u32; 3]]) -> Self {
        let start = if corner::origin(faces, h.index()) == low { h } else { corner::next(h) };
        Self { low, start, at: start, is_clockwise: false, is_done: false, highs: SmallVec::new() }
    }

    /// Goes on by one face. Gives whether it is done.
    fn step(&mut self, faces: &[[u32; 3]], joiner: &Joiner<'_>) -> Result<bool, BuildError> {
        if self.is_clockwise {
            let Some(across) = joiner.opposite(self.at) else {
                self.is_done = true;
                return Ok(true);
            };
            self.at = corner::next(across);
            self.meet(corner::target(faces, self.at.index()))?;
            return Ok(false);
        }
        self.meet(corner::target(faces, self.at.index()))?;
        let before = corner::prev(self.at);
        match joiner.opposite(before) {
            Some(next) if next == self.start => self.is_done = true,
            Some(next) => self.at = next,
            None => {
                self.meet(corner::origin(faces, before.index()))?;
                (self.at, self.is_clockwise) = (self.start, true);
            }
        }
        Ok(self.is_done)
    }

    fn meet(&mut self, v: u32) -> Result<(), BuildError> {
        if v > self.low {
            if self.highs.len() == self.highs.capacity() {
                let bytes = 2 * size_of_val(&self.highs[..]);
                self.highs.try_reserve(1).map_err(|_| BuildError::OutOfMemory { bytes })?;
            }
            self.highs.push(v);
        }
        Ok(())
    }

    /// Whether it met so many higher neighbours, all of them different.
    fn met_all(&mut self, edge_count: usize) -> bool {
        self.highs.sort_unstable();
        self.highs.len() == edge_count && self.highs.windows(2).all(|pair| pair[0] != pair[1])
    }
}

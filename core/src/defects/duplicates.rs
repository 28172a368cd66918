//! Triangles with the same three vertices.

use super::edges::{Edge, EdgeTable};
use super::triangles::Triangles;
use alloc::vec::Vec;
use smallvec::SmallVec;

/// The triangles whose vertex set an earlier one has.
pub(crate) struct Duplicates {
    /// Triangle numbers, rising.
    pub(crate) copies: Vec<u32>,
    /// How many of them repeat the cyclic order of an earlier one too.
    pub(crate) same_orientation: usize,
}

impl Duplicates {
    /// Compares triangles at the edge of their two lowest vertices only, so each once. O(edges), and
    /// O(d log d) for an edge of d triangles.
    pub(crate) fn find(edges: &EdgeTable, triangles: &Triangles) -> Self {
        let mut found = Self { copies: Vec::new(), same_orientation: 0 };
        for edge in edges.iter(triangles).filter(|edge| edge.sides.len() > 1) {
            found.compare_at(edge);
        }
        found.copies.sort_unstable();
        found
    }

    fn compare_at(&mut self, edge: Edge<'_>) {
        let (_, higher) = edge.ends();
        let above = edge.sides.iter().map(|&side| (edge.apex(side), side)).filter(|&(apex, _)| apex > higher);
        let mut above: SmallVec<[(u32, u32); 4]> = above.collect();
        above.sort_unstable();
        for group in above.chunk_by(|a, b| a.0 == b.0) {
            let mut seen = [false; 2];
            for &(_, side) in group {
                if seen != [false; 2] {
                    self.copies.push(side / 3);
                }
                let seen = &mut seen[usize::from(edge.rises(side))];
                self.same_orientation += usize::from(*seen);
                *seen = true;
            }
        }
    }
}

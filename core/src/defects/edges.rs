//! The undirected edges of a triangle list, each with all its half-edges.

use super::triangles::{Triangles, next};
use alloc::vec;
use alloc::vec::Vec;

/// All half-edges, gathered by edge: edges in order of (lower, higher) vertex, half-edges rising within one.
///
/// Half-edge `h` runs from corner `h` to the next corner of triangle `h / 3`.
pub(crate) struct EdgeTable {
    sides: Vec<u32>,
    /// Where each edge starts in `sides`, and one end.
    starts: Vec<u32>,
}

/// One edge, as the half-edges along it; there is at least one.
#[derive(Clone, Copy)]
pub(crate) struct Edge<'a> {
    pub(crate) sides: &'a [u32],
    corners: &'a [u32],
}

impl EdgeTable {
    /// Buckets the half-edges by lower vertex and sorts each bucket by the higher one.
    /// O(h + sum of d log d) for buckets of d half-edges: linear for all but enormous valences.
    pub(crate) fn of(triangles: &Triangles) -> Self {
        let corners = &triangles.corners;
        let mut ends = vec![0u32; triangles.vertex_bound + 1];
        for h in 0..corners.len() as u32 {
            ends[lower_higher(corners, h).0 as usize + 1] += 1;
        }
        for v in 1..ends.len() {
            ends[v] += ends[v - 1];
        }
        let mut keys = vec![0u64; corners.len()];
        for h in 0..corners.len() as u32 {
            let (lower, higher) = lower_higher(corners, h);
            let place = &mut ends[lower as usize];
            keys[*place as usize] = u64::from(higher) << 32 | u64::from(h);
            *place += 1;
        }
        // Filling has moved every start to the end of its bucket.
        Self::cut_up(keys, &ends[..triangles.vertex_bound])
    }

    fn cut_up(mut keys: Vec<u64>, bucket_ends: &[u32]) -> Self {
        let mut starts = Vec::with_capacity(keys.len() / 2 + 1);
        let mut begin = 0;
        for &end in bucket_ends {
            let bucket = &mut keys[begin as usize..end as usize];
            bucket.sort_unstable();
            for i in 0..bucket.len() {
                if i == 0 || bucket[i] >> 32 != bucket[i - 1] >> 32 {
                    starts.push(begin + i as u32);
                }
            }
            begin = end;
        }
        starts.push(begin);
        Self { sides: keys.iter().map(|&key| key as u32).collect(), starts }
    }

    pub(crate) fn count(&self) -> usize {
        self.starts.len() - 1
    }

    pub(crate) fn iter<'a>(&'a self, triangles: &'a Triangles) -> impl Iterator<Item = Edge<'a>> {
        self.starts.windows(2).map(|range| Edge {
            sides: &self.sides[range[0] as usize..range[1] as usize],
            corners: &triangles.corners,
        })
    }
}

impl Edge<'_> {
    /// The two ends, as vertex slots, the lower one first.
    #[inline]
    pub(crate) fn ends(&self) -> (u32, u32) {
        lower_higher(self.corners, self.sides[0])
    }

    /// Whether this half-edge runs from the lower to the higher end.
    #[inline]
    pub(crate) fn rises(&self, side: u32) -> bool {
        self.corners[side as usize] < self.corners[next(side) as usize]
    }

    /// The corners of this half-edge at the lower and at the higher end.
    #[inline]
    pub(crate) fn corners(&self, side: u32) -> (u32, u32) {
        if self.rises(side) { (side, next(side)) } else { (next(side), side) }
    }

    /// The vertex across from the edge in this half-edge's triangle.
    #[inline]
    pub(crate) fn apex(&self, side: u32) -> u32 {
        self.corners[next(next(side)) as usize]
    }

    /// The half-edges, if there are two, and whether they run the same way, which should not be.
    #[inline]
    pub(crate) fn two_sides(&self) -> Option<(u32, u32, bool)> {
        let &[a, b] = self.sides else { return None };
        Some((a, b, self.rises(a) == self.rises(b)))
    }
}

#[inline(always)]
fn lower_higher(corners: &[u32], h: u32) -> (u32, u32) {
    let (a, b) = (corners[h as usize], corners[next(h) as usize]);
    if a < b { (a, b) } else { (b, a) }
}

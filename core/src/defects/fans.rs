//! Fans: the triangles at a vertex that hang together by edges. A vertex of several fans is a bowtie.

use super::edges::{Edge, EdgeTable};
use super::triangles::Triangles;
use crate::union_find::UnionFind;
use alloc::vec;
use alloc::vec::Vec;

/// Which fan each corner is in: the sets of corners that edges join.
pub(crate) struct Fans {
    of_corner: UnionFind,
}

impl Fans {
    /// Every corner a fan of its own.
    pub(crate) fn apart(triangles: &Triangles) -> Self {
        Self { of_corner: UnionFind::new(triangles.corners.len()) }
    }

    /// Joins two half-edges of an edge: their corners at either end are in one fan.
    #[inline]
    pub(crate) fn join(&mut self, edge: Edge<'_>, a: u32, b: u32) {
        let ((low_a, high_a), (low_b, high_b)) = (edge.corners(a), edge.corners(b));
        self.of_corner.union(low_a, low_b);
        self.of_corner.union(high_a, high_b);
    }

    /// The fans of a mesh as it stands, where an edge joins all its faces, however many.
    pub(crate) fn of(edges: &EdgeTable, triangles: &Triangles) -> Self {
        let mut fans = Self::apart(triangles);
        for edge in edges.iter(triangles) {
            for two in edge.sides.windows(2) {
                fans.join(edge, two[0], two[1]);
            }
        }
        fans
    }

    /// The least corner of a corner's fan.
    #[inline]
    pub(crate) fn first(&mut self, corner: u32) -> u32 {
        self.of_corner.find(corner)
    }

    /// How many fans each vertex slot has.
    pub(crate) fn counts(&mut self, triangles: &Triangles) -> Vec<u32> {
        let mut counts = vec![0; triangles.vertex_bound];
        for (corner, &slot) in (0..).zip(&triangles.corners) {
            counts[slot as usize] += u32::from(self.first(corner) == corner);
        }
        counts
    }
}

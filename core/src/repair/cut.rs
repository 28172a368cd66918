//! Cutting: one vertex for each fan that is left when only consistent edges of two triangles join.
//!
//! Such a fan is a path or a cycle of triangles, oriented alike, so an edge at it has at most two of them, and
//! two only where the path's ends meet: in opposite directions, and at both ends of the edge or at none. That is why
//! vertices need cutting only, and no edge can become non-manifold again by its copies falling together. It
//! also heals what it can: a fin on a closed surface comes off, and the surface stays whole.
//! After Guéziec, Taubin, Lazarus, Horn, "Cutting and stitching", 2001.

use super::orient::Orientation;
use crate::defects::edges::EdgeTable;
use crate::defects::fans::Fans;
use crate::defects::triangles::Triangles;
use alloc::vec;
use alloc::vec::Vec;

/// New vertices for the corners of the triangles.
pub(crate) struct Cut {
    /// For each corner 0 if it keeps its vertex, else 1 + the place of its copy in `copied`.
    copy: Vec<u32>,
    /// The vertex behind each copy.
    pub(crate) copied: Vec<u32>,
    pub(crate) edges_cut: usize,
    pub(crate) vertices_cut: usize,
}

impl Cut {
    /// Near-linear in the corners. At each vertex the fan with the least corner keeps it; copies are numbered by
    /// the least corners of the other fans.
    pub(crate) fn of(edges: &EdgeTable, triangles: &Triangles, orientation: &Orientation) -> Self {
        let mut fans = Fans::apart(triangles);
        for edge in edges.iter(triangles) {
            if let Some((a, b, _)) = edge.two_sides().filter(|&(a, b, same)| orientation.agrees(a, b, same)) {
                fans.join(edge, a, b);
            }
        }
        let mut cut = Self { copy: Vec::new(), copied: Vec::new(), edges_cut: 0, vertices_cut: 0 };
        cut.copy_vertices(&mut fans, triangles);
        cut.edges_cut =
            edges.iter(triangles).filter(|edge| cut.parts(edge.sides, |h| edge.corners(h))).count();
        cut
    }

    fn copy_vertices(&mut self, fans: &mut Fans, triangles: &Triangles) {
        let mut fan_count = vec![0u32; triangles.vertex_bound];
        for (corner, &slot) in (0..).zip(&triangles.corners) {
            let first = fans.first(corner);
            if first < corner {
                self.copy.push(self.copy[first as usize]);
                continue;
            }
            let count = &mut fan_count[slot as usize];
            *count += 1;
            self.vertices_cut += usize::from(*count == 2);
            if *count > 1 {
                self.copied.push(triangles.vertex(slot));
            }
            self.copy.push(if *count > 1 { self.copied.len() as u32 } else { 0 });
        }
    }

    /// Whether the half-edges of an edge no longer have the same two vertices.
    fn parts(&self, sides: &[u32], corners: impl Fn(u32) -> (u32, u32)) -> bool {
        let ends = |&side: &u32| {
            let (low, high) = corners(side);
            (self.copy[low as usize], self.copy[high as usize])
        };
        sides.windows(2).any(|two| ends(&two[0]) != ends(&two[1]))
    }

    /// The new vertex of a corner; copies are numbered from `vertex_count`, which with the copies is in range.
    pub(crate) fn vertex(&self, triangles: &Triangles, corner: u32, vertex_count: u32) -> u32 {
        match self.copy[corner as usize] {
            0 => triangles.vertex(triangles.corners[corner as usize]),
            place => vertex_count + place - 1,
        }
    }
}

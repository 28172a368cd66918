//! The edges of one triangle, and how they close up.

use super::edges::EdgeTable;
use super::fans::Fans;
use super::triangles::{Triangles, next};
use crate::union_find::UnionFind;
use alloc::vec;
use alloc::vec::Vec;

/// How the boundary edges hang together.
pub(crate) struct Boundary {
    /// Components of the graph of the boundary edges.
    pub(crate) components: usize,
    /// Cycles, where a boundary passes through a bowtie once for each fan; `None` where a fan has other than
    /// 0 or 2 boundary edges.
    pub(crate) loops: Option<usize>,
}

impl Boundary {
    /// O(vertices + boundary log boundary).
    pub(crate) fn of(edges: &EdgeTable, triangles: &Triangles, fans: &mut Fans) -> Self {
        let sides = edges.iter(triangles).filter(|edge| edge.sides.len() == 1).map(|edge| edge.sides[0]);
        let sides: Vec<u32> = sides.collect();
        Self { components: components(&sides, triangles), loops: loops(&sides, fans) }
    }
}

fn components(sides: &[u32], triangles: &Triangles) -> usize {
    let mut graph = UnionFind::new(triangles.vertex_bound);
    let mut touched = vec![false; triangles.vertex_bound];
    for &h in sides {
        let [a, b] = [h, next(h)].map(|corner| triangles.corners[corner as usize]);
        graph.union(a, b);
        touched[a as usize] = true;
        touched[b as usize] = true;
    }
    (0..).zip(touched).filter(|&(slot, touched)| touched && graph.find(slot) == slot).count()
}

/// Two boundary edges that end in the same fan follow each other.
fn loops(sides: &[u32], fans: &mut Fans) -> Option<usize> {
    let mut ends = Vec::with_capacity(2 * sides.len());
    for (i, &h) in (0..).zip(sides) {
        ends.extend([(fans.first(h), i), (fans.first(next(h)), i)]);
    }
    ends.sort_unstable();
    let mut curves = UnionFind::new(sides.len());
    for fan in ends.chunk_by(|a, b| a.0 == b.0) {
        let &[(_, a), (_, b)] = fan else { return None };
        curves.union(a, b);
    }
    Some(curves.set_count())
}

//! Components, and patches: the triangles that hang together by edges of exactly two. A patch is what can be
//! oriented; at an edge of three triangles no orientation is right.

use super::edges::EdgeTable;
use super::triangles::Triangles;
use crate::union_find::{Joined, ParityUnionFind, UnionFind};
use alloc::vec;
use alloc::vec::Vec;

/// The figures of the patches.
pub(crate) struct Patches {
    pub(crate) count: usize,
    /// The least triangle of every patch that cannot be oriented, rising.
    pub(crate) nonorientable: Vec<u32>,
    pub(crate) min_flips: usize,
    pub(crate) components: usize,
}

impl Patches {
    /// Near-linear in the edges.
    pub(crate) fn of(edges: &EdgeTable, triangles: &Triangles) -> Self {
        let mut sheets = ParityUnionFind::new(triangles.count());
        let mut torn = Vec::new();
        for (a, b, same_way) in edges.iter(triangles).filter_map(|edge| edge.two_sides()) {
            if sheets.union(a / 3, b / 3, same_way) == Joined::Contradicted {
                torn.push(a / 3);
            }
        }
        let mut nonorientable: Vec<u32> = torn.iter().map(|&t| sheets.find(t).0).collect();
        nonorientable.sort_unstable();
        nonorientable.dedup();
        Self {
            count: sheets.set_count(),
            min_flips: min_flips(&mut sheets, triangles, &nonorientable),
            components: components(sheets, edges, triangles),
            nonorientable,
        }
    }
}

fn min_flips(sheets: &mut ParityUnionFind, triangles: &Triangles, nonorientable: &[u32]) -> usize {
    let tally = tally(sheets, triangles.count());
    let flips = (0..).zip(&tally).filter(|(patch, _)| nonorientable.binary_search(patch).is_err());
    flips.map(|(_, &[even, odd])| even.min(odd) as usize).sum()
}

/// How many triangles of each patch are even and odd; zeros where a triangle is not the least of its patch.
pub(crate) fn tally(sheets: &mut ParityUnionFind, triangles: usize) -> Vec<[u32; 2]> {
    let mut tally = vec![[0; 2]; triangles];
    for t in 0..triangles as u32 {
        let (patch, odd) = sheets.find(t);
        tally[patch as usize][usize::from(odd)] += 1;
    }
    tally
}

/// Components are patches, joined by the edges of more than two triangles.
fn components(mut sheets: ParityUnionFind, edges: &EdgeTable, triangles: &Triangles) -> usize {
    for edge in edges.iter(triangles).filter(|edge| edge.sides.len() > 2) {
        for two in edge.sides.windows(2) {
            // What it says of parities no longer matters.
            sheets.union(two[0] / 3, two[1] / 3, false);
        }
    }
    sheets.set_count()
}

/// Components of the triangles that hang together by vertices.
pub(crate) fn components_by_vertex(triangles: &Triangles, used: usize) -> usize {
    let mut vertices = UnionFind::new(triangles.vertex_bound);
    for t in triangles.corners.chunks_exact(3) {
        vertices.union(t[0], t[1]);
        vertices.union(t[0], t[2]);
    }
    // Every slot that no triangle uses is still a set of its own.
    vertices.set_count() - (triangles.vertex_bound - used)
}

//! Orienting patches with the fewest flips.

use crate::defects::edges::EdgeTable;
use crate::defects::patches::tally;
use crate::defects::triangles::Triangles;
use crate::union_find::{Joined, ParityUnionFind};
use alloc::vec::Vec;

/// Which triangles to flip, and how many edges cannot be made consistent: the seams.
pub(crate) struct Orientation {
    pub(crate) flip: Vec<bool>,
    pub(crate) seam_edges: usize,
}

impl Orientation {
    /// Near-linear in the edges.
    ///
    /// Edges that are consistent as they stand are joined first: where a patch cannot be oriented, a seam that
    /// is there already is kept, and no other one torn open. In each patch the lesser part is flipped; of two
    /// equal halves, the one without the patch's first triangle.
    pub(crate) fn of(edges: &EdgeTable, triangles: &Triangles) -> Self {
        let mut sheets = ParityUnionFind::new(triangles.count());
        let mut seam_edges = 0;
        for pass in [false, true] {
            let two_sided = edges.iter(triangles).filter_map(|edge| edge.two_sides());
            for (a, b, same_way) in two_sided.filter(|&(_, _, same_way)| same_way == pass) {
                let joined = sheets.union(a / 3, b / 3, same_way);
                seam_edges += usize::from(joined == Joined::Contradicted);
            }
        }
        let tally = tally(&mut sheets, triangles.count());
        let flip = (0..triangles.count() as u32).map(|t| {
            let (patch, odd) = sheets.find(t);
            let [even_count, odd_count] = tally[patch as usize];
            odd == (odd_count <= even_count)
        });
        Self { flip: flip.collect(), seam_edges }
    }

    /// Whether two triangles, which now run the same way along an edge or not, will be consistent there.
    pub(crate) fn agrees(&self, a: u32, b: u32, same_way: bool) -> bool {
        same_way == (self.flip[(a / 3) as usize] != self.flip[(b / 3) as usize])
    }
}

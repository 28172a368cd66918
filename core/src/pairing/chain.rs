//! A list of edges for each lower vertex, linked through the table of opposites itself.
//!
//! While it runs, the cell of half-edge `h` holds, for an edge whose root is `h`:
//! - the next root in the list of its lower vertex, where `h` is alone so far;
//! - its opposite with the top bit set, where it is paired; the next root then stands in the opposite's cell.
//!
//! A paired edge stays in its list, so that a third face is noticed when it comes. New roots go to the end of
//! a list (the search has walked there anyway), so a link always leads to a later half-edge. That is what tells
//! links and opposites apart in the end, in one pass.
use super::{Paired, counting_sort, joiner::Joiner};
use crate::{BuildError, HalfEdgeId, Handle, Slot, corner, memory};
use alloc::vec::Vec;

const PAIRED: u32 = 1 << 31;
const END: u32 = PAIRED - 1;

/// One bit of a cell is taken, and `END` is no half-edge.
pub(super) const MAX_HALF_EDGES: usize = END as usize;

/// Steps along lists, for each half-edge, before the input is taken for one with a few vertices of huge degree.
/// A list has some three edges on a mesh of degree 6, and a search ends in it or at its end.
const PATIENCE: usize = 16;

pub(super) fn pair(vertex_count: usize, faces: &[[u32; 3]]) -> Result<Paired, BuildError> {
    if 3 * faces.len() > MAX_HALF_EDGES {
        return counting_sort::pair(vertex_count, faces);
    }
    let mut lists = Lists {
        faces,
        head: memory::filled(vertex_count, END)?,
        cell: memory::filled(3 * faces.len(), END)?,
    };
    let mut extra = Vec::new();
    let mut patience = PATIENCE * 3 * faces.len();
    for (f, &[a, b, c]) in faces.iter().enumerate() {
        for (k, (a, b)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
            let h = (3 * f + k) as u32;
            if let Some(root) = lists.add(h, a, b, &mut patience) {
                memory::push(&mut extra, (HalfEdgeId::new(root as usize), HalfEdgeId::new(h as usize)))?;
            }
        }
        if patience == 0 {
            drop(lists);
            return counting_sort::pair(vertex_count, faces);
        }
    }
    Joiner::with(faces, lists.into_opposites(), extra).finish()
}

struct Lists<'a> {
    faces: &'a [[u32; 3]],
    head: Vec<u32>,
    cell: Vec<u32>,
}

impl Lists<'_> {
    /// Adds half-edge `h`, which runs from `a` to `b`. Gives the root of its edge where it does not pair.
    #[inline(always)]
    fn add(&mut self, h: u32, a: u32, b: u32, patience: &mut usize) -> Option<u32> {
        let low = a.min(b);
        let mut root = self.head[low as usize];
        if root == END {
            self.head[low as usize] = h;
            return None;
        }
        loop {
            let (c, d) =
                (corner::origin(self.faces, root as usize), corner::target(self.faces, root as usize));
            let cell = self.cell[root as usize];
            let is_paired = cell & PAIRED != 0;
            if (c, d) == (b, a) && !is_paired {
                self.cell[root as usize] = h | PAIRED;
                self.cell[h as usize] = cell;
                return None;
            }
            if (c, d) == (b, a) || (c, d) == (a, b) {
                return Some(root);
            }
            let link = if is_paired { cell & !PAIRED } else { root };
            let next = self.cell[link as usize];
            if next == END {
                self.cell[link as usize] = h;
                return None;
            }
            root = next;
            *patience = patience.saturating_sub(1);
        }
    }

    /// Turns links into opposites, in place.
    fn into_opposites(mut self) -> Vec<Slot<HalfEdgeId>> {
        self.head = Vec::new();
        for h in 0..self.cell.len() {
            let cell = self.cell[h];
            if cell & PAIRED != 0 {
                self.cell[h] = cell & !PAIRED;
                self.cell[(cell & !PAIRED) as usize] = h as u32;
            } else if cell as usize > h {
                self.cell[h] = u32::MAX; // a link, or the end of a list
            }
        }
        let slot =
            |cell| if cell == u32::MAX { Slot::NONE } else { Slot::some(HalfEdgeId::new(cell as usize)) };
        self.cell.into_iter().map(slot).collect() // in place
    }
}

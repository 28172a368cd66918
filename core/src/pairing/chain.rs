//! Lists of open edges for each lower vertex, linked through the table of opposites itself.
//!
//! An edge is open while one half-edge of it has come. The next one looks for it among the open edges of its lower vertex, one
//! or two on a mesh in order, takes it out, and both have their opposite. A third half-edge on that edge then looks
//! like the first of a new one. So a vertex has a filter as well, three bits for each edge by its other end: where those of
//! a new edge are set, all edges of that lower vertex are paired once more, by lists that keep what is paired. That is so for
//! every irregular edge, and for a few vertices in a thousand that have none.
use super::{Paired, joiner::Joiner, partition};
use crate::{BuildError, HalfEdgeId, Handle, Slot, corner, memory};
use alloc::vec::Vec;

const END: u32 = u32::MAX;

/// Steps along lists, for each half-edge, before the input is taken for one that is shuffled or has a few vertices of
/// huge degree. On a mesh in order it is about one.
const PATIENCE: usize = 4;

/// Lower vertices in doubt, for each face, before partition serves all of them better: 1 in so many.
const RARE: usize = 4;

pub(super) fn pair(vertex_count: usize, faces: &[[u32; 3]]) -> Result<Paired, BuildError> {
    let mut lists = Lists {
        origin: faces.as_flattened(),
        open: memory::filled(vertex_count, END)?,
        filters: memory::filled(vertex_count, [0; 3])?,
        cell: memory::filled(3 * faces.len(), END)?,
        patience: PATIENCE * 3 * faces.len(),
    };
    let mut in_doubt = Vec::new();
    for (f, &[a, b, c]) in faces.iter().enumerate() {
        for (k, (a, b)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
            if lists.add((3 * f + k) as u32, a, b) {
                memory::push(&mut in_doubt, a.min(b))?;
            }
        }
        if lists.patience == 0 || in_doubt.len() > faces.len() / RARE + 1 {
            drop((lists, in_doubt));
            return partition::pair(vertex_count, faces);
        }
    }
    let mut joiner = Joiner::with(faces, lists.into_opposites());
    if !in_doubt.is_empty() {
        partition::pair_again(vertex_count, faces, &in_doubt, &mut joiner)?;
    }
    joiner.finish()
}

struct Lists<'a> {
    /// Of each half-edge.
    origin: &'a [u32],
    /// The first open edge of each lower vertex.
    open: Vec<u32>,
    /// What edges each lower vertex had: a bit in each word for each of them.
    filters: Vec<[u16; 3]>,
    /// The opposite of each half-edge, or the next open edge.
    cell: Vec<u32>,
    patience: usize,
}

impl Lists<'_> {
    /// Adds half-edge `h`, which runs from `a` to `b`. Gives whether it may not be the first of the edge it opens.
    #[inline(always)]
    fn add(&mut self, h: u32, a: u32, b: u32) -> bool {
        let (low, high) = (a.min(b), a.max(b));
        let open = &mut self.open[low as usize];
        let (mut before, mut at) = (END, *open);
        while at != END {
            let next = self.cell[at as usize];
            // One end is `low`. The other one of a half-edge that runs back is its origin if this one goes up, else its target;
            // at one that runs along with this it is `low` there, which is not `high`.
            let end = if a < b { at as usize } else { corner::next(HalfEdgeId::new(at as usize)).index() };
            if self.origin[end] == high {
                if before == END {
                    *open = next;
                } else {
                    self.cell[before as usize] = next;
                }
                self.cell[at as usize] = h;
                self.cell[h as usize] = at;
                return false;
            }
            (before, at) = (at, next);
            self.patience = self.patience.saturating_sub(1);
        }
        if before == END {
            *open = h;
        } else {
            self.cell[before as usize] = h;
        }
        let hash = high.wrapping_mul(0x9E37_79B9);
        let bits = [hash >> 28, hash >> 24, hash >> 20].map(|place| 1 << (place & 15));
        let filter = &mut self.filters[low as usize];
        let [x, y, z] = *filter;
        *filter = [x | bits[0], y | bits[1], z | bits[2]];
        *filter == [x, y, z]
    }

    /// Edges that are open in the end have no opposite.
    fn into_opposites(mut self) -> Vec<Slot<HalfEdgeId>> {
        drop(self.filters);
        for mut at in self.open {
            while at != END {
                at = core::mem::replace(&mut self.cell[at as usize], END);
            }
        }
        bytemuck::cast_vec(self.cell) // `END` is none
    }
}

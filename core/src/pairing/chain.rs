//! Lists of open edges for each lower vertex, linked through the table of opposites itself.
//!
//! An edge is open while one half-edge of it has come. The next one looks for it among the open edges of its lower vertex, one
//! or two on a mesh in order, takes it out, and both have their opposite. A third half-edge on that edge then looks
//! like the first of a new one. So a vertex has a filter as well, one bit of 56 for each edge by its other end, and counts
//! its edges. Where they are more than bits are set, two may be one: [`doubts`] settles that in the end.
use super::{Paired, Pairing, Starts, doubts, joiner::Joiner, partition};
use crate::{BuildError, HalfEdgeId, Handle, Slot, corner, memory::Spare};
use alloc::vec::Vec;

/// Ends the table of opposites as none, and is the list of a vertex that had no edge.
const NONE: u32 = u32::MAX;

/// Ends a list. Below it is the half-edge that came first to the vertex, for a turn around it to begin with.
const END: u32 = 1 << 31;

/// Steps along lists, for each half-edge, before the input is taken for one that is shuffled or has a few vertices of
/// huge degree. On a mesh in order it is about one.
const PATIENCE: usize = 4;

pub(super) fn pair(
    vertex_count: usize,
    faces: &[[u32; 3]],
    table: Vec<Slot<HalfEdgeId>>,
    wants_starts: bool,
    spare: &mut Spare,
) -> Result<(Paired, Starts), BuildError> {
    if table.len() > END as usize {
        return partition::pair(vertex_count, faces, table, wants_starts, spare);
    }
    let mut cells: Vec<u32> = bytemuck::cast_vec(table);
    let mut vertices = Vertices::new(vertex_count, spare)?;
    let is_done = vertices.pair(faces, &mut cells);
    let opposite = bytemuck::cast_vec(cells); // `NONE` is none
    if !is_done {
        vertices.leave(spare);
        return partition::pair(vertex_count, faces, opposite, wants_starts, spare);
    }
    let mut joiner = Joiner::with(faces, opposite);
    let lows = doubts::unsettled(&vertices, faces, &joiner)?;
    vertices.leave(spare);
    if !lows.is_empty() {
        partition::pair_again(vertex_count, faces, Some(&lows), &mut joiner)?;
    }
    Ok((joiner.finish(Pairing::Chain)?, None))
}

/// What is known of each lower vertex.
pub(super) struct Vertices {
    /// Its first open edge; in the end, the half-edge that came first, over `END`.
    open: Vec<u32>,
    filters: Vec<Filter>,
    /// Of all together.
    pub(super) edge_count: usize,
}

impl Vertices {
    fn new(vertex_count: usize, spare: &mut Spare) -> Result<Self, BuildError> {
        let mut open = spare.room(vertex_count)?;
        open.resize(vertex_count, NONE);
        let filters = bytemuck::cast_vec(spare.filters(vertex_count)?);
        Ok(Self { open, filters, edge_count: 0 })
    }

    /// Leaves its tables to the next mesh.
    fn leave(self, spare: &mut Spare) {
        spare.keep(self.open);
        spare.keep_filters(bytemuck::cast_vec(self.filters));
    }

    /// Puts opposites into `cells`, whatever they held. Gives whether patience was enough.
    fn pair(&mut self, faces: &[[u32; 3]], cells: &mut [u32]) -> bool {
        let edge_count = pair_all(faces, &mut self.open, &mut self.filters, cells);
        self.edge_count = edge_count.unwrap_or(0);
        edge_count.is_some()
    }

    pub(super) fn filters(&self) -> &[Filter] {
        &self.filters
    }

    /// A half-edge of the vertex, which is the lower end of some.
    pub(super) fn half_edge(&self, low: u32) -> HalfEdgeId {
        HalfEdgeId::new((self.open[low as usize] & !END) as usize)
    }
}

/// Gives the number of edges, unless patience was not enough.
///
/// Never inline: that its tables lie apart, which the loop is half again as fast for, is known of arguments, but not of tables
/// that may have come from anywhere. And the processor has registers for all that the loop needs, but for not one thing
/// more: edges are counted in the end, and tables are as long as one another where the compiler sees it.
#[inline(never)]
fn pair_all(
    faces: &[[u32; 3]],
    open: &mut [u32],
    filters: &mut [Filter],
    cells: &mut [u32],
) -> Option<usize> {
    let (origins, patience) = (faces.as_flattened(), PATIENCE * 3 * faces.len());
    let (filters, cells) = (&mut filters[..open.len()], &mut cells[..origins.len()]);
    let mut lists = Lists { origins, open, filters, cells, patience };
    for (f, &[a, b, c]) in faces.iter().enumerate() {
        for (k, (a, b)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
            if !lists.add((3 * f + k) as u32, a, b) {
                return None;
            }
        }
    }
    // All others are two and two.
    Some((origins.len() + lists.close()) / 2)
}

/// The edges of a lower vertex: a bit for each in the lower 56, which others may share, and their number above that,
/// from 255 on less some 256.
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
#[repr(transparent)]
pub(super) struct Filter(u64);

impl Filter {
    const BITS: u32 = 56;

    /// Neighbours in number get bits far apart.
    #[inline(always)]
    fn add(&mut self, high: u32) {
        let place = (u64::from(high.wrapping_mul(0x9E37_79B9)) * u64::from(Self::BITS)) >> 32;
        self.0 = (self.0 | 1 << place).wrapping_add(1 << Self::BITS);
    }

    pub(super) fn bit_count(self) -> u32 {
        (self.0 << (64 - Self::BITS)).count_ones()
    }

    pub(super) fn edge_count(self) -> u32 {
        (self.0 >> Self::BITS) as u32
    }
}

struct Lists<'a> {
    /// Of each half-edge.
    origins: &'a [u32],
    open: &'a mut [u32],
    filters: &'a mut [Filter],
    /// The opposite of each half-edge, or the next open edge.
    cells: &'a mut [u32],
    patience: usize,
}

impl Lists<'_> {
    /// Adds half-edge `h`, which runs from `a` to `b`. Gives whether patience was enough.
    #[inline(always)]
    fn add(&mut self, h: u32, a: u32, b: u32) -> bool {
        let (low, high) = (a.min(b), a.max(b));
        let open = &mut self.open[low as usize];
        let (mut before, mut at) = (NONE, *open);
        while at < END {
            let next = self.cells[at as usize];
            // One end is `low`. The other one of a half-edge that runs back is its origin if this one goes up, else its target;
            // at one that runs along with this it is `low` there, which is not `high`.
            let end = if a < b { at as usize } else { corner::next(HalfEdgeId::new(at as usize)).index() };
            if self.origins[end] == high {
                if before == NONE {
                    *open = next;
                } else {
                    self.cells[before as usize] = next;
                }
                self.cells[at as usize] = h;
                self.cells[h as usize] = at;
                return true;
            }
            (before, at) = (at, next);
            if self.patience == 0 {
                return false;
            }
            self.patience -= 1;
        }
        if before == NONE {
            *open = h;
        } else {
            self.cells[before as usize] = h;
        }
        self.cells[h as usize] = if at == NONE { h | END } else { at };
        self.filters[low as usize].add(high);
        true
    }

    /// Edges that are open in the end have no opposite. Gives how many they are.
    fn close(self) -> usize {
        let mut count = 0;
        for first in self.open {
            while *first < END {
                *first = core::mem::replace(&mut self.cells[*first as usize], NONE);
                count += 1;
            }
        }
        count
    }
}

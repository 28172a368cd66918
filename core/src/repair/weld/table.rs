//! Welding by a hash table.

use super::is_nowhere;
use crate::{BuildError, memory};
use alloc::vec::Vec;

/// Slots that are looked at for each vertex at first: nearly all are found there.
const NEAR: usize = 4;

/// Steps along the table, beyond the first, that each vertex may cost on average. A good hash needs one or two.
const STEPS: usize = 16;

/// Open addressing. A slot is the hash of a vertex above its number plus one; 0 is empty.
#[derive(Debug)]
pub(super) struct Table {
    slots: Vec<u64>,
    /// The home of a hash is its first bits: growing keeps the order, so it reads and writes in order as well.
    bits: u32,
    /// Slots in use.
    used: usize,
    /// Slots that were met last, by the end of their hash. Neighbours in space are often neighbours in a list: five of
    /// six corners are found here then, near the processor.
    recent: Vec<u64>,
    steps_left: usize,
    /// Of the vertices so far.
    pub(super) positions: Vec<[f32; 3]>,
}

const RECENT: usize = 8192;

/// A table of more slots is not made.
const MAX_BITS: u32 = 31;

impl Table {
    pub(super) fn new(vertices: usize) -> Result<Self, BuildError> {
        // A closed surface has one vertex for six corners.
        let bits = (vertices / 6).max(64).next_power_of_two().ilog2().min(MAX_BITS);
        Ok(Self {
            slots: memory::filled(1 << bits, 0)?,
            bits,
            used: 0,
            recent: memory::filled(RECENT, 0)?,
            steps_left: vertices.saturating_mul(STEPS),
            positions: Vec::new(),
        })
    }

    /// The slot that was met last, of those whose hash ends alike.
    #[inline(always)]
    pub(super) fn recent(&self, hash: u32) -> u64 {
        self.recent[hash as usize % RECENT]
    }

    #[inline(always)]
    fn home(&self, hash: u32) -> usize {
        (hash >> (32 - self.bits)) as usize
    }

    /// The slot of this hash among the first few from its home on, most often of one cache line; if there is none, one
    /// of another hash.
    #[inline(always)]
    pub(super) fn near_home(&self, hash: u32) -> u64 {
        let home = self.home(hash);
        let slot = |i: usize| self.slots[(home + i) & (self.slots.len() - 1)];
        let better = |found: u64, slot: u64| if (found >> 32) as u32 == hash { found } else { slot };
        (1..NEAR).map(slot).fold(slot(0), better)
    }

    /// The vertex of a slot, if it is at this position.
    #[inline(always)]
    pub(super) fn vertex_at(&self, slot: u64, hash: u32, [x, y, z]: [f32; 3]) -> Option<u32> {
        let is_same = (slot >> 32) as u32 == hash;
        // The place of another vertex would only be a cache miss; that of the first one is at hand.
        let vertex = if is_same { (slot as u32).wrapping_sub(1) } else { 0 };
        // All in one: most are equal, and branches between would be in the way.
        let equal = |[a, b, c]: &[f32; 3]| (*a == x) & (*b == y) & (*c == z);
        let is_there = self.positions.get(vertex as usize).is_some_and(equal);
        (is_same & is_there).then_some(vertex)
    }

    /// The vertex at this position, which may have become known since it was looked up. `None` where it took too many
    /// steps.
    #[inline(always)]
    pub(super) fn resolve(&mut self, hash: u32, position: [f32; 3]) -> Result<Option<u32>, BuildError> {
        let recent = self.vertex_at(self.recent(hash), hash, position);
        if recent.is_some() {
            Ok(recent)
        } else if is_nowhere(position) {
            self.push(position).map(Some)
        } else {
            self.find_or_insert(hash, position)
        }
    }

    #[inline(always)]
    pub(super) fn remember(&mut self, hash: u32, vertex: u32) {
        self.recent[hash as usize % RECENT] = slot_of(hash, vertex);
    }

    /// The vertex at this position, a new one if there is none. `None` where it took too many steps.
    fn find_or_insert(&mut self, hash: u32, position: [f32; 3]) -> Result<Option<u32>, BuildError> {
        if self.used >= self.slots.len() / 8 * 5 && !self.grow()? {
            return Ok(None);
        }
        let mut at = self.home(hash);
        while self.slots[at] != 0 {
            if let Some(vertex) = self.vertex_at(self.slots[at], hash, position) {
                return Ok(Some(vertex));
            }
            if self.steps_left == 0 {
                return Ok(None);
            }
            self.steps_left -= 1;
            at = (at + 1) & (self.slots.len() - 1);
        }
        let vertex = self.push(position)?;
        self.slots[at] = slot_of(hash, vertex);
        self.used += 1;
        Ok(Some(vertex))
    }

    #[inline(always)]
    fn push(&mut self, position: [f32; 3]) -> Result<u32, BuildError> {
        let vertex = self.positions.len() as u32;
        memory::push(&mut self.positions, position)?;
        Ok(vertex)
    }

    /// Twice as many slots; `false` where that is too many.
    #[cold]
    fn grow(&mut self) -> Result<bool, BuildError> {
        if self.bits == MAX_BITS {
            return Ok(false);
        }
        self.bits += 1;
        let old = core::mem::replace(&mut self.slots, memory::filled(1 << self.bits, 0)?);
        for slot in old.into_iter().filter(|slot| *slot != 0) {
            let mut at = self.home((slot >> 32) as u32);
            while self.slots[at] != 0 {
                at = (at + 1) & (self.slots.len() - 1);
            }
            self.slots[at] = slot;
        }
        Ok(true)
    }
}

#[inline(always)]
fn slot_of(hash: u32, vertex: u32) -> u64 {
    u64::from(hash) << 32 | (u64::from(vertex) + 1)
}

/// Coordinates differ in few bits, often the higher ones: two multiplications bring them all to the first bits.
#[inline(always)]
pub(super) fn hash_of([x, y, z]: [u32; 3]) -> u32 {
    let xy = (u64::from(x) | u64::from(y) << 32).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let xyz = (xy ^ xy >> 32 ^ u64::from(z)).wrapping_mul(0xD6E8_FEB8_6659_FD93);
    (xyz >> 32) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::repair::weld;
    use crate::repair::weld::{Welder, key, sorted};
    use alloc::vec;

    /// Both ways, and the slow search.
    fn check(positions: &[[f32; 3]], by_table: bool) {
        let position = |v: usize| positions[v];
        let mut targets = [vec![0; positions.len()], vec![0; positions.len()]];
        let mut table = Welder::new(positions.len()).unwrap();
        let mut pieces = positions.chunks(701).zip(targets[0].chunks_mut(701));
        let welded = pieces.all(|(piece, target)| table.add(target, |v| piece[v]).unwrap());
        let sorted = sorted::weld(&mut targets[1], &position).unwrap();
        assert_eq!(welded, by_table);
        if by_table {
            assert_eq!((table.into_positions(), &targets[0]), (sorted.clone(), &targets[1]));
        }
        let firsts: Vec<usize> = positions
            .iter()
            .enumerate()
            .map(|(v, p)| positions[..v].iter().position(|other| other == p).unwrap_or(v))
            .collect();
        let source: Vec<u32> = (0..firsts.len()).filter(|v| firsts[*v] == *v).map(|v| v as u32).collect();
        assert_eq!(sorted, source.iter().map(|v| positions[*v as usize]).collect::<Vec<_>>());
        assert_eq!(weld(positions).unwrap().source, source);
        for (v, first) in firsts.iter().enumerate() {
            assert_eq!(source[targets[1][v] as usize], *first as u32);
        }
        assert_eq!(weld(positions).unwrap().target, targets[1]);
    }

    #[test]
    fn grids_soups_and_one_point() {
        let grid: Vec<[f32; 3]> = (0..3000).map(|i| [(i % 37) as f32, (i % 41) as f32 - 20.0, 0.5]).collect();
        let soup: Vec<[f32; 3]> = (0..3000).map(|i| [i as f32, 0.0, -(i as f32)]).collect();
        for positions in [grid, soup, vec![[1.0; 3]; 500], vec![[-0.0; 3]; 33]] {
            check(&positions, true);
        }
    }

    /// Positions of one home are quadratic in a hash table, each of which passes all those before it.
    #[test]
    fn chosen_positions_are_sorted() {
        let all = (0u32..).map(|i| [f32::from_bits(i), 1.0, 2.0]);
        let chosen: Vec<_> = all.filter(|p| hash_of(key(*p)) >> 20 == 0x5A5).take(500).collect();
        check(&chosen, false);
    }
}

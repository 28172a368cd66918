//! Welding by a hash table.

use super::{is_nowhere, key};
use crate::{BuildError, memory};
use alloc::vec::Vec;

/// Slots that are looked at for each vertex at first: nearly all are found there.
const NEAR: usize = 4;

/// Steps along the table, beyond the first, that each vertex may cost on average. A good hash needs one or two.
const STEPS: usize = 16;

/// Open addressing. A slot is the end of a vertex's hash above its number plus one, which takes `bits`; 0 is empty. The
/// home of a hash is its first `bits`. With half the size of a hash and a number, slots cost half as many cache misses
/// and pages of fresh memory.
#[derive(Debug)]
pub(super) struct Table {
    slots: Vec<u32>,
    bits: u32,
    steps_left: usize,
}

/// A table of more slots is not made.
const MAX_BITS: u32 = 31;

impl Table {
    pub(super) fn new(vertices: usize) -> Result<Self, BuildError> {
        // A closed surface has one vertex for six corners: its table need not grow.
        let bits = (vertices / 30 * 8).max(64).next_power_of_two().ilog2().min(MAX_BITS);
        Ok(Self { slots: memory::filled(1 << bits, 0)?, bits, steps_left: 0 })
    }

    /// So many vertices more may cost their steps.
    pub(super) fn expect(&mut self, vertices: usize) {
        self.steps_left = self.steps_left.saturating_add(vertices.saturating_mul(STEPS));
    }

    #[inline(always)]
    fn home(&self, hash: u32) -> usize {
        (hash >> (32 - self.bits)) as usize
    }

    #[inline(always)]
    fn slot_of(&self, hash: u32, vertex: u32) -> u32 {
        hash << self.bits | (vertex + 1)
    }

    /// The vertex of a slot, if its hash may be this one.
    #[inline(always)]
    fn vertex_of(&self, slot: u32, hash: u32) -> Option<u32> {
        let number = slot ^ hash << self.bits;
        (number >> self.bits == 0 && number > 0).then(|| number - 1)
    }

    /// What stands at the home of this hash.
    #[inline(always)]
    pub(super) fn at_home(&self, hash: u32) -> u32 {
        self.slots[self.home(hash)]
    }

    /// The vertex that may have this hash among the first few slots from its home on, most often of one cache line.
    #[inline(always)]
    pub(super) fn near_home(&self, hash: u32) -> Option<u32> {
        let home = self.home(hash);
        let vertex = |i: usize| self.vertex_of(self.slots[(home + i) & (self.slots.len() - 1)], hash);
        // All are looked at: a branch for each would be mispredicted too often.
        (0..NEAR).map(vertex).fold(None, |found, vertex| found.or(vertex))
    }

    /// The vertex among `positions` that is at this position, if it has a place. If not, the next vertex is put into
    /// the table. `None` where it took too many steps.
    #[inline(always)]
    pub(super) fn find_or_insert(
        &mut self,
        hash: u32,
        position: [f32; 3],
        positions: &[[f32; 3]],
    ) -> Result<Option<u32>, BuildError> {
        // The next vertex, in the table or not, has to have a number of so many bits.
        if positions.len() >= self.slots.len() / 8 * 5 && !self.grow(positions)? {
            return Ok(None);
        }
        let next = positions.len() as u32;
        if is_nowhere(position) {
            return Ok(Some(next));
        }
        let mut at = self.home(hash);
        while self.slots[at] != 0 {
            let vertex = self.vertex_of(self.slots[at], hash);
            if let Some(vertex) = vertex.filter(|vertex| positions[*vertex as usize] == position) {
                return Ok(Some(vertex));
            }
            if self.steps_left == 0 {
                return Ok(None);
            }
            self.steps_left -= 1;
            at = (at + 1) & (self.slots.len() - 1);
        }
        self.slots[at] = self.slot_of(hash, next);
        Ok(Some(next))
    }

    /// Twice as many slots; `false` where that is too many.
    #[cold]
    fn grow(&mut self, positions: &[[f32; 3]]) -> Result<bool, BuildError> {
        if self.bits == MAX_BITS {
            return Ok(false);
        }
        self.bits += 1;
        // The old ones go first: the positions tell all that they did.
        self.slots = Vec::new();
        self.slots = memory::filled(1 << self.bits, 0)?;
        for (vertex, position) in positions.iter().enumerate().filter(|(_, position)| !is_nowhere(**position))
        {
            let hash = hash_of(key(*position));
            let mut at = self.home(hash);
            while self.slots[at] != 0 {
                at = (at + 1) & (self.slots.len() - 1);
            }
            self.slots[at] = self.slot_of(hash, vertex as u32);
        }
        Ok(true)
    }
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

    /// So that a NaN equals itself.
    fn bits(positions: &[[f32; 3]]) -> Vec<[u32; 3]> {
        positions.iter().map(|p| p.map(f32::to_bits)).collect()
    }

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
            assert_eq!((bits(&table.into_positions()), &targets[0]), (bits(&sorted), &targets[1]));
        }
        let firsts: Vec<usize> = positions
            .iter()
            .enumerate()
            .map(|(v, p)| positions[..v].iter().position(|other| other == p).unwrap_or(v))
            .collect();
        let source: Vec<u32> = (0..firsts.len()).filter(|v| firsts[*v] == *v).map(|v| v as u32).collect();
        assert_eq!(
            bits(&sorted),
            source.iter().map(|v| positions[*v as usize].map(f32::to_bits)).collect::<Vec<_>>()
        );
        assert_eq!(weld(positions).unwrap().source, source);
        for (v, first) in firsts.iter().enumerate() {
            assert_eq!(source[targets[1][v] as usize], *first as u32);
        }
        assert_eq!(weld(positions).unwrap().target, targets[1]);
    }

    /// Vertices that were met long ago, of several blocks, and none of any block.
    #[test]
    fn vertices_come_back() {
        let mut at = 1u32;
        let shuffled: Vec<[f32; 3]> = (0..6000)
            .map(|_| {
                at = at.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                [(at >> 22) as f32, 0.0, 1.0]
            })
            .collect();
        let with_nowhere = |i: usize| match i % 3 {
            0 => [f32::NAN, 0.0, 0.0],
            _ => [(i % 700) as f32; 3],
        };
        for positions in [shuffled.repeat(2), (0..6000).map(with_nowhere).collect()] {
            check(&positions, true);
        }
    }

    #[test]
    fn grids_soups_and_one_point() {
        let grid: Vec<[f32; 3]> = (0..3000).map(|i| [(i % 37) as f32, (i % 41) as f32 - 20.0, 0.5]).collect();
        let soup: Vec<[f32; 3]> = (0..3000).map(|i| [i as f32, 0.0, -(i as f32)]).collect();
        for positions in [grid, soup, vec![[1.0; 3]; 500], vec![[-0.0; 3]; 33]] {
            check(&positions, true);
        }
    }

    /// How many vertices were announced says nothing of how they were chosen.
    #[test]
    fn more_vertices_than_announced() {
        let positions: Vec<[f32; 3]> = (0..30_000).map(|i| [(i / 2) as f32, 1.0, -0.0]).collect();
        for (announced, size) in [(0, 1), (0, 30_000), (3, 700)] {
            let mut welder = Welder::new(announced).unwrap();
            let mut target = vec![0; positions.len()];
            let mut pieces = positions.chunks(size).zip(target.chunks_mut(size));
            assert!(pieces.all(|(piece, target)| welder.add(target, |v| piece[v]).unwrap()));
            assert_eq!(target, (0..30_000).map(|i| i / 2).collect::<Vec<_>>());
            assert_eq!(welder.into_positions().len(), 15_000);
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

//! Welding by a hash table.

use super::{Distinct, is_nowhere, key};
use crate::{BuildError, memory};
use alloc::vec::Vec;

/// Vertices that are looked up together: the table is asked for all of them first, so that their cache misses
/// overlap.
const BLOCK: usize = 32;

/// Steps along the table, beyond the first, that each vertex may cost on average. A good hash needs one or two.
const STEPS: usize = 16;

/// `None` where the positions were chosen so that this would take too long.
pub(super) fn weld(
    target: &mut [u32],
    position: &impl Fn(usize) -> [f32; 3],
) -> Result<Option<Distinct>, BuildError> {
    let mut table = Table::new(target.len())?;
    for (block, targets) in target.chunks_mut(BLOCK).enumerate() {
        let start = block * BLOCK;
        let mut seen = [(0, 0); BLOCK];
        for (i, seen) in seen[..targets.len()].iter_mut().enumerate() {
            let hash = hash(key(position(start + i)));
            *seen = (hash, table.first_slot(hash));
        }
        for (i, target) in targets.iter_mut().enumerate() {
            let (hash, slot) = seen[i];
            let (v, position) = (start + i, position(start + i));
            // It may have become known since.
            let known = table.vertex_at(slot, hash, position);
            let known = known.or_else(|| table.vertex_at(table.first_slot(hash), hash, position));
            *target = match known {
                Some(vertex) => vertex,
                None if is_nowhere(position) => table.distinct.push(v, position)?,
                None => match table.find_or_insert(hash, v, position)? {
                    Some(vertex) => vertex,
                    None => return Ok(None),
                },
            };
            table.remember(hash, *target);
        }
    }
    Ok(Some(table.distinct))
}

/// Open addressing. A slot is the hash of a vertex above its number plus one; 0 is empty.
struct Table {
    slots: Vec<u64>,
    /// The home of a hash is its first bits: growing keeps the order, so it reads and writes in order as well.
    bits: u32,
    /// Slots in use.
    used: usize,
    /// Slots that were met last, by the end of their hash. Neighbours in space are often neighbours in a list: five of
    /// six corners are found here then, near the processor.
    recent: Vec<u64>,
    steps_left: usize,
    distinct: Distinct,
}

const RECENT: usize = 8192;

/// A table of more slots is not made.
const MAX_BITS: u32 = 31;

impl Table {
    fn new(vertices: usize) -> Result<Self, BuildError> {
        // A closed surface has one vertex for six corners.
        let bits = (vertices / 6).max(64).next_power_of_two().ilog2().min(MAX_BITS);
        Ok(Self {
            slots: memory::filled(1 << bits, 0)?,
            bits,
            used: 0,
            recent: memory::filled(RECENT, 0)?,
            steps_left: vertices.saturating_mul(STEPS),
            distinct: Distinct::default(),
        })
    }

    #[inline(always)]
    fn home(&self, hash: u32) -> usize {
        (hash >> (32 - self.bits)) as usize
    }

    /// Where the search for a vertex of this hash begins.
    #[inline(always)]
    fn first_slot(&self, hash: u32) -> u64 {
        let recent = self.recent[hash as usize % RECENT];
        if (recent >> 32) as u32 == hash { recent } else { self.slots[self.home(hash)] }
    }

    /// The vertex of a slot, if it is at this position.
    #[inline(always)]
    fn vertex_at(&self, slot: u64, hash: u32, position: [f32; 3]) -> Option<u32> {
        let vertex = (slot as u32).wrapping_sub(1);
        ((slot >> 32) as u32 == hash && self.distinct.positions.get(vertex as usize) == Some(&position))
            .then_some(vertex)
    }

    #[inline(always)]
    fn remember(&mut self, hash: u32, vertex: u32) {
        self.recent[hash as usize % RECENT] = slot_of(hash, vertex);
    }

    /// The vertex at this position, a new one if there is none. `None` where it took too many steps.
    fn find_or_insert(&mut self, hash: u32, v: usize, position: [f32; 3]) -> Result<Option<u32>, BuildError> {
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
        let vertex = self.distinct.push(v, position)?;
        self.slots[at] = slot_of(hash, vertex);
        self.used += 1;
        Ok(Some(vertex))
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
fn hash([x, y, z]: [u32; 3]) -> u32 {
    let xy = (u64::from(x) | u64::from(y) << 32).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let xyz = (xy ^ xy >> 32 ^ u64::from(z)).wrapping_mul(0xD6E8_FEB8_6659_FD93);
    (xyz >> 32) as u32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::repair::weld;
    use crate::repair::weld::sorted;
    use alloc::vec;

    /// Both ways, and the slow search.
    fn check(positions: &[[f32; 3]], by_table: bool) {
        let position = |v: usize| positions[v];
        let mut targets = [vec![0; positions.len()], vec![0; positions.len()]];
        let table = super::weld(&mut targets[0], &position).unwrap();
        let sorted = sorted::weld(&mut targets[1], &position).unwrap();
        assert_eq!(table.is_some(), by_table);
        if by_table {
            assert_eq!((table, &targets[0]), (Some(sorted.clone()), &targets[1]));
        }
        let firsts: Vec<usize> = positions
            .iter()
            .enumerate()
            .map(|(v, p)| positions[..v].iter().position(|other| other == p).unwrap_or(v))
            .collect();
        let source: Vec<u32> = (0..firsts.len()).filter(|v| firsts[*v] == *v).map(|v| v as u32).collect();
        assert_eq!(sorted.source, source);
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
        let chosen: Vec<_> = all.filter(|p| hash(key(*p)) >> 20 == 0x5A5).take(500).collect();
        check(&chosen, false);
    }
}

//! Welding by a hash table.

use super::{MAX_VERTICES, is_nowhere, key};
use crate::{BuildError, memory};
use alloc::vec::Vec;

/// Vertices that are looked up together: the table is asked for all of them first, so that their cache misses
/// overlap.
const BLOCK: usize = 256;

/// Slots of the table that are looked at for each of them then: nearly all vertices are found there.
const NEAR: usize = 4;

/// Steps along the table, beyond the first, that each vertex may cost on average. A good hash needs one or two.
const STEPS: usize = 16;

/// Welds vertices as they come, such as those of a file that is read piece by piece: what [`weld_into`] does, for
/// positions that are not kept. The table takes as much memory.
///
/// ```
/// let mut welder = onering_core::repair::Welder::new(3)?;
/// let mut target = [9; 3];
/// for (piece, target) in [[0.0; 3], [1.0; 3], [-0.0; 3]].chunks(2).zip(target.chunks_mut(2)) {
///     assert!(welder.add(target, |v| piece[v])?);
/// }
/// assert_eq!((target, welder.into_positions().len()), ([0, 1, 0], 2));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// [`weld_into`]: super::weld_into
#[derive(Debug)]
pub struct Welder {
    table: Table,
    block: Block,
}

impl Welder {
    /// For about so many vertices.
    ///
    /// # Errors
    /// [`BuildError::OutOfMemory`].
    pub fn new(vertices: usize) -> Result<Self, BuildError> {
        Ok(Self { table: Table::new(vertices)?, block: Block::new() })
    }

    /// Welds the next vertices: `v` of `target.len()` is at `position(v)`, and `target[v]` becomes its new number.
    /// Constant time for each on average.
    ///
    /// `false` where the positions were chosen so that a hash table takes too long, or there are too many for one:
    /// only [`weld_into`](super::weld_into), which can sort them, welds them then, from the first one on.
    ///
    /// # Errors
    /// [`BuildError::OutOfMemory`], or [`BuildError::TooManyVertices`] for more than `u32::MAX` new numbers.
    pub fn add(
        &mut self,
        target: &mut [u32],
        position: impl Fn(usize) -> [f32; 3],
    ) -> Result<bool, BuildError> {
        let Self { table, block } = self;
        let vertices = table.positions.len().saturating_add(target.len());
        if vertices > MAX_VERTICES {
            return Err(BuildError::TooManyVertices { vertices, limit: MAX_VERTICES });
        }
        for (number, targets) in target.chunks_mut(BLOCK).enumerate() {
            let (start, count) = (number * BLOCK, targets.len());
            block.fill(count, |i| position(start + i));
            block.look_up(count, table);
            for (i, target) in targets.iter_mut().enumerate() {
                let (hash, position) = (block.hashes[i], block.positions[i]);
                *target = match block.known[i] {
                    UNKNOWN => match table.resolve(hash, position)? {
                        Some(vertex) => vertex,
                        None => return Ok(false),
                    },
                    vertex => vertex,
                };
                table.remember(hash, *target);
            }
        }
        Ok(true)
    }

    /// The positions of the new vertices, each to the last bit that of the first old one there.
    pub fn into_positions(self) -> Vec<[f32; 3]> {
        self.table.positions
    }
}

/// No vertex has this number: there are at most so many.
const UNKNOWN: u32 = u32::MAX;

/// Vertices on their way through the table. Each step is a short loop of its own: the processor runs ahead in it, from
/// one cache miss to the next ones.
#[derive(Debug)]
struct Block {
    positions: [[f32; 3]; BLOCK],
    hashes: [u32; BLOCK],
    slots: [u64; BLOCK],
    /// Which of them are not among the recent ones.
    distant: [u16; BLOCK],
    known: [u32; BLOCK],
}

impl Block {
    fn new() -> Self {
        Self {
            positions: [[0.0; 3]; BLOCK],
            hashes: [0; BLOCK],
            slots: [0; BLOCK],
            distant: [0; BLOCK],
            known: [UNKNOWN; BLOCK],
        }
    }

    #[inline(always)]
    fn fill(&mut self, count: usize, position: impl Fn(usize) -> [f32; 3]) {
        for (i, (place, hash)) in self.positions.iter_mut().zip(&mut self.hashes).take(count).enumerate() {
            *place = position(i);
            *hash = hash_of(key(*place));
        }
    }

    /// The vertices that are known already.
    #[inline(always)]
    fn look_up(&mut self, count: usize, table: &Table) {
        let mut distant = 0;
        for (i, (slot, hash)) in self.slots.iter_mut().zip(&self.hashes).take(count).enumerate() {
            *slot = table.recent[*hash as usize % RECENT];
            self.distant[distant % BLOCK] = i as u16;
            // A branch would be mispredicted too often.
            distant += usize::from((*slot >> 32) as u32 != *hash);
        }
        for i in &self.distant[..distant] {
            let i = usize::from(*i) % BLOCK;
            self.slots[i] = table.near_home(self.hashes[i]);
        }
        for i in 0..count {
            self.known[i] =
                table.vertex_at(self.slots[i], self.hashes[i], self.positions[i]).unwrap_or(UNKNOWN);
        }
    }
}

/// Open addressing. A slot is the hash of a vertex above its number plus one; 0 is empty.
#[derive(Debug)]
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
    /// Of the vertices so far.
    positions: Vec<[f32; 3]>,
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
            positions: Vec::new(),
        })
    }

    #[inline(always)]
    fn home(&self, hash: u32) -> usize {
        (hash >> (32 - self.bits)) as usize
    }

    /// The slot of this hash among the first few from its home on, most often of one cache line; if there is none, one
    /// of another hash.
    #[inline(always)]
    fn near_home(&self, hash: u32) -> u64 {
        let home = self.home(hash);
        let slot = |i: usize| self.slots[(home + i) & (self.slots.len() - 1)];
        let better = |found: u64, slot: u64| if (found >> 32) as u32 == hash { found } else { slot };
        (1..NEAR).map(slot).fold(slot(0), better)
    }

    /// The vertex of a slot, if it is at this position.
    #[inline(always)]
    fn vertex_at(&self, slot: u64, hash: u32, [x, y, z]: [f32; 3]) -> Option<u32> {
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
    fn resolve(&mut self, hash: u32, position: [f32; 3]) -> Result<Option<u32>, BuildError> {
        let recent = self.vertex_at(self.recent[hash as usize % RECENT], hash, position);
        if recent.is_some() {
            Ok(recent)
        } else if is_nowhere(position) {
            self.push(position).map(Some)
        } else {
            self.find_or_insert(hash, position)
        }
    }

    #[inline(always)]
    fn remember(&mut self, hash: u32, vertex: u32) {
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
fn hash_of([x, y, z]: [u32; 3]) -> u32 {
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
        let mut table = Welder::new(positions.len()).unwrap();
        let pieces = positions.chunks(701).zip(targets[0].chunks_mut(701));
        let welded =
            pieces.map(|(piece, target)| table.add(target, |v| piece[v]).unwrap()).all(|welded| welded);
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

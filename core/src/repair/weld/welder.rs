//! Welding piece by piece.

use super::table::{Table, hash_of};
use super::{MAX_VERTICES, key};
use crate::BuildError;
use alloc::vec::Vec;

/// Vertices that are looked up together: the table is asked for all of them first, so that their cache misses
/// overlap.
const BLOCK: usize = 256;

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
            *slot = table.recent(*hash);
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

//! Welding piece by piece.

use super::table::{Table, hash_of};
use super::{MAX_VERTICES, key};
use crate::{BuildError, memory};
use alloc::vec::Vec;
use core::hint::black_box;

/// Vertices that are welded together: what is looked for in the table is looked for at once, so that the cache misses
/// overlap.
const BLOCK: usize = 512;

/// Vertices that were met last. Neighbours in space are often neighbours in a list: five of six corners are found here
/// then, near the processor.
const RECENT: usize = 8192;

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
    /// Of the new vertices so far.
    positions: Vec<[f32; 3]>,
    /// Hash and vertex, by the beginning of the hash. Whoever finds a vertex here looks whether it is at the right place.
    recent: Vec<[u32; 2]>,
    supposed: Supposed,
}

impl Welder {
    /// For about so many vertices; if there are more, the table grows.
    ///
    /// # Errors
    /// [`BuildError::OutOfMemory`].
    pub fn new(vertices: usize) -> Result<Self, BuildError> {
        Ok(Self {
            table: Table::new(vertices)?,
            positions: Vec::new(),
            recent: memory::filled(RECENT, [0; 2])?,
            supposed: Supposed::default(),
        })
    }

    /// Welds the next vertices: `v` of `target.len()` is at `position(v)`, and `target[v]` becomes its new number.
    /// Constant time for each on average.
    ///
    /// `false` where the positions were chosen so that a hash table takes too long, or there are too many for one:
    /// only [`weld_into`](super::weld_into), which can sort them, welds them then, from the first one on. After that or
    /// an error nothing can be added any more, and the positions are those of no mesh.
    ///
    /// # Errors
    /// [`BuildError::OutOfMemory`], or [`BuildError::TooManyVertices`] for more than `u32::MAX` new numbers.
    pub fn add(
        &mut self,
        target: &mut [u32],
        position: impl Fn(usize) -> [f32; 3],
    ) -> Result<bool, BuildError> {
        let vertices = self.positions.len().saturating_add(target.len());
        if vertices > MAX_VERTICES {
            return Err(BuildError::TooManyVertices { vertices, limit: MAX_VERTICES });
        }
        self.table.expect(target.len());
        for (number, targets) in target.chunks_mut(BLOCK).enumerate() {
            let (start, known) = (number * BLOCK, self.positions.len());
            self.suppose(targets, |i| position(start + i))?;
            if !self.settle(known, targets)? {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// The positions of the new vertices, each to the last bit that of the first old one there.
    pub fn into_positions(self) -> Vec<[f32; 3]> {
        self.positions
    }

    /// Numbers the vertices of a block as if all that were not met lately were new.
    #[inline(always)]
    fn suppose(
        &mut self,
        targets: &mut [u32],
        position: impl Fn(usize) -> [f32; 3],
    ) -> Result<(), BuildError> {
        let known = self.positions.len();
        memory::reserve(&mut self.positions, targets.len())?;
        self.positions.resize(known + targets.len(), [0.0; 3]);
        let mut next = known;
        for (i, target) in targets.iter_mut().enumerate() {
            let position = position(i);
            let hash = hash_of(key(position));
            let recent = &mut self.recent[recent_of(hash)];
            let is_there = |vertex| (vertex as usize) < next && is_at(&self.positions, vertex, position);
            if recent[0] != hash || !is_there(recent[1]) {
                *recent = [hash, next as u32];
                self.positions[next] = position;
                self.supposed.hashes[(next - known) % BLOCK] = hash;
                next += 1;
            }
            *target = recent[1];
        }
        self.positions.truncate(next);
        Ok(())
    }

    /// Puts the supposed vertices into the table, and those that are there already right.
    #[inline(always)]
    fn settle(&mut self, known: usize, targets: &mut [u32]) -> Result<bool, BuildError> {
        let Self { table, positions, supposed, .. } = self;
        let count = positions.len() - known;
        supposed.look_up(table, &positions[..known], &positions[known..]);
        let mut next = known;
        for i in 0..count {
            let position = positions[known + i];
            let vertex = &mut supposed.vertices[i];
            if *vertex == UNKNOWN {
                match table.find_or_insert(supposed.hashes[i], position, &positions[..next])? {
                    Some(found) => *vertex = found,
                    None => return Ok(false),
                }
            }
            if *vertex as usize == next {
                positions[next] = position;
                next += 1;
            }
        }
        if next < positions.len() {
            positions.truncate(next);
            self.correct(known, count, targets);
        }
        Ok(true)
    }

    /// Replaces the supposed numbers, from `known` on, by the right ones.
    #[inline(always)]
    fn correct(&mut self, known: usize, count: usize, targets: &mut [u32]) {
        let Supposed { hashes, vertices } = &self.supposed;
        for (hash, vertex) in hashes.iter().zip(vertices).take(count) {
            self.recent[recent_of(*hash)] = [*hash, *vertex];
        }
        for target in targets {
            let supposed = (*target as usize).checked_sub(known);
            *target = supposed.map_or(*target, |supposed| vertices[supposed % BLOCK]);
        }
    }
}

/// The place of a hash among the recent vertices.
#[inline(always)]
fn recent_of(hash: u32) -> usize {
    hash as usize / (u32::MAX as usize / RECENT + 1)
}

#[inline(always)]
fn is_at(positions: &[[f32; 3]], vertex: u32, [x, y, z]: [f32; 3]) -> bool {
    // All in one: branches between would be in the way.
    positions.get(vertex as usize).is_some_and(|[a, b, c]| (*a == x) & (*b == y) & (*c == z))
}

/// No vertex has this number: there are at most so many.
const UNKNOWN: u32 = u32::MAX;

/// The vertices of a block that may be new.
#[derive(Debug)]
struct Supposed {
    hashes: [u32; BLOCK],
    /// Which they are.
    vertices: [u32; BLOCK],
}

impl Default for Supposed {
    fn default() -> Self {
        Self { hashes: [0; BLOCK], vertices: [UNKNOWN; BLOCK] }
    }
}

impl Supposed {
    /// Those that are known from before the block. Each step is a short loop of its own: the processor runs ahead in
    /// it, from one cache miss to the next ones.
    #[inline(always)]
    fn look_up(&mut self, table: &Table, known: &[[f32; 3]], positions: &[[f32; 3]]) {
        let hashes = &self.hashes[..positions.len()];
        black_box(hashes.iter().fold(0, |all, hash| all ^ table.at_home(*hash)));
        for (vertex, hash) in self.vertices.iter_mut().zip(hashes) {
            *vertex = table.near_home(*hash).unwrap_or(UNKNOWN);
        }
        for (vertex, position) in self.vertices.iter_mut().zip(positions) {
            *vertex = if is_at(known, *vertex, *position) { *vertex } else { UNKNOWN };
        }
    }
}

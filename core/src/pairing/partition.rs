//! Half-edges dealt into parts of the size of the cache by a vertex of theirs, and paired there.
//!
//! On a shuffled mesh a table over all vertices or edges waits for memory at each half-edge. Here faces are read and
//! entries written in order, and only the opposites go to places without an order.
//!
//! The lower vertex of the edge is enough to pair ([`Sides`]). Where the starts of fans are wanted as well, the vertex is
//! the origin: then all corners of a vertex are in one place, and a turn around it is made there ([`Corners`]).
//!
//! With the feature `parallel`, each thread deals a piece of the list and pairs some of the parts. An entry comes to the
//! same place whoever deals it, so that nothing depends on the threads.
use super::deal::{Dealt, Entry, Part, Plan};
use super::{
    Paired, Pairing, Starts,
    corners::Corners,
    joiner::{Extra, Joiner},
    sides::Sides,
};
use crate::{
    BuildError, HalfEdgeId, Slot,
    memory::{self, Spare},
    workers,
};
use alloc::vec::Vec;
use core::{
    ops::Range,
    sync::atomic::{AtomicU32, Ordering::Relaxed},
};

/// Half-edges that are worth a thread.
const PIECE: usize = 1 << 16;

/// Buckets of so many are searched, others sorted.
pub(super) const FEW: usize = 32;

/// No opposite, and no start, as a [`Slot`] holds it.
pub(super) const NONE: u32 = u32::MAX;

/// Half-edges of a part, sorted by their vertex.
pub(super) trait Sorted: Sized {
    /// What is dealt of each.
    type Entry: Entry;

    /// Room for so many.
    fn new(count: usize) -> Result<Self, BuildError>;

    fn put(&mut self, place: usize, entry: Self::Entry);

    /// Pairs the half-edges that were dealt to `vertex`, which are in the order of the list: sets the opposite of each or
    /// `NONE`, and puts those of irregular edges into `extra`. Gives the start of the fan, or `NONE` where there is no face,
    /// if that is known, no edge is irregular and there is one fan at most.
    fn pair(
        &mut self,
        vertex: u32,
        bucket: Range<usize>,
        set: &mut impl FnMut(u32, u32),
        extra: &mut Extra,
    ) -> Result<Option<u32>, BuildError>;
}

pub(super) fn pair(
    vertex_count: usize,
    faces: &[[u32; 3]],
    table: Vec<Slot<HalfEdgeId>>,
    wants_starts: bool,
    spare: &mut Spare,
) -> Result<(Paired, Starts), BuildError> {
    let Some(plan) = Plan::new(vertex_count, 3 * faces.len()) else {
        let mut joiner = Joiner::new(faces, table);
        pair_again(vertex_count, faces, None, &mut joiner)?;
        return Ok((joiner.finish(Pairing::Partition)?, None));
    };
    if !wants_starts {
        let (paired, _) = pair_parts::<Sides>(plan, faces, table, &mut [])?;
        return Ok((paired, None));
    }
    let mut starts = spare.table(vertex_count)?;
    let (paired, has_starts) =
        pair_parts::<Corners>(plan, faces, table, bytemuck::cast_slice_mut(&mut starts))?;
    if has_starts {
        return Ok((paired, Some(starts)));
    }
    spare.keep(starts);
    Ok((paired, None))
}

/// Gives whether all starts are known as well; they are put into `starts`, which has a place for each vertex, or none.
fn pair_parts<S: Sorted>(
    plan: Plan,
    faces: &[[u32; 3]],
    table: Vec<Slot<HalfEdgeId>>,
    starts: &mut [u32],
) -> Result<(Paired, bool), BuildError> {
    let pieces = workers::pieces(3 * faces.len(), PIECE);
    let mut dealt = Dealt::<S::Entry>::new(plan, faces, pieces)?;
    // Both ways the vector keeps its memory: std does not promise that, so a test looks. No two threads write to one place.
    let opposite: Vec<u32> = bytemuck::cast_vec(table);
    let opposite: Vec<AtomicU32> = opposite.into_iter().map(AtomicU32::new).collect();
    let set = |h: u32, o: u32| opposite[h as usize].store(o, Relaxed);
    let (mut found, mut rest) = (Vec::new(), starts);
    for parts in dealt.rounds() {
        dealt.deal(parts)?;
        let with_starts = |parts: Range<usize>| {
            let count = (parts.len() * plan.vertices_of_part()).min(rest.len());
            (parts, rest.split_off_mut(..count).unwrap_or_default())
        };
        let shares = dealt.shares(pieces).into_iter().map(with_starts).collect();
        found.extend(workers::map(shares, |(parts, starts)| {
            Buckets::<S>::new(&dealt)?.pair_all(parts, starts, set)
        }));
    }
    drop(dealt); // the records may need the memory
    let opposite: Vec<u32> = opposite.into_iter().map(AtomicU32::into_inner).collect();
    let mut joiner = Joiner::with(faces, bytemuck::cast_vec(opposite));
    let mut has_starts = true;
    for found in found {
        let (extra, is_known) = found?;
        joiner.add(extra)?;
        has_starts &= is_known;
    }
    Ok((joiner.finish(Pairing::Partition)?, has_starts))
}

/// Pairs all edges of some lower vertices once more, or of all. O(n log n) in all of them together.
pub(super) fn pair_again(
    vertex_count: usize,
    faces: &[[u32; 3]],
    lows: Option<&[u32]>,
    joiner: &mut Joiner<'_>,
) -> Result<(), BuildError> {
    let mut is_again = memory::filled(lows.map_or(0, |_| vertex_count), false)?;
    lows.into_iter().flatten().for_each(|&low| is_again[low as usize] = true);
    // Lower end, higher end, half-edge.
    let mut entries: Vec<[u32; 3]> = Vec::new();
    for (f, &[a, b, c]) in faces.iter().enumerate() {
        for (k, (a, b)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
            if lows.is_none() || is_again[a.min(b) as usize] {
                memory::push(&mut entries, [a.min(b), a.max(b), (3 * f + k) as u32])?;
            }
        }
    }
    drop(is_again);
    entries.iter().for_each(|&[_, _, h]| joiner.part(h as usize));
    entries.sort_unstable();
    for edge in entries.chunk_by(|x, y| x[..2] == y[..2]) {
        for &[_, _, h] in &edge[1..] {
            joiner.join(edge[0][2] as usize, h as usize)?;
        }
    }
    Ok(())
}

/// The half-edges of one part after the other, in buckets by their vertex.
struct Buckets<'a, S: Sorted> {
    dealt: &'a Dealt<'a, S::Entry>,
    /// The end of each bucket.
    ends: Vec<u32>,
    sorted: S,
}

impl<'a, S: Sorted> Buckets<'a, S> {
    fn new(dealt: &'a Dealt<'a, S::Entry>) -> Result<Self, BuildError> {
        let ends = memory::filled(dealt.plan.vertices_of_part(), 0)?;
        Ok(Self { dealt, ends, sorted: S::new(dealt.longest())? })
    }

    /// Gives what does not pair, and whether all starts are known. They are put into `starts`, which has places for the
    /// vertices of these parts, or none.
    fn pair_all(
        mut self,
        parts: Range<usize>,
        starts: &mut [u32],
        mut set: impl FnMut(u32, u32),
    ) -> Result<(Extra, bool), BuildError> {
        let (mut extra, mut is_known) = (Extra::new(), true);
        let size = self.ends.len();
        let mut starts = starts.chunks_mut(size);
        for part in parts {
            self.fill(self.dealt.part(part));
            let starts = starts.next().unwrap_or_default();
            let mut begin = 0;
            for (i, &end) in self.ends.iter().enumerate() {
                let bucket = begin..end as usize;
                let start = self.sorted.pair((part * size + i) as u32, bucket, &mut set, &mut extra)?;
                is_known &= start.is_some();
                if let Some(place) = starts.get_mut(i) {
                    *place = start.unwrap_or(NONE);
                }
                begin = end as usize;
            }
        }
        Ok((extra, is_known))
    }

    /// Sorts the half-edges of a part by their vertex; those of one stay in order.
    fn fill(&mut self, part: Part<'_, S::Entry>) {
        let last = self.ends.len() - 1; // a power of two less one
        self.ends.fill(0);
        for &low in part.lows {
            self.ends[low as usize & last] += 1;
        }
        let mut sum = 0;
        for end in &mut self.ends {
            (*end, sum) = (sum, sum + *end);
        }
        for (&entry, &low) in part.entries.iter().zip(part.lows) {
            let end = &mut self.ends[low as usize & last];
            self.sorted.put(*end as usize, entry);
            *end += 1;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Were it copied, the table would be there twice, and no error where memory ends.
    #[test]
    fn a_table_becomes_atomic_and_plain_again_in_its_place() {
        let mut plain: Vec<u32> = Vec::with_capacity(2000);
        plain.extend(0..1000);
        let place = (plain.as_ptr().addr(), plain.capacity());
        let atomic: Vec<AtomicU32> = plain.into_iter().map(AtomicU32::new).collect();
        assert_eq!((atomic.as_ptr().addr(), atomic.capacity()), place);
        let plain: Vec<u32> = atomic.into_iter().map(AtomicU32::into_inner).collect();
        assert_eq!((plain.as_ptr().addr(), plain.capacity()), place);
        assert!(plain.into_iter().eq(0..1000));
    }
}

//! Half-edges dealt into parts of the size of the cache by the lower vertex of their edge, and paired there.
//!
//! On a shuffled mesh a table over all vertices or edges waits for memory at each half-edge. Here faces are read and
//! entries written in order, and only the opposites go to places without an order: two for each edge.
//!
//! With the feature `parallel`, each thread deals a piece of the list and pairs some of the parts. An entry comes to the
//! same place whoever deals it, so that nothing depends on the threads.
use super::deal::{Dealt, Part, Plan};
use super::{
    Paired, Pairing,
    joiner::{Extra, Joiner},
};
use crate::{BuildError, HalfEdgeId, Handle, Slot, memory, workers};
use alloc::vec::Vec;
use core::sync::atomic::{AtomicU32, Ordering::Relaxed};

/// Half-edges that are worth a thread.
const PIECE: usize = 1 << 16;

/// Buckets of so many are searched, others sorted.
const FEW: usize = 32;

/// A half-edge: its origin, its target, its number.
type Entry = [u32; 3];

pub(super) fn pair(
    vertex_count: usize,
    faces: &[[u32; 3]],
    table: Vec<Slot<HalfEdgeId>>,
) -> Result<Paired, BuildError> {
    let pieces = workers::pieces(3 * faces.len(), PIECE);
    let Some(plan) = Plan::new(vertex_count, 3 * faces.len()) else {
        let mut joiner = Joiner::new(faces, table);
        pair_again(vertex_count, faces, None, &mut joiner)?;
        return joiner.finish(Pairing::Partition);
    };
    let dealt = Dealt::new(plan, faces, pieces)?;
    let joiner = if pieces == 1 {
        let mut joiner = Joiner::new(faces, table);
        let (opposite, extra) = joiner.tables();
        let pair = |g: u32, h: u32| {
            opposite[g as usize] = Slot::some(HalfEdgeId::new(h as usize));
            opposite[h as usize] = Slot::some(HalfEdgeId::new(g as usize));
        };
        *extra = Buckets::new(&dealt)?.pair_all(dealt.parts(), pair)?;
        joiner
    } else {
        shared(faces, &dealt, table, pieces)?
    };
    drop(dealt); // the records may need the memory
    joiner.finish(Pairing::Partition)
}

/// By several threads, none of which writes where another does.
fn shared<'a>(
    faces: &'a [[u32; 3]],
    dealt: &Dealt,
    table: Vec<Slot<HalfEdgeId>>,
    pieces: usize,
) -> Result<Joiner<'a>, BuildError> {
    const NONE: u32 = u32::MAX;
    // Both ways the vector keeps its memory.
    let opposite: Vec<AtomicU32> = table.into_iter().map(|_| AtomicU32::new(NONE)).collect();
    let found = workers::map(dealt.shares(pieces), |parts| {
        let pair = |g: u32, h: u32| {
            opposite[g as usize].store(h, Relaxed);
            opposite[h as usize].store(g, Relaxed);
        };
        Buckets::new(dealt)?.pair_all(parts, pair)
    });
    let opposite: Vec<u32> = opposite.into_iter().map(AtomicU32::into_inner).collect();
    let mut joiner = Joiner::with(faces, bytemuck::cast_vec(opposite));
    for extra in found {
        for (root, h) in extra? {
            joiner.add(root.index(), h.index())?;
        }
    }
    Ok(joiner)
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
    let mut entries: Vec<Entry> = Vec::new();
    for (f, &[a, b, c]) in faces.iter().enumerate() {
        for (k, (a, b)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
            if lows.is_none() || is_again[a.min(b) as usize] {
                memory::push(&mut entries, [a, b, (3 * f + k) as u32])?;
            }
        }
    }
    drop(is_again);
    entries.iter().for_each(|&[_, _, h]| joiner.part(h as usize));
    let edge = |&[a, b, _]: &Entry| (a.min(b), a.max(b));
    entries.sort_unstable_by_key(|entry| (edge(entry), entry[2]));
    let (opposite, extra) = joiner.tables();
    let mut pair = |g: u32, h: u32| {
        opposite[g as usize] = Slot::some(HalfEdgeId::new(h as usize));
        opposite[h as usize] = Slot::some(HalfEdgeId::new(g as usize));
    };
    for entries in entries.chunk_by(|x, y| edge(x) == edge(y)) {
        join(entries.iter().map(|&[a, b, h]| (h, a < b)), &mut pair, extra)?;
    }
    Ok(())
}

/// The edges of one part after the other, in buckets by their lower vertex.
struct Buckets {
    /// The end of each bucket.
    ends: Vec<u32>,
    /// Words of entries.
    sorted: Vec<u64>,
}

impl Buckets {
    fn new(dealt: &Dealt) -> Result<Self, BuildError> {
        let sorted = memory::filled(dealt.longest(), 0)?;
        Ok(Self { ends: memory::filled(dealt.plan.vertices_of_part(), 0)?, sorted })
    }

    fn pair_all<'a>(
        mut self,
        parts: impl Iterator<Item = Part<'a>>,
        mut pair: impl FnMut(u32, u32),
    ) -> Result<Extra, BuildError> {
        let mut extra = Extra::new();
        for part in parts {
            self.fill(part);
            let mut start = 0;
            for &end in &self.ends {
                pair_bucket(&mut self.sorted[start as usize..end as usize], &mut pair, &mut extra)?;
                start = end;
            }
        }
        Ok(extra)
    }

    /// Sorts the entries of a part by their lower vertex; those of one stay in order.
    fn fill(&mut self, part: Part<'_>) {
        let last = self.ends.len() - 1; // a power of two less one
        self.ends.fill(0);
        for &low in part.lows {
            self.ends[low as usize & last] += 1;
        }
        let mut sum = 0;
        for end in &mut self.ends {
            (*end, sum) = (sum, sum + *end);
        }
        for (&word, &low) in part.words.iter().zip(part.lows) {
            let end = &mut self.ends[low as usize & last];
            self.sorted[*end as usize] = word;
            *end += 1;
        }
    }
}

/// Where the higher vertex stands in a word; below it are the direction and the half-edge.
const HIGH: u32 = 33;

/// A half-edge of an entry, and whether it goes up.
fn half_edge(word: u64) -> (u32, bool) {
    (word as u32, word >> 32 & 1 != 0)
}

/// Pairs the half-edges of one lower vertex. They are in the order of the list.
#[inline(always)]
fn pair_bucket(
    bucket: &mut [u64],
    pair: &mut impl FnMut(u32, u32),
    extra: &mut Extra,
) -> Result<(), BuildError> {
    if bucket.len() > FEW {
        return pair_by_sort(bucket, pair, extra);
    }
    let mut is_paired = 0_u32;
    for i in 0..bucket.len() {
        if is_paired >> i & 1 != 0 {
            continue;
        }
        // Without a branch in the loop.
        let (mut found, mut count) = (i, 0);
        for j in i + 1..bucket.len() {
            let is_same = (bucket[i] ^ bucket[j]) >> HIGH == 0;
            found = if is_same { j } else { found };
            count += usize::from(is_same);
        }
        let ((g, g_up), (h, h_up)) = (half_edge(bucket[i]), half_edge(bucket[found]));
        if count == 1 && g_up != h_up {
            is_paired |= 1 << found;
            pair(g, h);
        } else if count > 0 {
            // What was paired already is paired alike.
            return pair_by_sort(bucket, pair, extra);
        }
    }
    Ok(())
}

/// Many edges of one lower vertex, or irregular ones.
#[inline(never)]
fn pair_by_sort(
    bucket: &mut [u64],
    pair: &mut impl FnMut(u32, u32),
    extra: &mut Extra,
) -> Result<(), BuildError> {
    // By the higher vertex, then by the half-edge: all but the direction, in one comparison.
    bucket.sort_unstable_by_key(|&word| word & !(1 << (HIGH - 1)));
    for edge in bucket.chunk_by(|x, y| x >> HIGH == y >> HIGH) {
        join(edge.iter().map(|&word| half_edge(word)), pair, extra)?;
    }
    Ok(())
}

/// The half-edges of one edge, ascending, each with its direction.
#[inline]
fn join(
    mut half_edges: impl Iterator<Item = (u32, bool)>,
    pair: &mut impl FnMut(u32, u32),
    extra: &mut Extra,
) -> Result<(), BuildError> {
    let Some((root, is_up)) = half_edges.next() else { return Ok(()) };
    let mut is_paired = false;
    for (h, goes_up) in half_edges {
        if is_up != goes_up && !is_paired {
            is_paired = true;
            pair(root, h);
        } else {
            memory::push(extra, (HalfEdgeId::new(root as usize), HalfEdgeId::new(h as usize)))?;
        }
    }
    Ok(())
}

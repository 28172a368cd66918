//! Half-edges dealt into parts of the size of the cache by the lower vertex of their edge, and paired there.
//!
//! On a shuffled mesh a table over all vertices or edges waits for memory at each half-edge. Here faces are read and
//! entries written in order, and only the opposites go to places without an order: two for each edge.
use super::{Paired, joiner::Joiner};
use crate::{BuildError, memory};
use alloc::vec::Vec;

/// Half-edges of a part, about, as a power of two: with their buckets they take some 500 kB.
const PART_BITS: u32 = 14;

/// Entries that are kept together until they fill three lines of the cache, so that memory is written by lines.
const RUN: usize = 16;

/// A half-edge: its origin, its target, its number.
type Entry = [u32; 3];

pub(super) fn pair(vertex_count: usize, faces: &[[u32; 3]]) -> Result<Paired, BuildError> {
    let (mut entries, ends) = deal(vertex_count, faces)?;
    let mut joiner = Joiner::new(faces)?;
    let mut buckets = Buckets::new(shift(vertex_count, 3 * faces.len()), longest(&ends))?;
    let mut start = 0;
    for end in ends {
        buckets.pair(&mut entries[start..end], &mut joiner)?;
        start = end;
    }
    drop((entries, buckets)); // the records may need the memory
    joiner.finish()
}

/// Pairs all edges of some lower vertices once more.
pub(super) fn pair_again(
    vertex_count: usize,
    faces: &[[u32; 3]],
    lows: &[u32],
    joiner: &mut Joiner<'_>,
) -> Result<(), BuildError> {
    let mut is_again = memory::filled(vertex_count, false)?;
    lows.iter().for_each(|&low| is_again[low as usize] = true);
    let mut entries: Vec<Entry> = Vec::new();
    for (f, &[a, b, c]) in faces.iter().enumerate() {
        for (k, (a, b)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
            if is_again[a.min(b) as usize] {
                memory::push(&mut entries, [a, b, (3 * f + k) as u32])?;
            }
        }
    }
    drop(is_again);
    entries.iter().for_each(|&[_, _, h]| joiner.part(h as usize));
    pair_by_sort(&mut entries, joiner)
}

/// How far a vertex is shifted to give its part. Vertices have some six half-edges, half of which go to a higher one
/// and half come from there; where there are far more vertices than that, their parts are as many as for their half-edges.
fn shift(vertex_count: usize, half_edge_count: usize) -> u32 {
    let part_count = (half_edge_count >> PART_BITS).max(1);
    usize::BITS - (vertex_count / part_count).leading_zeros()
}

/// Puts the entries of each part together, in the order of the list. Gives the end of each part.
fn deal(vertex_count: usize, faces: &[[u32; 3]]) -> Result<(Vec<Entry>, Vec<usize>), BuildError> {
    let shift = shift(vertex_count, 3 * faces.len());
    let part_of = |a: u32, b: u32| (u64::from(a.min(b)) >> shift) as usize;
    let part_count = (vertex_count as u64 >> shift) as usize + 1;
    let mut ends = memory::filled(part_count, 0)?;
    for &[a, b, c] in faces {
        for (a, b) in [(a, b), (b, c), (c, a)] {
            ends[part_of(a, b)] += 1;
        }
    }
    let mut sum = 0;
    for end in &mut ends {
        (*end, sum) = (sum, sum + *end);
    }
    let mut entries = memory::filled(3 * faces.len(), [0; 3])?;
    let mut runs = memory::filled(part_count, [[0; 3]; RUN])?;
    for (f, &[a, b, c]) in faces.iter().enumerate() {
        for (k, (a, b)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
            let part = part_of(a, b);
            let (end, run) = (&mut ends[part], &mut runs[part]);
            run[*end % RUN] = [a, b, (3 * f + k) as u32];
            *end += 1;
            if *end % RUN == 0 {
                // What this overwrites before the start of its part is the end of parts before, which come last.
                entries[*end - RUN..*end].copy_from_slice(run);
            }
        }
    }
    let mut start = 0;
    for (&end, run) in ends.iter().zip(&runs) {
        let from = (end - end % RUN).max(start);
        entries[from..end].copy_from_slice(&run[from % RUN..][..end - from]);
        start = end;
    }
    Ok((entries, ends))
}

fn longest(ends: &[usize]) -> usize {
    let starts = core::iter::once(&0).chain(ends);
    ends.iter().zip(starts).map(|(end, start)| end - start).max().unwrap_or(0)
}

/// The edges of one part after the other, in buckets by their lower vertex.
struct Buckets {
    shift: u32,
    /// The end of each bucket; none where vertices are far more than half-edges.
    ends: Vec<u32>,
    /// The higher vertex, the half-edge, its origin.
    sorted: Vec<Entry>,
}

impl Buckets {
    fn new(shift: u32, longest: usize) -> Result<Self, BuildError> {
        let bucket_count = 1_u64 << shift;
        let is_sparse = bucket_count > 4 * longest as u64;
        Ok(Self {
            shift,
            ends: memory::filled(if is_sparse { 0 } else { bucket_count as usize }, 0)?,
            sorted: memory::filled(if is_sparse { 0 } else { longest }, [0; 3])?,
        })
    }

    fn pair(&mut self, entries: &mut [Entry], joiner: &mut Joiner<'_>) -> Result<(), BuildError> {
        if self.ends.is_empty() {
            return pair_by_sort(entries, joiner);
        }
        let bucket_of = |a: u32, b: u32| a.min(b) as usize & ((1 << self.shift) - 1);
        self.ends.fill(0);
        for &[a, b, _] in &*entries {
            self.ends[bucket_of(a, b)] += 1;
        }
        let mut sum = 0;
        for end in &mut self.ends {
            (*end, sum) = (sum, sum + *end);
        }
        for &[a, b, h] in &*entries {
            let end = &mut self.ends[bucket_of(a, b)];
            self.sorted[*end as usize] = [a.max(b), h, a];
            *end += 1;
        }
        let mut start = 0;
        for &end in &self.ends {
            let bucket = &mut self.sorted[start as usize..end as usize];
            bucket.sort_unstable();
            for edge in bucket.chunk_by(|x, y| x[0] == y[0]) {
                join(edge.iter().map(|&[_, h, a]| (h, a)), joiner)?;
            }
            start = end;
        }
        Ok(())
    }
}

/// Without a table over the vertices. O(n log n) as well, but in all n and not in a bucket.
fn pair_by_sort(entries: &mut [Entry], joiner: &mut Joiner<'_>) -> Result<(), BuildError> {
    let edge = |&[a, b, _]: &Entry| (a.min(b), a.max(b));
    entries.sort_unstable_by_key(|entry| (edge(entry), entry[2]));
    for entries in entries.chunk_by(|x, y| edge(x) == edge(y)) {
        join(entries.iter().map(|&[a, _, h]| (h, a)), joiner)?;
    }
    Ok(())
}

/// The half-edges of one edge, ascending, each with its origin.
#[inline]
fn join(mut half_edges: impl Iterator<Item = (u32, u32)>, joiner: &mut Joiner<'_>) -> Result<(), BuildError> {
    let Some((root, a)) = half_edges.next() else { return Ok(()) };
    let mut is_paired = false;
    for (h, b) in half_edges {
        if a != b && !is_paired {
            is_paired = true;
            joiner.pair(root as usize, h as usize);
        } else {
            joiner.add(root as usize, h as usize)?;
        }
    }
    Ok(())
}

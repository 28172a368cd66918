//! Half-edges dealt into parts of the size of the cache by the lower vertex of their edge, and paired there.
//!
//! On a shuffled mesh a table over all vertices or edges waits for memory at each half-edge. Here faces are read and
//! entries written in order, and only the opposites go to places without an order: two for each edge.
use super::{Paired, joiner::Joiner};
use crate::{BuildError, memory};
use alloc::vec::Vec;

/// Half-edges of a part, about, as a power of two: entries, lists and heads then take some 300 kB.
const PART_BITS: u32 = 14;

/// Entries that are kept together until they fill three lines of the cache, so that memory is written by lines.
const RUN: usize = 16;

const END: u32 = u32::MAX >> 1;
const PAIRED: u32 = 1 << 31;

/// Steps along lists, for each half-edge of a part, before the part is sorted instead.
const PATIENCE: usize = 8;

/// A half-edge: its origin, its target, its number.
type Entry = [u32; 3];

pub(super) fn pair(vertex_count: usize, faces: &[[u32; 3]]) -> Result<Paired, BuildError> {
    let (mut entries, ends) = deal(vertex_count, faces)?;
    let mut joiner = Joiner::new(faces)?;
    let mut lists = Lists::new(longest(&ends))?;
    let mut start = 0;
    for end in ends {
        lists.pair(&mut entries[start..end], &mut joiner)?;
        start = end;
    }
    drop((entries, lists)); // the records may need the memory
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
    Lists::new(entries.len())?.pair(&mut entries, joiner)
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

/// The edges of one part after the other, in lists by a hash of both ends.
struct Lists {
    /// The first root of each hash.
    head: Vec<u32>,
    /// The next root with this hash, and at the top whether this one is paired.
    link: Vec<u32>,
}

impl Lists {
    fn new(longest: usize) -> Result<Self, BuildError> {
        Ok(Self {
            head: memory::with_room(head_count(longest))?,
            link: memory::filled(longest.min(END as usize), END)?,
        })
    }

    fn pair(&mut self, entries: &mut [Entry], joiner: &mut Joiner<'_>) -> Result<(), BuildError> {
        if !self.pair_by_hash(entries, joiner)? {
            pair_by_sort(entries, joiner)?;
        }
        Ok(())
    }

    /// Gives up where lists are long, as a fixed hash does not withstand chosen vertices, or where links cannot name
    /// so many entries.
    fn pair_by_hash(&mut self, entries: &[Entry], joiner: &mut Joiner<'_>) -> Result<bool, BuildError> {
        if entries.len() > END as usize {
            return Ok(false);
        }
        let heads = head_count(entries.len());
        let hash_shift = u64::BITS - heads.ilog2();
        self.head.clear();
        self.head.resize(heads, END);
        let extra = joiner.extra_count();
        let mut patience = PATIENCE * entries.len();
        for (i, &[a, b, h]) in entries.iter().enumerate() {
            let key = u64::from(a.min(b)) << 32 | u64::from(a.max(b));
            let hash = (key.wrapping_mul(0x9E37_79B9_7F4A_7C15) >> hash_shift) as usize;
            let mut at = self.head[hash];
            loop {
                if at == END {
                    self.link[i] = self.head[hash];
                    self.head[hash] = i as u32;
                    break;
                }
                let [c, d, root] = entries[at as usize];
                let link = self.link[at as usize];
                if (c, d) == (b, a) && link & PAIRED == 0 {
                    self.link[at as usize] = link | PAIRED;
                    joiner.pair(root as usize, h as usize);
                    break;
                }
                if (c, d) == (b, a) || (c, d) == (a, b) {
                    joiner.add(root as usize, h as usize)?;
                    break;
                }
                at = link & !PAIRED;
                patience = patience.saturating_sub(1);
            }
            if patience == 0 {
                joiner.forget_extra_beyond(extra);
                return Ok(false);
            }
        }
        Ok(true)
    }
}

fn head_count(entries: usize) -> usize {
    (entries / 2).next_power_of_two().max(2)
}

/// O(n log n), whatever the vertices. Pairs that were joined before are joined again.
fn pair_by_sort(entries: &mut [Entry], joiner: &mut Joiner<'_>) -> Result<(), BuildError> {
    let edge = |&[a, b, _]: &Entry| (a.min(b), a.max(b));
    entries.sort_unstable_by_key(|entry| (edge(entry), entry[2]));
    for entries in entries.chunk_by(|x, y| edge(x) == edge(y)) {
        let [a, _, root] = entries[0];
        let mut is_paired = false;
        for &[c, _, h] in &entries[1..] {
            if c != a && !is_paired {
                is_paired = true;
                joiner.pair(root as usize, h as usize);
            } else {
                joiner.add(root as usize, h as usize)?;
            }
        }
    }
    Ok(())
}

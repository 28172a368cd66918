//! Edges dealt into parts by their lower vertex, each part small enough for the cache, and paired there by lists.
//!
//! On a shuffled mesh every other strategy waits for memory at each half-edge. Here faces are read and entries written in
//! order, and only the opposites go to places without an order: two for each edge.
use super::{Paired, counting_sort, joiner::Joiner};
use crate::{BuildError, memory};
use alloc::vec::Vec;

/// Vertices of a part, as a power of two: with six edges each, lists and entries take some 300 kB.
const PART_BITS: u32 = 12;

/// Entries that are kept together until they fill a line of the cache, so that memory is written by lines.
const LINE: usize = 8;

const END: u32 = u32::MAX;

/// Steps along lists, for each entry of a part, before it is sorted instead: some vertex has a huge degree.
const PATIENCE: usize = 16;

pub(super) fn pair(vertex_count: usize, faces: &[[u32; 3]]) -> Result<Paired, BuildError> {
    let Some(packing) = Packing::of(vertex_count, faces.len()) else {
        return counting_sort::pair(vertex_count, faces);
    };
    let (mut entries, ends) = deal(vertex_count, faces, packing)?;
    let mut joiner = Joiner::new(faces)?;
    let mut part = Part::new(packing, longest(&ends))?;
    let mut start = 0;
    for end in ends {
        part.pair(&mut entries[start..end], &mut joiner)?;
        start = end;
    }
    drop((entries, part)); // the records may need the memory
    joiner.finish()
}

/// Puts the entries of each part together, in the order of the list. Gives the end of each part.
fn deal(
    vertex_count: usize,
    faces: &[[u32; 3]],
    packing: Packing,
) -> Result<(Vec<u64>, Vec<usize>), BuildError> {
    let part_count = (vertex_count >> packing.part_bits) + 1;
    let mut ends = memory::filled(part_count, 0)?;
    for &[a, b, c] in faces {
        for (a, b) in [(a, b), (b, c), (c, a)] {
            ends[(a.min(b) >> packing.part_bits) as usize] += 1;
        }
    }
    let mut sum = 0;
    for end in &mut ends {
        (*end, sum) = (sum, sum + *end);
    }
    let mut entries = memory::filled(3 * faces.len(), 0)?;
    let mut lines = memory::filled(part_count, [0; LINE])?;
    for (f, &[a, b, c]) in faces.iter().enumerate() {
        for (k, (a, b)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
            let part = (a.min(b) >> packing.part_bits) as usize;
            let (end, line) = (&mut ends[part], &mut lines[part]);
            line[*end % LINE] = packing.pack(a, b, 3 * f + k);
            *end += 1;
            if *end % LINE == 0 {
                // What this overwrites before the start of its part is the end of parts before, which come last.
                entries[*end - LINE..*end].copy_from_slice(line);
            }
        }
    }
    let mut start = 0;
    for (&end, line) in ends.iter().zip(&lines) {
        let from = (end - end % LINE).max(start);
        entries[from..end].copy_from_slice(&line[from % LINE..][..end - from]);
        start = end;
    }
    Ok((entries, ends))
}

fn longest(ends: &[usize]) -> usize {
    let starts = core::iter::once(&0).chain(ends);
    ends.iter().zip(starts).map(|(end, start)| end - start).max().unwrap_or(0)
}

/// How an entry is made of 64 bits: from the top the lower vertex within its part, whether the half-edge starts there, the
/// higher vertex, the half-edge.
#[derive(Clone, Copy)]
struct Packing {
    part_bits: u32,
    vertex_bits: u32,
    half_edge_bits: u32,
}

impl Packing {
    /// `None` where they are too many for 64 bits.
    fn of(vertex_count: usize, face_count: usize) -> Option<Self> {
        let bits = |count: usize| usize::BITS - count.leading_zeros();
        let (vertex_bits, half_edge_bits) = (bits(vertex_count), bits(3 * face_count));
        let room = 63_u32.checked_sub(vertex_bits + half_edge_bits)?;
        (room >= 8).then_some(Self { part_bits: room.min(PART_BITS), vertex_bits, half_edge_bits })
    }

    #[inline(always)]
    fn pack(self, a: u32, b: u32, h: usize) -> u64 {
        let (low, high) = (a.min(b), a.max(b));
        let local = low & ((1 << self.part_bits) - 1);
        let vertex = u64::from(local) << 1 | u64::from(a < b);
        (vertex << self.vertex_bits | u64::from(high)) << self.half_edge_bits | h as u64
    }

    #[inline(always)]
    fn half_edge(self, entry: u64) -> usize {
        (entry & ((1 << self.half_edge_bits) - 1)) as usize
    }

    #[inline(always)]
    fn high(self, entry: u64) -> u64 {
        entry >> self.half_edge_bits & ((1 << self.vertex_bits) - 1)
    }

    #[inline(always)]
    fn local(self, entry: u64) -> usize {
        (entry >> (self.half_edge_bits + self.vertex_bits + 1)) as usize
    }

    #[inline(always)]
    fn is_up(self, entry: u64) -> bool {
        entry >> (self.half_edge_bits + self.vertex_bits) & 1 == 1
    }
}

/// The lists of one part after the other.
struct Part {
    packing: Packing,
    /// The first root of each lower vertex.
    head: Vec<u32>,
    /// The next root in its list, and whether this one is paired.
    link: Vec<(u32, bool)>,
}

impl Part {
    fn new(packing: Packing, longest: usize) -> Result<Self, BuildError> {
        Ok(Self {
            packing,
            head: memory::filled(1 << packing.part_bits, END)?,
            link: memory::filled(longest, (END, false))?,
        })
    }

    fn pair(&mut self, entries: &mut [u64], joiner: &mut Joiner<'_>) -> Result<(), BuildError> {
        let packing = self.packing;
        self.head.fill(END);
        let mut patience = PATIENCE * entries.len();
        for i in 0..entries.len() {
            let entry = entries[i];
            let head = &mut self.head[packing.local(entry)];
            let mut at = *head;
            loop {
                if at == END {
                    self.link[i] = (*head, false);
                    *head = i as u32;
                    break;
                }
                let root = entries[at as usize];
                let (next, is_paired) = self.link[at as usize];
                if packing.high(root) == packing.high(entry) {
                    let (r, h) = (packing.half_edge(root), packing.half_edge(entry));
                    if !is_paired && packing.is_up(root) != packing.is_up(entry) {
                        self.link[at as usize].1 = true;
                        joiner.pair(r, h);
                    } else {
                        joiner.add(r, h)?;
                    }
                    break;
                }
                at = next;
                patience = patience.saturating_sub(1);
            }
        }
        let _ = patience;
        Ok(())
    }
}

//! Deals half-edges into parts, some parts at a time.
use crate::{BuildError, memory, workers};
use alloc::vec::Vec;
use core::ops::Range;

/// Half-edges of a part, about, as a power of two: with their buckets they take some 500 kB.
const PART_BITS: u32 = 14;

/// Entries that are kept together until they fill lines of the cache, so that memory is written by lines.
const RUN: usize = 8;

/// More bytes than this are dealt in two rounds, which use the same memory, as fresh memory takes longer than to read all
/// faces twice.
const ROUND: usize = 100 << 20;

/// What is dealt of a half-edge, to the part of one of its vertices.
pub(super) trait Entry: Copy + bytemuck::Zeroable + Send + Sync {
    /// Of half-edge `h` from `a` to `b` in a face whose third vertex is `c`: the vertex and the entry.
    fn new(h: u32, a: u32, b: u32, c: u32) -> (u32, Self);
}

/// Calls `each` for the entries of all half-edges of the faces from number `first` on.
#[inline(always)]
fn for_each<E: Entry>(first: usize, faces: &[[u32; 3]], mut each: impl FnMut(u32, E)) {
    for (f, &[a, b, c]) in faces.iter().enumerate() {
        for (k, (a, b, c)) in [(a, b, c), (b, c, a), (c, a, b)].into_iter().enumerate() {
            let (vertex, entry) = E::new((3 * (first + f) + k) as u32, a, b, c);
            each(vertex, entry);
        }
    }
}

/// Which part a vertex belongs to.
#[derive(Clone, Copy)]
pub(super) struct Plan {
    /// How far a vertex is shifted to give its part.
    shift: u32,
    part_count: usize,
}

impl Plan {
    /// Vertices have some six half-edges; where there are more vertices than that, their parts are as many as for their
    /// half-edges. None where vertices are too far more, or too many for a word to hold one and a direction.
    pub(super) fn new(vertex_count: usize, half_edge_count: usize) -> Option<Self> {
        let parts = (half_edge_count >> PART_BITS).max(1);
        let shift = usize::BITS - (vertex_count / parts).leading_zeros();
        let part_count = (vertex_count as u64 >> shift) as usize + 1;
        (shift <= 16 && vertex_count <= 1 << 31).then_some(Self { shift, part_count })
    }

    pub(super) fn vertices_of_part(self) -> usize {
        1 << self.shift
    }

    #[inline(always)]
    fn part(self, vertex: u32) -> usize {
        (vertex >> self.shift) as usize
    }

    /// How many half-edges of the faces belong to each part.
    fn count<E: Entry>(self, faces: &[[u32; 3]]) -> Result<Vec<usize>, BuildError> {
        let mut counts = memory::filled(self.part_count, 0)?;
        for_each(0, faces, |vertex, _: E| counts[self.part(vertex)] += 1);
        Ok(counts)
    }

    /// Deals the faces from number `first` on into a slice for each part from `first_part` on, which has just the room.
    /// Parts that have none are passed over.
    fn deal<E: Entry>(
        self,
        first: usize,
        faces: &[[u32; 3]],
        first_part: usize,
        mut parts: Vec<PartMut<'_, E>>,
    ) -> Result<(), BuildError> {
        let empty = Run { count: 0, entries: [E::zeroed(); RUN], lows: [0; RUN] };
        // One more, which stays empty, for what is passed over: there is no branch for it.
        let mut runs = memory::filled(parts.len() + 1, empty)?;
        let mask = (1_u64 << self.shift) - 1;
        for_each(first, faces, |vertex, entry| {
            let part = self.part(vertex).wrapping_sub(first_part).min(parts.len());
            let run = &mut runs[part];
            let place = run.count % RUN;
            run.entries[place] = entry;
            run.lows[place] = (u64::from(vertex) & mask) as u16;
            run.count += usize::from(part < parts.len());
            if place == RUN - 1 {
                parts[part].write(run.count - RUN, run, RUN);
            }
        });
        for (part, run) in parts.iter_mut().zip(&runs) {
            let rest = run.count % RUN;
            part.write(run.count - rest, run, rest);
        }
        Ok(())
    }
}

/// The last entries of a part that were dealt.
#[derive(Clone)]
struct Run<E> {
    count: usize,
    entries: [E; RUN],
    lows: [u16; RUN],
}

/// The entries of a part, each with its vertex within the part.
#[derive(Clone, Copy)]
pub(super) struct Part<'a, E> {
    pub(super) entries: &'a [E],
    pub(super) lows: &'a [u16],
}

struct PartMut<'a, E> {
    entries: &'a mut [E],
    lows: &'a mut [u16],
}

impl<E: Entry> PartMut<'_, E> {
    #[inline(always)]
    fn write(&mut self, at: usize, run: &Run<E>, count: usize) {
        self.entries[at..at + count].copy_from_slice(&run.entries[..count]);
        self.lows[at..at + count].copy_from_slice(&run.lows[..count]);
    }
}

/// The half-edges of some parts, part after part, each in the order of the list.
pub(super) struct Dealt<'a, E> {
    pub(super) plan: Plan,
    faces: &'a [[u32; 3]],
    pieces: usize,
    /// How many each piece of the list has in each part.
    counts: Vec<Vec<usize>>,
    /// The end of each part, as if all were dealt.
    ends: Vec<usize>,
    /// Which parts are dealt.
    parts: Range<usize>,
    entries: Vec<E>,
    lows: Vec<u16>,
}

impl<'a, E: Entry> Dealt<'a, E> {
    /// Room for the half-edges of `faces`, which so many threads will deal.
    pub(super) fn new(plan: Plan, faces: &'a [[u32; 3]], pieces: usize) -> Result<Self, BuildError> {
        let cut = faces.chunks(Self::piece(faces, pieces)).collect();
        let counts = workers::map(cut, |piece| plan.count::<E>(piece));
        let counts: Vec<Vec<usize>> = counts.into_iter().collect::<Result<_, _>>()?;
        let mut ends = memory::with_room(plan.part_count)?;
        let mut end = 0;
        for part in 0..plan.part_count {
            end += counts.iter().map(|counts| counts[part]).sum::<usize>();
            ends.push(end);
        }
        let parts = 0..plan.part_count;
        let mut dealt =
            Self { plan, faces, pieces, counts, ends, parts, entries: Vec::new(), lows: Vec::new() };
        let most = dealt.rounds().into_iter().map(|parts| dealt.count(parts)).max().unwrap_or(0);
        (dealt.entries, dealt.lows) = (memory::zeroed(most)?, memory::zeroed(most)?);
        Ok(dealt)
    }

    fn piece(faces: &[[u32; 3]], pieces: usize) -> usize {
        faces.len().div_ceil(pieces).max(1)
    }

    /// Which parts to deal together, one run after the other.
    pub(super) fn rounds(&self) -> Vec<Range<usize>> {
        let bytes = 3 * self.faces.len() * (size_of::<E>() + size_of::<u16>());
        self.cut(0..self.ends.len(), if bytes > 2 * ROUND { 2 } else { 1 })
    }

    /// Deals these parts, where others were.
    pub(super) fn deal(&mut self, parts: Range<usize>) -> Result<(), BuildError> {
        self.parts = parts.clone();
        let mut slices: Vec<Vec<PartMut<'_, E>>> = Vec::new();
        for _ in &self.counts {
            slices.push(memory::with_room(parts.len())?);
        }
        let (mut rest_of_entries, mut rest_of_lows) = (&mut self.entries[..], &mut self.lows[..]);
        for part in parts.clone() {
            for (counts, slices) in self.counts.iter().zip(&mut slices) {
                let (entries, lows);
                (entries, rest_of_entries) = rest_of_entries.split_at_mut(counts[part]);
                (lows, rest_of_lows) = rest_of_lows.split_at_mut(counts[part]);
                slices.push(PartMut { entries, lows });
            }
        }
        let (plan, size) = (self.plan, Self::piece(self.faces, self.pieces));
        let pieces = self.faces.chunks(size).zip(slices).enumerate().collect();
        let deal = |(i, (piece, slices))| plan.deal(i * size, piece, parts.start, slices);
        workers::map(pieces, deal).into_iter().collect()
    }

    /// The parts that are dealt, in so many runs of about as many half-edges.
    pub(super) fn shares(&self, pieces: usize) -> Vec<Range<usize>> {
        self.cut(self.parts.clone(), pieces)
    }

    fn cut(&self, parts: Range<usize>, pieces: usize) -> Vec<Range<usize>> {
        let (start, count) = (self.start(parts.start), self.count(parts.clone()));
        let until = |piece: usize| {
            let end = start + count * piece / pieces;
            self.ends.partition_point(|&it| it <= end).clamp(parts.start, parts.end)
        };
        let last = |piece: usize| match piece {
            0 => parts.start,
            _ if piece == pieces => parts.end,
            _ => until(piece),
        };
        (0..pieces).map(|piece| last(piece)..last(piece + 1)).collect()
    }

    fn start(&self, part: usize) -> usize {
        if part == 0 { 0 } else { self.ends[part - 1] }
    }

    fn count(&self, parts: Range<usize>) -> usize {
        self.start(parts.end) - self.start(parts.start)
    }

    /// One of the parts that are dealt.
    pub(super) fn part(&self, part: usize) -> Part<'_, E> {
        let before = self.start(self.parts.start);
        let dealt = self.start(part) - before..self.ends[part] - before;
        Part { entries: &self.entries[dealt.clone()], lows: &self.lows[dealt] }
    }

    pub(super) fn longest(&self) -> usize {
        (0..self.ends.len()).map(|part| self.count(part..part + 1)).max().unwrap_or(0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half-edges by their origin.
    impl Entry for [u32; 2] {
        fn new(h: u32, a: u32, _: u32, _: u32) -> (u32, Self) {
            (a, [a, h])
        }
    }

    #[test]
    fn every_cut_into_rounds_and_pieces_deals_alike() {
        let faces: Vec<[u32; 3]> = (0..20_000).map(|i| [i * 7 % 10_007, i % 10_007, 10_007]).collect();
        let plan = Plan::new(10_008, 3 * faces.len()).unwrap();
        let mut by_origin: Vec<[u32; 2]> =
            faces.as_flattened().iter().copied().zip(0..).map(|(v, h)| [v, h]).collect();
        by_origin.sort_by_key(|[v, _]| plan.part(*v));
        for (rounds, pieces) in [(1, 1), (2, 1), (3, 2), (100, 7)] {
            let mut dealt = Dealt::<[u32; 2]>::new(plan, &faces, pieces).unwrap();
            let mut found = Vec::new();
            for parts in dealt.cut(0..plan.part_count, rounds) {
                dealt.deal(parts.clone()).unwrap();
                for part in dealt.shares(pieces).into_iter().flatten() {
                    let Part { entries, lows } = dealt.part(part);
                    assert!(entries.iter().zip(lows).all(|([v, _], &low)| {
                        *v as usize % plan.vertices_of_part() == usize::from(low) && plan.part(*v) == part
                    }));
                    found.extend_from_slice(entries);
                }
            }
            assert_eq!(found, by_origin);
        }
    }
}

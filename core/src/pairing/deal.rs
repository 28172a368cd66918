//! Deals half-edges into parts.
use crate::{BuildError, memory, workers};
use alloc::vec::Vec;

/// Half-edges of a part, about, as a power of two: with their buckets they take some 400 kB.
const PART_BITS: u32 = 14;

/// Entries that are kept together until they fill a line of the cache, so that memory is written by lines.
const RUN: usize = 8;

/// Which part an edge belongs to.
#[derive(Clone, Copy)]
pub(super) struct Plan {
    /// How far the lower vertex is shifted to give its part.
    shift: u32,
    part_count: usize,
}

impl Plan {
    /// Vertices have some six half-edges, half of which go to a higher one and half come from there; where there are
    /// more vertices than that, their parts are as many as for their half-edges. None where vertices are too far more,
    /// or too many for a word to hold one and a direction.
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
    fn part(self, low: u32) -> usize {
        (low >> self.shift) as usize
    }

    /// How many half-edges of the faces belong to each part.
    fn count(self, faces: &[[u32; 3]]) -> Result<Vec<usize>, BuildError> {
        let mut counts = memory::filled(self.part_count, 0)?;
        for &[a, b, c] in faces {
            for (a, b) in [(a, b), (b, c), (c, a)] {
                counts[self.part(a.min(b))] += 1;
            }
        }
        Ok(counts)
    }

    /// Deals the faces from number `first` on into a slice for each part, which has just the room.
    fn deal(self, first: usize, faces: &[[u32; 3]], parts: Vec<PartMut<'_>>) -> Result<(), BuildError> {
        let mut parts = parts;
        let mut runs = memory::filled(parts.len(), Run { count: 0, words: [0; RUN], lows: [0; RUN] })?;
        let mask = (1_u64 << self.shift) - 1;
        for (f, &[a, b, c]) in faces.iter().enumerate() {
            for (k, (a, b)) in [(a, b), (b, c), (c, a)].into_iter().enumerate() {
                let (low, high) = (a.min(b), a.max(b));
                let part = self.part(low);
                let run = &mut runs[part];
                let place = run.count % RUN;
                run.words[place] =
                    (u64::from(high) << 1 | u64::from(a < b)) << 32 | (3 * (first + f) + k) as u64;
                run.lows[place] = (u64::from(low) & mask) as u16;
                run.count += 1;
                if place == RUN - 1 {
                    parts[part].write(run.count - RUN, run, RUN);
                }
            }
        }
        for (part, run) in parts.iter_mut().zip(&runs) {
            let rest = run.count % RUN;
            part.write(run.count - rest, run, rest);
        }
        Ok(())
    }
}

/// The last entries of a part that were dealt.
#[derive(Clone)]
struct Run {
    count: usize,
    words: [u64; RUN],
    lows: [u16; RUN],
}

/// Entries of a part: for each the higher vertex, the direction and the half-edge in one word, and the lower vertex
/// within the part.
#[derive(Clone, Copy)]
pub(super) struct Part<'a> {
    pub(super) words: &'a [u64],
    pub(super) lows: &'a [u16],
}

struct PartMut<'a> {
    words: &'a mut [u64],
    lows: &'a mut [u16],
}

impl PartMut<'_> {
    #[inline(always)]
    fn write(&mut self, at: usize, run: &Run, count: usize) {
        self.words[at..at + count].copy_from_slice(&run.words[..count]);
        self.lows[at..at + count].copy_from_slice(&run.lows[..count]);
    }
}

/// All half-edges, part after part, each in the order of the list.
pub(super) struct Dealt {
    pub(super) plan: Plan,
    words: Vec<u64>,
    lows: Vec<u16>,
    /// The end of each part.
    ends: Vec<usize>,
}

impl Dealt {
    /// Deals `faces`, in so many pieces.
    pub(super) fn new(plan: Plan, faces: &[[u32; 3]], pieces: usize) -> Result<Self, BuildError> {
        let size = faces.len().div_ceil(pieces).max(1);
        let counts = workers::map(faces.chunks(size).collect(), |piece| plan.count(piece));
        let counts: Vec<Vec<usize>> = counts.into_iter().collect::<Result<_, _>>()?;
        let mut words = memory::zeroed(3 * faces.len())?;
        let mut lows = memory::zeroed(3 * faces.len())?;
        let mut slices: Vec<Vec<PartMut<'_>>> = Vec::new();
        for _ in &counts {
            slices.push(memory::with_room(plan.part_count)?);
        }
        let mut ends = memory::with_room(plan.part_count)?;
        let (mut rest_of_words, mut rest_of_lows) = (&mut words[..], &mut lows[..]);
        let mut end = 0;
        for part in 0..plan.part_count {
            for (counts, slices) in counts.iter().zip(&mut slices) {
                let (words, lows);
                (words, rest_of_words) = core::mem::take(&mut rest_of_words).split_at_mut(counts[part]);
                (lows, rest_of_lows) = core::mem::take(&mut rest_of_lows).split_at_mut(counts[part]);
                slices.push(PartMut { words, lows });
                end += counts[part];
            }
            ends.push(end);
        }
        let pieces = faces.chunks(size).zip(slices).enumerate().collect();
        let dealt = workers::map(pieces, |(i, (piece, slices))| plan.deal(i * size, piece, slices));
        dealt.into_iter().collect::<Result<(), _>>()?;
        Ok(Self { plan, words, lows, ends })
    }

    pub(super) fn parts(&self) -> impl Iterator<Item = Part<'_>> {
        self.parts_of(0..self.ends.len())
    }

    fn parts_of(&self, parts: core::ops::Range<usize>) -> impl Iterator<Item = Part<'_>> {
        parts.map(|part| {
            let start = if part == 0 { 0 } else { self.ends[part - 1] };
            let entries = start..self.ends[part];
            Part { words: &self.words[entries.clone()], lows: &self.lows[entries] }
        })
    }

    /// The parts in so many runs of about as many entries.
    pub(super) fn shares(&self, pieces: usize) -> Vec<impl Iterator<Item = Part<'_>>> {
        let until = |piece: usize| self.ends.partition_point(|&end| end <= self.words.len() * piece / pieces);
        let last = |piece: usize| if piece == pieces { self.ends.len() } else { until(piece) };
        (0..pieces).map(|piece| self.parts_of(last(piece)..last(piece + 1))).collect()
    }

    pub(super) fn longest(&self) -> usize {
        self.parts().map(|part| part.words.len()).max().unwrap_or(0)
    }
}

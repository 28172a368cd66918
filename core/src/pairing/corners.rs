//! Corners by their vertex: which half-edge into it runs back along which out of it, and how the faces turn around it.
use super::{
    deal::Entry,
    joiner::Extra,
    partition::{FEW, NONE, Sorted},
};
use crate::{BuildError, HalfEdgeId, Handle, corner, memory};
use alloc::vec::Vec;
use core::ops::Range;

/// A corner of a face.
#[derive(Clone, Copy, bytemuck::Zeroable)]
pub(super) struct Corner {
    /// Its half-edge, which leads out of the vertex.
    half_edge: u32,
    /// Where that leads to.
    to: u32,
    /// Where the half-edge before it comes from, which leads into the vertex.
    from: u32,
}

impl Entry for Corner {
    #[inline(always)]
    fn new(h: u32, a: u32, b: u32, c: u32) -> (u32, Self) {
        (a, Self { half_edge: h, to: b, from: c })
    }
}

/// The corners of a part, in columns that go on for `FEW` more of whatever: so a bucket is read as if it had the full size.
pub(super) struct Corners {
    half_edges: Vec<u32>,
    to: Vec<u32>,
    from: Vec<u32>,
}

impl Sorted for Corners {
    type Entry = Corner;

    fn new(count: usize) -> Result<Self, BuildError> {
        let column = || memory::zeroed(count + FEW);
        Ok(Self { half_edges: column()?, to: column()?, from: column()? })
    }

    #[inline(always)]
    fn put(&mut self, place: usize, corner: Corner) {
        self.half_edges[place] = corner.half_edge;
        self.to[place] = corner.to;
        self.from[place] = corner.from;
    }

    /// Sets the half-edges out of the vertex.
    #[inline(always)]
    fn pair(
        &mut self,
        vertex: u32,
        bucket: Range<usize>,
        set: &mut impl FnMut(u32, u32),
        extra: &mut Extra,
    ) -> Result<Option<u32>, BuildError> {
        let start = match bucket.len() {
            0 => return Ok(Some(NONE)),
            1..=8 => self.turn::<8>(bucket.clone(), set),
            9..=16 => self.turn::<16>(bucket.clone(), set),
            17..=FEW => self.turn::<FEW>(bucket.clone(), set),
            _ => None,
        };
        if start.is_some() { Ok(start) } else { self.by_sort(vertex, bucket, set, extra) }
    }
}

/// Counts once in the upper half of a word, above a place.
const ONE: u32 = 1 << 16;

/// Which corner a half-edge of an edge is of, or which it comes before.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct End {
    neighbour: u32,
    place: u32,
    leads_out: bool,
}

impl Corners {
    /// Turns once around a vertex of up to `N` corners, and gives the start of its fan. Nothing, and opposites that are to be
    /// set again, where the turn does not meet all.
    #[inline(always)]
    fn turn<const N: usize>(&self, bucket: Range<usize>, set: &mut impl FnMut(u32, u32)) -> Option<u32> {
        let (begin, count) = (bucket.start, bucket.len());
        let half_edges: &[u32; N] = self.half_edges[begin..].first_chunk()?;
        let to: &[u32; N] = self.to[begin..].first_chunk()?;
        let from: &[u32; N] = self.from[begin..].first_chunk()?;
        // For each corner the place of the next one counter-clockwise, and `ONE` if there is one: a loop without a branch.
        // Several are added up, and found out below.
        let mut next = [0_u32; N];
        for i in 0..count {
            for j in 0..N {
                next[j] += if to[i] == from[j] { ONE + i as u32 } else { 0 };
            }
        }
        let mut sum = 0;
        for j in 0..N {
            sum += if j < count { next[j] } else { 0 };
        }
        let last = count - 1;
        let is_closed = (sum / ONE) as usize == count;
        // An open fan starts at the one place that is missing in the sum of all.
        let missing = (last * count / 2).wrapping_sub((sum % ONE) as usize);
        let start = if is_closed { 0 } else { missing.min(last) };
        let (mut at, mut seen, mut any) = (start, 1_u32 << start, 0);
        for _ in 1..count {
            let before = before(half_edges[at]);
            any |= next[at];
            at = (next[at] as usize % N).min(last);
            seen |= 1 << at;
            set(half_edges[at], before);
        }
        set(half_edges[start], if is_closed { before(half_edges[at]) } else { NONE });
        let is_end = next[at] == if is_closed { ONE + start as u32 } else { 0 };
        let met_all = seen == u32::MAX >> (31 - last) && (sum / ONE) as usize >= last;
        (met_all && is_end && any < 2 * ONE).then_some(half_edges[start])
    }

    /// Many corners, irregular edges, or several fans.
    #[inline(never)]
    fn by_sort(
        &self,
        vertex: u32,
        bucket: Range<usize>,
        set: &mut impl FnMut(u32, u32),
        extra: &mut Extra,
    ) -> Result<Option<u32>, BuildError> {
        let half_edges = &self.half_edges[bucket.clone()];
        let mut ends = memory::with_room(2 * bucket.len())?;
        for (i, place) in bucket.clone().zip(0..) {
            ends.push(End { neighbour: self.to[i], place, leads_out: true });
            ends.push(End { neighbour: self.from[i], place, leads_out: false });
        }
        ends.sort_unstable();
        let half_edge = |end: &End| {
            let h = half_edges[end.place as usize];
            if end.leads_out { h } else { before(h) }
        };
        let mut next = memory::filled(bucket.len(), NONE)?;
        let (mut start, mut open_count, mut is_regular) = (0, 0, true);
        for edge in ends.chunk_by(|x, y| x.neighbour == y.neighbour) {
            if let [x, y] = edge
                && x.leads_out != y.leads_out
            {
                let (out, into) = if x.leads_out { (x, y) } else { (y, x) };
                set(half_edge(out), half_edge(into));
                next[into.place as usize] = out.place;
                continue;
            }
            for out in edge.iter().filter(|end| end.leads_out) {
                set(half_edge(out), NONE);
                (start, open_count) = (out.place as usize, open_count + 1);
            }
            is_regular &= edge.len() == 1;
            // Its lower end tells of an irregular edge.
            if edge.len() > 1 && vertex < edge[0].neighbour {
                let handle = |end| HalfEdgeId::new(half_edge(end) as usize);
                let root = edge.iter().map(handle).min();
                for h in edge.iter().map(handle).filter(|&h| Some(h) != root) {
                    memory::push(extra, (root.unwrap_or(h), h))?;
                }
            }
        }
        let is_one = is_regular && open_count <= 1 && meets_all(&next, start);
        Ok(is_one.then(|| half_edges[start]))
    }
}

/// Whether a turn from `start` meets all corners. No two have the same next one.
fn meets_all(next: &[u32], start: usize) -> bool {
    let mut at = start;
    (1..next.len()).all(|_| {
        at = next[at] as usize;
        at != start && at < next.len()
    })
}

/// The half-edge before `h` in its face.
#[inline(always)]
fn before(h: u32) -> u32 {
    corner::prev(HalfEdgeId::new(h as usize)).index() as u32
}

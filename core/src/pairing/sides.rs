//! Half-edges by the lower vertex of their edge: all that it takes to pair them.
use super::{
    deal::Entry,
    joiner::Extra,
    partition::{FEW, NONE, Sorted},
};
use crate::{BuildError, HalfEdgeId, Handle, memory};
use alloc::vec::Vec;
use core::ops::Range;

/// The higher vertex, then in one bit whether the half-edge leads up, and the half-edge.
#[derive(Clone, Copy, bytemuck::Zeroable)]
pub(super) struct Side(u64);

/// Where the higher vertex stands.
const HIGH: u32 = 33;

impl Side {
    fn half_edge(self) -> u32 {
        self.0 as u32
    }

    fn leads_up(self) -> bool {
        self.0 >> (HIGH - 1) & 1 != 0
    }

    fn is_along(self, other: Self) -> bool {
        (self.0 ^ other.0) >> HIGH == 0
    }
}

impl Entry for Side {
    #[inline(always)]
    fn new(h: u32, a: u32, b: u32, _: u32) -> (u32, Self) {
        (a.min(b), Self((u64::from(a.max(b)) << 1 | u64::from(a < b)) << 32 | u64::from(h)))
    }
}

/// The sides of a part.
pub(super) struct Sides(Vec<Side>);

impl Sorted for Sides {
    type Entry = Side;

    fn new(count: usize) -> Result<Self, BuildError> {
        Ok(Self(memory::zeroed(count)?))
    }

    #[inline(always)]
    fn put(&mut self, place: usize, entry: Side) {
        self.0[place] = entry;
    }

    #[inline(always)]
    fn pair(
        &mut self,
        _: u32,
        bucket: Range<usize>,
        set: &mut impl FnMut(u32, u32),
        extra: &mut Extra,
    ) -> Result<Option<u32>, BuildError> {
        let bucket = &mut self.0[bucket];
        let count = bucket.len();
        if count > FEW {
            return by_sort(bucket, set, extra).map(|()| None);
        }
        let mut is_paired = 0_u32;
        for i in 0..count {
            if is_paired >> i & 1 != 0 {
                continue;
            }
            // Without a branch in the loop.
            let (mut found, mut others) = (i, 0);
            for j in i + 1..count {
                let is_along = bucket[i].is_along(bucket[j]);
                found = if is_along { j } else { found };
                others += usize::from(is_along);
            }
            let (side, other) = (bucket[i], bucket[found]);
            if others == 0 {
                set(side.half_edge(), NONE);
            } else if others == 1 && side.leads_up() != other.leads_up() {
                is_paired |= 1 << found;
                set(side.half_edge(), other.half_edge());
                set(other.half_edge(), side.half_edge());
            } else {
                // What was set already is set alike.
                return by_sort(bucket, set, extra).map(|()| None);
            }
        }
        Ok(None)
    }
}

/// Many edges of one lower vertex, or irregular ones.
#[inline(never)]
fn by_sort(bucket: &mut [Side], set: &mut impl FnMut(u32, u32), extra: &mut Extra) -> Result<(), BuildError> {
    // By the higher vertex, then by the half-edge: all but the direction, in one comparison.
    bucket.sort_unstable_by_key(|side| side.0 & !(1 << (HIGH - 1)));
    for edge in bucket.chunk_by(|x, y| x.is_along(*y)) {
        if let &[x, y] = edge
            && x.leads_up() != y.leads_up()
        {
            set(x.half_edge(), y.half_edge());
            set(y.half_edge(), x.half_edge());
            continue;
        }
        let root = HalfEdgeId::new(edge[0].half_edge() as usize);
        edge.iter().for_each(|side| set(side.half_edge(), NONE));
        for side in &edge[1..] {
            memory::push(extra, (root, HalfEdgeId::new(side.half_edge() as usize)))?;
        }
    }
    Ok(())
}

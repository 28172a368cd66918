//! [`UnionFind`] over handles.
use crate::{Handle, union_find::UnionFind};
use core::marker::PhantomData;

/// A partition of the handles below a count, at first each on its own.
pub(crate) struct DisjointSets<H> {
    sets: UnionFind,
    kind: PhantomData<fn(H)>,
}

impl<H: Handle> DisjointSets<H> {
    pub(crate) fn new(count: usize) -> Self {
        Self { sets: UnionFind::new(count), kind: PhantomData }
    }

    /// The least member of the set of `h`.
    #[inline]
    pub(crate) fn least(&mut self, h: H) -> H {
        H::new(self.sets.find(h.index() as u32) as usize)
    }

    /// Makes one set of those of `a` and `b`.
    #[inline]
    pub(crate) fn join(&mut self, a: H, b: H) {
        self.sets.union(a.index() as u32, b.index() as u32);
    }
}

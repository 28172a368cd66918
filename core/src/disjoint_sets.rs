//! Sets that only ever grow together (union-find).
use crate::{Handle, Map};

/// A partition of the handles below a count, at first each on its own.
pub(crate) struct DisjointSets<H> {
    parent: Map<H, H>,
}

impl<H: Handle> DisjointSets<H> {
    pub(crate) fn new(count: usize) -> Self {
        Self { parent: Map::from_fn(count, |h| h) }
    }

    /// The least member of the set of `h`. Halves the path on the way.
    pub(crate) fn least(&mut self, mut h: H) -> H {
        loop {
            let parent = self.parent[h];
            let above = self.parent[parent];
            if parent == above {
                return parent;
            }
            self.parent[h] = above;
            h = above;
        }
    }

    /// Makes one set of those of `a` and `b`.
    pub(crate) fn join(&mut self, a: H, b: H) {
        let (a, b) = (self.least(a), self.least(b));
        self.parent[a.max(b)] = a.min(b);
    }
}

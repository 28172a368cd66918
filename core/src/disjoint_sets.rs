//! Disjoint sets of handles, plain and with a parity: what counting components and orienting patches rest on.
use crate::{BuildError, Handle, Map, memory};

/// A partition of the handles below a count, at first each on its own; a set is named by its least member.
///
/// The less root always wins, so a set's name does not depend on the order of the unions. Paths are halved on
/// the way; without ranks the bound is O(log n) amortised for each call, in practice close to O(1).
pub(crate) struct DisjointSets<H> {
    parent: Map<H, H>,
}

impl<H: Handle> DisjointSets<H> {
    pub(crate) fn new(count: usize) -> Result<Self, BuildError> {
        Ok(Self { parent: memory::collected((0..count).map(H::new))?.into() })
    }

    /// The least member of the set of `h`.
    #[inline]
    pub(crate) fn least(&mut self, mut h: H) -> H {
        loop {
            let up = self.parent[h];
            if up == h {
                return h;
            }
            let above = self.parent[up];
            self.parent[h] = above;
            h = above;
        }
    }

    /// Makes one set of those of `a` and `b`.
    #[inline]
    pub(crate) fn join(&mut self, a: H, b: H) {
        let (a, b) = (self.least(a), self.least(b));
        self.parent[a.max(b)] = a.min(b);
    }

    /// The least member of the set of each handle. O(count), in place.
    pub(crate) fn into_least(mut self) -> Map<H, H> {
        // A parent is less than its child, so it leads to the least member already.
        for h in (0..self.parent.len()).map(H::new) {
            self.parent[h] = self.parent[self.parent[h]];
        }
        self.parent
    }
}

/// Disjoint sets where each member is even or odd in respect of its set's least member.
///
/// Same costs as [`DisjointSets`]; a contradiction is reported by [`join`](Self::join) and changes nothing.
pub(crate) struct ParitySets<H> {
    /// `2 * parent + parity in respect of the parent`: one word, one cache miss.
    link: Map<H, u32>,
    count: usize,
}

/// What [`ParitySets::join`] found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Joined {
    /// Two sets became one.
    Merged,
    /// One set already, and its parities say the same.
    Agreed,
    /// One set already, and its parities say the opposite.
    Contradicted,
}

impl<H: Handle> ParitySets<H> {
    /// All even. `count` is at most 2^31; there are fewer faces than that.
    pub(crate) fn new(count: usize) -> Result<Self, BuildError> {
        debug_assert!(count <= 1 << 31);
        let link = memory::collected((0..count).map(|i| 2 * i as u32))?.into();
        Ok(Self { link, count })
    }

    /// The least member of the set of `h`, and whether `h` is odd in respect of it.
    pub(crate) fn least(&mut self, h: H) -> (H, bool) {
        let (mut h, mut odd) = (h, 0);
        loop {
            let up = self.link[h];
            let parent = H::new((up >> 1) as usize);
            if parent == h {
                return (h, odd == 1);
            }
            let above = self.link[parent] ^ (up & 1);
            self.link[h] = above;
            odd ^= above & 1;
            h = H::new((above >> 1) as usize);
        }
    }

    /// States that `a` and `b` have the same parity, or the opposite one if `odd`.
    pub(crate) fn join(&mut self, a: H, b: H, odd: bool) -> Joined {
        let ((a, odd_a), (b, odd_b)) = (self.least(a), self.least(b));
        let odd = odd ^ odd_a ^ odd_b;
        if a == b {
            return if odd { Joined::Contradicted } else { Joined::Agreed };
        }
        self.link[a.max(b)] = 2 * a.min(b).index() as u32 + u32::from(odd);
        self.count -= 1;
        Joined::Merged
    }

    /// How many sets there are.
    pub(crate) fn count(&self) -> usize {
        self.count
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::FaceId;

    #[test]
    fn the_least_member_names_the_set() {
        let f = FaceId::new;
        let mut sets = DisjointSets::new(6).unwrap();
        for (a, b) in [(5, 3), (3, 1), (5, 1)] {
            sets.join(f(a), f(b));
        }
        assert_eq!((sets.least(f(5)), sets.least(f(4))), (f(1), f(4)));
        assert_eq!(sets.into_least().as_slice(), [0, 1, 2, 1, 4, 1].map(f));
    }

    #[test]
    fn parities_add_up_along_a_path() {
        let f = FaceId::new;
        let mut sets = ParitySets::new(5).unwrap();
        for x in (0..4).rev() {
            assert_eq!(sets.join(f(x), f(x + 1), true), Joined::Merged);
        }
        let odd = [0, 1, 2, 3, 4].map(|x| sets.least(f(x)).1);
        assert_eq!(odd, [false, true, false, true, false]);
        assert_eq!(sets.join(f(0), f(4), false), Joined::Agreed);
        assert_eq!(sets.join(f(0), f(4), true), Joined::Contradicted);
        assert_eq!(sets.count(), 1);
    }
}

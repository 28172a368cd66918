//! Disjoint sets, plain and with a parity: what counting components and orienting patches rest on.

use alloc::vec::Vec;

/// Disjoint sets over `0..len`, each named by its least member.
///
/// The less root always wins, so a set's name does not depend on the order of the unions. Paths are halved on
/// the way; without ranks the bound is O(log n) amortised for each call, in practice close to O(1).
#[derive(Clone, Debug)]
pub struct UnionFind {
    parent: Vec<u32>,
    sets: usize,
}

impl UnionFind {
    /// Makes `len` sets of one element each. O(len).
    ///
    /// # Panics
    /// If `len` is above `u32::MAX`.
    pub fn new(len: usize) -> Self {
        let end = u32::try_from(len).expect("UnionFind holds up to u32::MAX elements");
        Self { parent: (0..end).collect(), sets: len }
    }

    /// The least member of the set that holds `x`.
    ///
    /// # Panics
    /// If `x` is not below the length.
    pub fn find(&mut self, mut x: u32) -> u32 {
        loop {
            let up = self.parent[x as usize];
            if up == x {
                return x;
            }
            let above = self.parent[up as usize];
            self.parent[x as usize] = above;
            x = above;
        }
    }

    /// Joins two sets; `false` where they were one already.
    ///
    /// # Panics
    /// If `a` or `b` is not below the length.
    pub fn union(&mut self, a: u32, b: u32) -> bool {
        let (a, b) = (self.find(a), self.find(b));
        if a == b {
            return false;
        }
        self.parent[a.max(b) as usize] = a.min(b);
        self.sets -= 1;
        true
    }

    /// How many sets there are.
    pub fn set_count(&self) -> usize {
        self.sets
    }
}

/// Disjoint sets where each member is even or odd in respect of its set's least member.
///
/// Same costs as [`UnionFind`]; a contradiction is reported by [`union`](Self::union) and changes nothing.
#[derive(Clone, Debug)]
pub struct ParityUnionFind {
    /// `2 * parent + parity in respect of the parent`: one word, one cache miss.
    link: Vec<u32>,
    sets: usize,
}

/// What [`ParityUnionFind::union`] found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Joined {
    /// Two sets became one.
    Merged,
    /// One set already, and its parities say the same.
    Agreed,
    /// One set already, and its parities say the opposite.
    Contradicted,
}

impl ParityUnionFind {
    /// Makes `len` sets of one even element each. O(len).
    ///
    /// # Panics
    /// If `len` is above `2^31 - 1`.
    pub fn new(len: usize) -> Self {
        let end = u32::try_from(len).ok().filter(|&n| n <= i32::MAX as u32);
        let end = end.expect("ParityUnionFind holds up to 2^31 - 1 elements");
        Self { link: (0..end).map(|x| 2 * x).collect(), sets: len }
    }

    /// The least member of the set that holds `x`, and whether `x` is odd in respect of it.
    ///
    /// # Panics
    /// If `x` is not below the length.
    pub fn find(&mut self, mut x: u32) -> (u32, bool) {
        let mut odd = 0;
        loop {
            let up = self.link[x as usize];
            if up >> 1 == x {
                return (x, odd == 1);
            }
            let above = self.link[(up >> 1) as usize] ^ (up & 1);
            self.link[x as usize] = above;
            odd ^= above & 1;
            x = above >> 1;
        }
    }

    /// States that `a` and `b` have the same parity, or the opposite one if `odd`.
    ///
    /// # Panics
    /// If `a` or `b` is not below the length.
    pub fn union(&mut self, a: u32, b: u32, odd: bool) -> Joined {
        let ((a, odd_a), (b, odd_b)) = (self.find(a), self.find(b));
        let odd = odd ^ odd_a ^ odd_b;
        if a == b {
            return if odd { Joined::Contradicted } else { Joined::Agreed };
        }
        self.link[a.max(b) as usize] = 2 * a.min(b) + u32::from(odd);
        self.sets -= 1;
        Joined::Merged
    }

    /// How many sets there are.
    pub fn set_count(&self) -> usize {
        self.sets
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_least_member_names_the_set() {
        let mut sets = UnionFind::new(6);
        assert!(sets.union(5, 3) && sets.union(3, 1) && !sets.union(5, 1));
        assert_eq!((sets.find(5), sets.find(4), sets.set_count()), (1, 4, 4));
    }

    #[test]
    fn parities_add_up_along_a_path() {
        let mut sets = ParityUnionFind::new(5);
        for x in (0..4).rev() {
            assert_eq!(sets.union(x, x + 1, true), Joined::Merged);
        }
        assert_eq!(
            [0, 1, 2, 3, 4].map(|x| sets.find(x)).map(|(_, odd)| odd),
            [false, true, false, true, false]
        );
        assert_eq!(sets.union(0, 4, false), Joined::Agreed);
        assert_eq!(sets.union(0, 4, true), Joined::Contradicted);
        assert_eq!(sets.set_count(), 1);
    }
}

//! [`Marks`]: marks on some places of a row, which can be counted and found.
use alloc::{boxed::Box, vec::Vec};
use onering_core::{BuildError, memory};

/// Bits of a word.
const WORD: usize = u64::BITS as usize;

/// A bit for each place of a row, set where it is marked, with what it takes to count marks (`rank`) and to find the
/// one of a number (`select`) without running through them: Jacobson, "Space-efficient static trees and graphs", FOCS
/// 1989. For each 64 places 12 bytes, and 4 for each `STRIDE` marks.
#[derive(Clone, Debug)]
pub(super) struct Marks<const STRIDE: usize> {
    words: Box<[u64]>,
    /// For each word, the number of marks before it.
    before: Box<[u32]>,
    /// The place of each mark whose number is a multiple of the stride.
    samples: Box<[u32]>,
}

/// No mark yet, for so many places.
pub(super) fn no_marks(places: usize) -> Result<Vec<u64>, BuildError> {
    memory::filled(places.div_ceil(WORD), 0)
}

/// Marks place `p`.
pub(super) fn mark(words: &mut [u64], p: usize) {
    words[p / WORD] |= 1 << (p % WORD);
}

impl<const STRIDE: usize> Marks<STRIDE> {
    /// The marks that were made with [`mark`]. O(words).
    pub(super) fn new(words: Vec<u64>) -> Result<Self, BuildError> {
        let count: usize = words.iter().map(|word| word.count_ones() as usize).sum();
        let mut before = memory::with_room(words.len())?;
        let mut samples = memory::with_room(count.div_ceil(STRIDE))?;
        let mut marks = 0;
        for (i, &word) in words.iter().enumerate() {
            before.push(marks);
            while samples.len() * STRIDE < (marks + word.count_ones()) as usize {
                let skipped = (samples.len() * STRIDE) as u32 - marks;
                let rest = (0..skipped).fold(word, |word, _| word & (word - 1));
                samples.push((WORD * i) as u32 + rest.trailing_zeros());
            }
            marks += word.count_ones();
        }
        Ok(Self { words: words.into(), before: before.into(), samples: samples.into() })
    }

    /// Whether place `p` is marked.
    #[inline(always)]
    pub(super) fn has(&self, p: usize) -> bool {
        self.words[p / WORD] >> (p % WORD) & 1 == 1
    }

    /// How many places before `p` are marked. O(1).
    #[inline(always)]
    pub(super) fn rank(&self, p: usize) -> usize {
        let below = self.words[p / WORD] & ((1 << (p % WORD)) - 1);
        (self.before[p / WORD] + below.count_ones()) as usize
    }

    /// The place of mark `n`, of which there have to be more. O(1), and a look at each word between it and the mark
    /// before it whose place is kept.
    #[inline(always)]
    pub(super) fn select(&self, n: usize) -> usize {
        let mut place = self.samples[n / STRIDE] as usize;
        let mut rest = self.from(place);
        for _ in 0..n % STRIDE {
            (place, rest) = self.following(place, rest);
        }
        place
    }

    /// The first marked place after `p`, which is marked and not the last. A word at a time.
    #[inline(always)]
    pub(super) fn next_after(&self, p: usize) -> usize {
        self.following(p, self.from(p)).0
    }

    /// The marks of the word of place `p`, from there on.
    #[inline(always)]
    fn from(&self, p: usize) -> u64 {
        self.words[p / WORD] & (u64::MAX << (p % WORD))
    }

    /// The mark after that at `place`, which is the first of the `rest` of its word; and the rest from there.
    #[inline(always)]
    fn following(&self, place: usize, rest: u64) -> (usize, u64) {
        let mut i = place / WORD;
        let mut rest = rest & (rest - 1);
        while rest == 0 {
            i += 1;
            rest = self.words[i];
        }
        (WORD * i + rest.trailing_zeros() as usize, rest)
    }

    pub(super) fn heap_bytes(&self) -> usize {
        size_of_val(&*self.words) + size_of_val(&*self.before) + size_of_val(&*self.samples)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Beside a plain list of the marked places: dense, sparse, and with whole words between.
    #[test]
    fn as_a_list_of_places() {
        for places in [0, 1, 63, 64, 65, 128, 1000, 20_000] {
            for step in [1, 2, 6, 7, 63, 64, 65, 500, 5000] {
                let marked: Vec<usize> = (step / 2..places).step_by(step).collect();
                let mut words = no_marks(places).unwrap();
                marked.iter().for_each(|&p| mark(&mut words, p));
                let marks = Marks::<8>::new(words).unwrap();
                for (n, &p) in marked.iter().enumerate() {
                    assert_eq!(marks.select(n), p, "{places} places, {step}: mark {n}");
                    assert_eq!(marks.rank(p), n, "{places} places, {step}: before {p}");
                }
                for p in 0..places {
                    let before = marked.partition_point(|&q| q < p);
                    assert_eq!(marks.rank(p), before, "{places} places, {step}: before {p}");
                    assert_eq!(marks.has(p), marked.contains(&p), "{places} places, {step}: {p}");
                }
                for pair in marked.windows(2) {
                    assert_eq!(marks.next_after(pair[0]), pair[1], "{places} places, {step}");
                }
                let bytes = 12 * places.div_ceil(64) + 4 * marked.len().div_ceil(8);
                assert_eq!(marks.heap_bytes(), bytes, "{places} places, {step}");
            }
        }
    }
}

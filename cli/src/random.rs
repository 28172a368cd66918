//! Random numbers, the same at every run.

use onering::{BuildError, Handle, memory};

/// SplitMix64 (Steele et al. 2014).
#[derive(Debug)]
pub(crate) struct Random(pub(crate) u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        scramble(self.0)
    }

    /// The handles below `count`, each once, in any order (Fisher and Yates, by Durstenfeld 1964).
    pub(crate) fn permutation<H: Handle>(&mut self, count: usize) -> Result<Vec<H>, BuildError> {
        let mut handles = memory::collected((0..count).map(H::new))?;
        for i in (1..count).rev() {
            handles.swap(i, self.below(i + 1));
        }
        Ok(handles)
    }

    /// Below `bound`, by the high part of a product: no bias that could matter here.
    pub(crate) fn below(&mut self, bound: usize) -> usize {
        ((u128::from(self.next()) * bound as u128) >> 64) as usize
    }
}

/// Every bit of the result depends on every bit of `x`.
pub(crate) fn scramble(mut x: u64) -> u64 {
    x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
    x ^ (x >> 31)
}

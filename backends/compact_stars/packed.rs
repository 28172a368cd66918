//! [`Packed`]: whole numbers in as many bits each as the largest of them takes.
use alloc::boxed::Box;
use onering_core::{BuildError, memory};

/// A number is read through a window of so many bytes, so that many lie behind the last.
const WINDOW: usize = size_of::<u64>();

/// A row of whole numbers, negative ones as well, each in the same number of bits.
#[derive(Clone, Debug)]
pub(super) struct Packed {
    bytes: Box<[u8]>,
    /// Bits of a number: 33 at most, so that with the seven bits before it, it is within its window.
    width: u32,
}

impl Packed {
    /// So many zeros, with room in each place for numbers from `-largest` to `largest`.
    pub(super) fn zeros(count: usize, largest: u32) -> Result<Self, BuildError> {
        let width = u32::BITS - largest.leading_zeros() + 1;
        let bytes = (count as u64 * u64::from(width)).div_ceil(8) as usize;
        Ok(Self { bytes: memory::filled(bytes + WINDOW, 0)?.into(), width })
    }

    /// Bits of a number.
    pub(super) fn width(&self) -> u32 {
        self.width
    }

    /// The byte that number `i` begins in, and at which bit.
    #[inline(always)]
    fn begin(&self, i: usize) -> (usize, u32) {
        let bit = i as u64 * u64::from(self.width);
        ((bit / 8) as usize, (bit % 8) as u32)
    }

    /// Number `i`.
    #[inline(always)]
    pub(super) fn get(&self, i: usize) -> i64 {
        let (byte, bit) = self.begin(i);
        let window = self.bytes[byte..byte + WINDOW].try_into().map_or(0, i64::from_le_bytes);
        // Up to the top, so that what is after it falls off, and down again with copies of its sign.
        (window << (u64::BITS - self.width - bit)) >> (u64::BITS - self.width)
    }

    /// Makes number `i`, which is 0, another.
    pub(super) fn set(&mut self, i: usize, number: i64) {
        let (byte, bit) = self.begin(i);
        let bits = (number as u64 & ((1 << self.width) - 1)) << bit;
        let window = self.bytes[byte..byte + WINDOW].iter_mut();
        window.zip(bits.to_le_bytes()).for_each(|(byte, bits)| *byte |= bits);
    }

    pub(super) fn heap_bytes(&self) -> usize {
        size_of_val(&*self.bytes)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec::Vec;

    #[test]
    fn numbers_come_back_from_any_width() {
        for largest in (0..32).map(|bits| u32::MAX >> bits).chain([0, 1 << 31, 5]) {
            let most = i64::from(largest);
            let spread = (0..200).map(|i| i * 0x9e37_79b9 % (2 * most + 1) - most);
            let numbers: Vec<i64> = [0, most, -most, -1.max(-most), most].into_iter().chain(spread).collect();
            let mut packed = Packed::zeros(numbers.len(), largest).unwrap();
            numbers.iter().enumerate().for_each(|(i, &number)| packed.set(i, number));
            for (i, &number) in numbers.iter().enumerate() {
                assert_eq!(packed.get(i), number, "number {i} of {} bits", packed.width());
            }
            let bits = (1..=33).find(|bits| 1_u64 << (bits - 1) > u64::from(largest)).unwrap();
            assert_eq!(packed.width() as usize, bits);
            assert_eq!(packed.heap_bytes(), (205 * bits).div_ceil(8) + 8);
        }
    }
}

//! Sorting by keys of 48 bits.
use alloc::{vec, vec::Vec};

/// Bits of a key that count.
pub(super) const KEY_BITS: u32 = 48;

/// Four passes. With 16 the counters leave the first level of the cache; eight passes of 6 move everything twice as
/// often.
const DIGIT_BITS: u32 = 12;

/// Puts the values in the order of their keys; those of equal keys stay in the order that they had. O(n).
pub(super) fn sort<T: Copy>(keyed: &mut Vec<(u64, T)>) {
    let Some(&first) = keyed.first() else { return };
    let mut other = vec![first; keyed.len()];
    for shift in (0..KEY_BITS).step_by(DIGIT_BITS as usize) {
        let digit = |key: u64| (key >> shift) as usize & ((1 << DIGIT_BITS) - 1);
        let mut starts = vec![0_usize; 1 << DIGIT_BITS];
        keyed.iter().for_each(|&(key, _)| starts[digit(key)] += 1);
        if starts[digit(first.0)] == keyed.len() {
            continue;
        }
        let mut sum = 0;
        starts.iter_mut().for_each(|start| sum += core::mem::replace(start, sum));
        for &pair in &*keyed {
            let at = &mut starts[digit(pair.0)];
            other[*at] = pair;
            *at += 1;
        }
        core::mem::swap(keyed, &mut other);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_a_stable_sort_does() {
        let mut state = 1_u64;
        for (count, bits) in [(0, 48), (1, 48), (1000, 48), (1000, 5), (1000, 0)] {
            let keys = (0..count).map(|i| {
                state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
                ((state >> 16) & ((1 << bits) - 1), i)
            });
            let mut found: Vec<(u64, u32)> = keys.collect();
            let mut expected = found.clone();
            expected.sort_by_key(|&(key, _)| key);
            sort(&mut found);
            assert_eq!(found, expected, "{count} keys of {bits} bits");
        }
    }
}

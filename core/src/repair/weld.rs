//! Welding: vertices at exactly equal positions become one.

use alloc::vec;
use alloc::vec::Vec;

/// Which vertices are one after welding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Welded {
    /// The new vertex of each old one.
    pub target: Vec<u32>,
    /// The first old vertex of each new one, rising.
    pub source: Vec<u32>,
}

/// Gives vertices with equal positions one number, in order of first appearance.
///
/// Equality is that of `f32`: -0.0 equals +0.0, infinities equal themselves, and a NaN equals nothing, itself
/// included, so that vertices of unknown place are never brought together. No tolerance. O(n log n) by sorting,
/// which no choice of positions can slow down, as it could a hash table.
///
/// # Panics
/// If there are more than `u32::MAX` positions.
pub fn weld(positions: &[[f32; 3]]) -> Welded {
    let count = u32::try_from(positions.len()).expect("vertices are numbered by u32");
    let mut order: Vec<(u128, u32)> = (0..count).map(|v| (key(positions[v as usize]), v)).collect();
    order.sort_unstable();
    let mut first = vec![0; positions.len()];
    for group in order.chunk_by(|a, b| a.0 == b.0) {
        let leader = group[0].1;
        let nowhere = positions[leader as usize].iter().any(|x| x.is_nan());
        for &(_, v) in group {
            first[v as usize] = if nowhere { v } else { leader };
        }
    }
    number(first)
}

/// Position as an integer: equal where the position is, NaN aside.
fn key(position: [f32; 3]) -> u128 {
    // -0.0 + 0.0 is +0.0; nothing else changes.
    position.iter().fold(0, |key, x| key << 32 | u128::from((x + 0.0).to_bits()))
}

/// From the first vertex of each one's group to consecutive numbers.
fn number(mut first: Vec<u32>) -> Welded {
    let mut source = Vec::new();
    for v in 0..first.len() {
        let leader = first[v] as usize;
        first[v] = if leader == v {
            source.push(v as u32);
            source.len() as u32 - 1
        } else {
            // A group is led by its least vertex, which has its number already.
            first[leader]
        };
    }
    Welded { target: first, source }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn first_appearance_and_both_zeros() {
        let welded = weld(&[[1.0, 2.0, 3.0], [0.0; 3], [-0.0, 0.0, -0.0], [1.0, 2.0, 3.0], [0.5; 3]]);
        assert_eq!((welded.target, welded.source), (vec![0, 1, 1, 0, 2], vec![0, 1, 4]));
    }

    #[test]
    fn nan_equals_nothing() {
        let (nan, inf) = (f32::NAN, f32::INFINITY);
        let welded =
            weld(&[[nan, 0.0, 0.0], [nan, 0.0, 0.0], [inf; 3], [inf; 3], [-inf; 3], [nan, 0.0, 0.0]]);
        assert_eq!(welded.target, [0, 1, 2, 2, 3, 4]);
    }

    #[test]
    fn nothing_to_weld() {
        assert_eq!(weld(&[]), Welded { target: vec![], source: vec![] });
        assert_eq!(weld(&[[f32::NAN; 3]]).target, [0]);
    }
}

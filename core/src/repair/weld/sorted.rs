//! Welding by sorting, which no choice of positions slows down.

use super::{is_nowhere, key};
use crate::{BuildError, memory};
use alloc::vec::Vec;

/// O(n log n).
pub(super) fn weld(
    target: &mut [u32],
    position: &impl Fn(usize) -> [f32; 3],
) -> Result<Vec<[f32; 3]>, BuildError> {
    let mut order = memory::collected((0..target.len()).map(|v| (key(position(v)), v as u32)))?;
    order.sort_unstable();
    for group in order.chunk_by(|a, b| a.0 == b.0) {
        let leader = group[0].1;
        let nowhere = is_nowhere(position(leader as usize));
        for &(_, v) in group {
            target[v as usize] = if nowhere { v } else { leader };
        }
    }
    drop(order);
    number(target, position)
}

/// From the first vertex of each one's group to consecutive numbers.
fn number(first: &mut [u32], position: &impl Fn(usize) -> [f32; 3]) -> Result<Vec<[f32; 3]>, BuildError> {
    let mut positions = Vec::new();
    for v in 0..first.len() {
        let leader = first[v] as usize;
        // A group is led by its least vertex, which has its number already.
        if leader == v {
            first[v] = positions.len() as u32;
            memory::push(&mut positions, position(v))?;
        } else {
            first[v] = first[leader];
        }
    }
    Ok(positions)
}

//! Welding: vertices at exactly equal positions become one.

mod sorted;
mod table;
mod welder;

pub use self::welder::Welder;

use crate::{BuildError, memory};
use alloc::vec::Vec;

/// Which vertices are one after welding.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Welded {
    /// The new vertex of each old one.
    pub target: Vec<u32>,
    /// The first old vertex of each new one, rising.
    pub source: Vec<u32>,
}

/// More cannot be numbered.
const MAX_VERTICES: usize = u32::MAX as usize;

/// Gives vertices with equal positions one number, in order of first appearance.
///
/// Equality is that of `f32`: -0.0 equals +0.0, infinities equal themselves, and a NaN equals nothing, itself
/// included, so that vertices of unknown place are never brought together. No tolerance. Linear in the positions by
/// way of a hash table; where they were chosen so that it would be slow, sorting takes over: O(n log n).
///
/// # Errors
/// [`BuildError::OutOfMemory`], or [`BuildError::TooManyVertices`] for more than `u32::MAX` positions.
pub fn weld(positions: &[[f32; 3]]) -> Result<Welded, BuildError> {
    let mut target = memory::filled(positions.len(), 0)?;
    let mut source = memory::with_room(weld_into(&mut target, |v| positions[v])?.len())?;
    for (v, new) in target.iter().enumerate() {
        if *new as usize == source.len() {
            source.push(v as u32);
        }
    }
    Ok(Welded { target, source })
}

/// [`weld`] for vertices that lie elsewhere, such as the corners of triangles in a file: vertex `v` of
/// `target.len()` is at `position(v)`, and `target[v]` becomes its new number. Gives the positions of the new
/// vertices, each to the last bit that of the first old one there. While it runs, the
/// table takes 1 to 13 bytes for each vertex, the more the fewer of them are equal; sorting takes 16.
///
/// # Errors
/// As [`weld`].
pub fn weld_into(
    target: &mut [u32],
    position: impl Fn(usize) -> [f32; 3],
) -> Result<Vec<[f32; 3]>, BuildError> {
    if target.len() > MAX_VERTICES {
        return Err(BuildError::TooManyVertices { vertices: target.len(), limit: MAX_VERTICES });
    }
    let mut welder = Welder::new(target.len())?;
    if welder.add(target, &position)? {
        return Ok(welder.into_positions());
    }
    drop(welder);
    sorted::weld(target, &position)
}

/// Position as integers: equal where the position is, NaN aside.
#[inline(always)]
fn key(position: [f32; 3]) -> [u32; 3] {
    // -0.0 + 0.0 is +0.0; nothing else changes.
    position.map(|x| (x + 0.0).to_bits())
}

#[inline(always)]
fn is_nowhere(position: [f32; 3]) -> bool {
    position.iter().any(|x| x.is_nan())
}

#[cfg(test)]
mod tests {
    use super::*;
    use alloc::vec;

    #[test]
    fn numbers_go_by_first_appearance_and_both_zeros() {
        let welded =
            weld(&[[1.0, 2.0, 3.0], [0.0; 3], [-0.0, 0.0, -0.0], [1.0, 2.0, 3.0], [0.5; 3]]).unwrap();
        assert_eq!((welded.target, welded.source), (vec![0, 1, 1, 0, 2], vec![0, 1, 4]));
    }

    #[test]
    fn nan_equals_nothing() {
        let (nan, inf) = (f32::NAN, f32::INFINITY);
        let positions = [[nan, 0.0, 0.0], [nan, 0.0, 0.0], [inf; 3], [inf; 3], [-inf; 3], [nan, 0.0, 0.0]];
        assert_eq!(weld(&positions).unwrap().target, [0, 1, 2, 2, 3, 4]);
    }

    #[test]
    fn nothing_to_weld() {
        assert_eq!(weld(&[]), Ok(Welded { target: vec![], source: vec![] }));
        assert_eq!(weld(&[[f32::NAN; 3]]).unwrap().target, [0]);
    }

    #[test]
    fn the_first_of_equal_positions_is_kept_to_the_bit() {
        let positions = [[-0.0f32, 1.0, 0.0], [0.0, 1.0, -0.0]];
        let mut target = [7; 2];
        let welded = weld_into(&mut target, |v| positions[v]).unwrap();
        assert_eq!((target, welded.len()), ([0, 0], 1));
        assert_eq!(welded[0].map(f32::to_bits), positions[0].map(f32::to_bits));
    }
}

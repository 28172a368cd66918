//! The meshes that the laws are tried on.
mod defects;
mod manifolds;
mod surfaces;

use super::Case;
use alloc::vec::Vec;

pub use surfaces::torus;

/// Every case: small meshes, each with one thing that a backend may get wrong, and all their elements counted by
/// hand.
pub fn corpus() -> Vec<Case> {
    let mut cases = manifolds::cases();
    cases.extend(surfaces::cases());
    cases.extend(defects::cases());
    cases
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::conformance::{
        Flaw,
        slow::{FaceList, Slow},
    };
    use alloc::collections::BTreeSet;

    #[test]
    fn names_are_unique() {
        let names: BTreeSet<_> = corpus().iter().map(|case| case.name).collect();
        assert_eq!(names.len(), corpus().len());
    }

    #[test]
    fn hand_counts_agree_with_a_search() {
        for case in corpus().iter().filter(|case| case.refusal(&Flaw::ALL[1..]).is_none()) {
            let slow = Slow::of(&FaceList { vertices: case.vertices, faces: &case.faces });
            assert_eq!(slow.edges().len(), case.edges, "{}: edges", case.name);
            let curves = case.curves.unwrap_or(slow.curve_count());
            assert_eq!(slow.curve_count(), curves, "{}: curves", case.name);
        }
    }

    #[test]
    fn flaws_are_those_that_a_search_finds() {
        for case in corpus().iter().filter(|case| case.refusal(&Flaw::ALL[1..]).is_none()) {
            let slow = Slow::of(&FaceList { vertices: case.vertices, faces: &case.faces });
            let mut sides = 0..slow.sides.len();
            let found = [
                false,
                sides.clone().any(|i| slow.sides[i].from == slow.sides[i].to),
                sides.clone().any(|i| slow.sides[i].along.len() > 2),
                sides.any(|i| slow.is_same_direction(i)),
                (0..case.vertices).any(|v| slow.fans(v).len() > 1),
            ];
            for (flaw, found) in Flaw::ALL.into_iter().zip(found) {
                let listed = case.flaws.iter().any(|&(listed, _)| listed == flaw);
                assert_eq!(listed, found, "{}: {flaw:?}", case.name);
            }
        }
    }
}

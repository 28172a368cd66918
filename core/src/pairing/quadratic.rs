//! Compares each half-edge with all before it.
use super::{Paired, Pairing, joiner::Joiner};
use crate::{BuildError, HalfEdgeId, Slot, corner};
use alloc::vec::Vec;

pub(super) fn pair(faces: &[[u32; 3]], table: Vec<Slot<HalfEdgeId>>) -> Result<Paired, BuildError> {
    let mut joiner = Joiner::new(faces, table);
    for h in 0..3 * faces.len() {
        let (a, b) = (corner::origin(faces, h), corner::target(faces, h));
        let root = (0..h).find(|&g| {
            let (c, d) = (corner::origin(faces, g), corner::target(faces, g));
            (a, b) == (d, c) || (a, b) == (c, d)
        });
        if let Some(root) = root {
            joiner.join(root, h)?;
        }
    }
    joiner.finish(Pairing::Quadratic)
}

//! Compares each half-edge with all before it.
use super::{Paired, joiner::Joiner};
use crate::{BuildError, corner};

pub(super) fn pair(faces: &[[u32; 3]]) -> Result<Paired, BuildError> {
    let mut joiner = Joiner::new(faces)?;
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
    joiner.finish()
}

//! A hash map from edge to root. FxHash does not withstand chosen keys: it is never what `Auto` takes for an
//! input that a table over its vertices can serve.
use super::{Paired, joiner::Joiner};
use crate::{BuildError, corner};
use fxhash::FxBuildHasher;
use hashbrown::{HashMap, hash_map::Entry};

pub(super) fn pair(faces: &[[u32; 3]]) -> Result<Paired, BuildError> {
    let mut joiner = Joiner::new(faces)?;
    let mut roots: HashMap<(u32, u32), u32, FxBuildHasher> = HashMap::default();
    let expected = 3 * faces.len() / 2;
    let failed = |_| BuildError::OutOfMemory { bytes: expected.saturating_mul(12) };
    roots.try_reserve(expected).map_err(failed)?;
    for h in 0..3 * faces.len() {
        let (a, b) = (corner::origin(faces, h), corner::target(faces, h));
        match roots.entry((a.min(b), a.max(b))) {
            Entry::Occupied(root) => joiner.join(*root.get() as usize, h),
            Entry::Vacant(none) => {
                none.insert(h as u32);
            }
        }
    }
    Ok(joiner.finish())
}

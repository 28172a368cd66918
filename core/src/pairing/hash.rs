//! A hash map from edge to root. FxHash does not withstand chosen keys, so `Auto` never takes this.
use super::{Paired, Pairing, joiner::Joiner};
use crate::{BuildError, HalfEdgeId, Slot, corner};
use alloc::vec::Vec;
use fxhash::FxBuildHasher;
use hashbrown::{HashMap, hash_map::Entry};

pub(super) fn pair(faces: &[[u32; 3]], table: Vec<Slot<HalfEdgeId>>) -> Result<Paired, BuildError> {
    let mut joiner = Joiner::new(faces, table);
    let mut roots: HashMap<(u32, u32), u32, FxBuildHasher> = HashMap::default();
    // A closed mesh has so many edges; one with a boundary has more, up to twice as many.
    let mut room = 3 * faces.len() / 2;
    for h in 0..3 * faces.len() {
        if roots.len() == roots.capacity() {
            let failed = |_| BuildError::OutOfMemory { bytes: room.saturating_mul(24) };
            roots.try_reserve(room).map_err(failed)?;
            room = room / 4 + 1;
        }
        let (a, b) = (corner::origin(faces, h), corner::target(faces, h));
        match roots.entry((a.min(b), a.max(b))) {
            Entry::Occupied(root) => joiner.join(*root.get() as usize, h)?,
            Entry::Vacant(none) => {
                none.insert(h as u32);
            }
        }
    }
    joiner.finish(Pairing::Hash)
}

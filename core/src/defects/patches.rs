//! Patches: the triangles that hang together by edges of exactly two. A patch is what can be oriented; at an
//! edge of three triangles no orientation is right.
//!
//! [`turned`](crate::orientation::turned) answers for a whole mesh, and not at all where one patch cannot be
//! oriented; here every patch counts.

use super::sheets::Sheets;
use crate::disjoint_sets::{Joined, ParitySets};
use crate::{BuildError, FaceId, Handle, Map, Topology, memory};
use alloc::vec::Vec;

/// The figures of the patches.
pub(crate) struct Patches {
    pub(crate) count: usize,
    /// The least triangle of every patch that cannot be oriented, rising.
    pub(crate) nonorientable: Vec<FaceId>,
    pub(crate) min_flips: usize,
}

impl Patches {
    /// Near-linear in the edges.
    pub(crate) fn of(sheets: &Sheets) -> Result<Self, BuildError> {
        let mut patches = ParitySets::new(sheets.face_count())?;
        let mut torn = Vec::new();
        for (h, g) in sheets.paired() {
            patches.join(sheets.face(h), sheets.face(g), false);
        }
        for (h, g) in sheets.inconsistent() {
            if patches.join(sheets.face(h), sheets.face(g), true) == Joined::Contradicted {
                memory::push(&mut torn, sheets.face(h))?;
            }
        }
        let mut nonorientable = torn;
        nonorientable.iter_mut().for_each(|t| *t = patches.least(*t).0);
        nonorientable.sort_unstable();
        nonorientable.dedup();
        let tally = tally(&mut patches, sheets.face_count())?;
        let orientable = tally.iter().filter(|(first, _)| nonorientable.binary_search(first).is_err());
        let min_flips = orientable.map(|(_, &[even, odd])| even.min(odd) as usize).sum();
        Ok(Self { count: patches.count(), nonorientable, min_flips })
    }
}

/// How many triangles of each patch are even and odd; zeros where a triangle is not the least of its patch.
pub(crate) fn tally(
    patches: &mut ParitySets<FaceId>,
    faces: usize,
) -> Result<Map<FaceId, [u32; 2]>, BuildError> {
    let mut tally: Map<FaceId, [u32; 2]> = memory::filled(faces, [0; 2])?.into();
    for t in (0..faces).map(FaceId::new) {
        let (first, odd) = patches.least(t);
        tally[first][usize::from(odd)] += 1;
    }
    Ok(tally)
}

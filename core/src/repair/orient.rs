//! Orienting patches with the fewest flips.

use crate::defects::patches::tally;
use crate::defects::sheets::Sheets;
use crate::disjoint_sets::{Joined, ParitySets};
use crate::{BuildError, FaceId, HalfEdgeId, Handle, Map, Topology, memory};
use alloc::vec::Vec;

/// Which triangles to flip, and how many edges cannot be made consistent: the seams.
pub(crate) struct Orientation {
    pub(crate) flip: Map<FaceId, bool>,
    pub(crate) seam_edges: usize,
}

impl Orientation {
    /// Near-linear in the edges.
    ///
    /// Edges that are consistent as they stand are joined first: where a patch cannot be oriented, a seam that
    /// is there already is kept, and no other one torn open. In each patch the lesser part is flipped; of two
    /// equal halves, the one without the patch's first triangle.
    pub(crate) fn of(sheets: &Sheets) -> Result<Self, BuildError> {
        let mut patches = ParitySets::new(sheets.face_count())?;
        for (h, g) in sheets.paired() {
            patches.join(sheets.face(h), sheets.face(g), false);
        }
        let mut inconsistent = Vec::new();
        for (h, g) in sheets.inconsistent() {
            memory::push(&mut inconsistent, (sheets.ends(h), h, g))?;
        }
        // By their vertices: where the seams of a patch run shall not depend on the order of the faces.
        inconsistent.sort_unstable();
        let mut is_torn = |h, g| patches.join(sheets.face(h), sheets.face(g), true) == Joined::Contradicted;
        let seam_edges = inconsistent.into_iter().filter(|&(_, h, g)| is_torn(h, g)).count();
        let tally = tally(&mut patches, sheets.face_count())?;
        let flip = (0..sheets.face_count()).map(|f| {
            let f = FaceId::new(f);
            let (first, odd) = patches.least(f);
            let [even_count, odd_count] = tally[first];
            odd == (odd_count <= even_count)
        });
        Ok(Self { flip: memory::collected(flip)?.into(), seam_edges })
    }

    /// The couples of half-edges that will be consistent: the edges of two triangles but the seams.
    pub(crate) fn couples(&self, sheets: &Sheets) -> impl Iterator<Item = (HalfEdgeId, HalfEdgeId)> {
        let turns =
            move |&(h, g): &(HalfEdgeId, HalfEdgeId)| self.flip[sheets.face(h)] != self.flip[sheets.face(g)];
        // What was consistent before is flipped together or not at all.
        sheets.paired().chain(sheets.inconsistent().filter(turns))
    }

    /// The triangles to flip, rising.
    pub(crate) fn flipped(&self) -> Result<Vec<FaceId>, BuildError> {
        let mut flipped = Vec::new();
        for (f, _) in self.flip.iter().filter(|&(_, &flip)| flip) {
            memory::push(&mut flipped, f)?;
        }
        Ok(flipped)
    }
}

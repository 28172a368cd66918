//! Triangles with the same three vertices.

use super::sheets::Sheets;
use crate::{BuildError, FaceId, HalfEdgeId, Topology, VertexId, memory};
use alloc::vec::Vec;
use smallvec::SmallVec;

/// The triangles whose vertex set an earlier one has.
pub(crate) struct Duplicates {
    /// Rising.
    pub(crate) copies: Vec<FaceId>,
    /// How many of them repeat the cyclic order of an earlier one too.
    pub(crate) same_orientation: usize,
}

impl Duplicates {
    /// Compares triangles at the edge of their two lowest vertices only, so each once. O(edges), and
    /// O(d log d) for an edge of d triangles.
    pub(crate) fn find(sheets: &Sheets) -> Result<Self, BuildError> {
        let mut found = Self { copies: Vec::new(), same_orientation: 0 };
        for (h, g) in sheets.paired().filter(|&(h, g)| apex(sheets, h) == apex(sheets, g)) {
            found.compare_at(sheets, &[h, g])?;
        }
        sheets.irregular().try_for_each(|edge| found.compare_at(sheets, edge))?;
        found.copies.sort_unstable();
        Ok(found)
    }

    fn compare_at(&mut self, sheets: &Sheets, edge: &[HalfEdgeId]) -> Result<(), BuildError> {
        let [lower, higher] = sheets.ends(edge[0]);
        let apices = edge.iter().map(|&h| (apex(sheets, h), h));
        let mut above: SmallVec<[(VertexId, HalfEdgeId); 4]> = SmallVec::new();
        let failed = |_| BuildError::OutOfMemory { bytes: size_of_val(edge).saturating_mul(2) };
        above.try_reserve_exact(edge.len()).map_err(failed)?;
        above.extend(apices.filter(|&(a, _)| a > higher));
        above.sort_unstable();
        for group in above.chunk_by(|a, b| a.0 == b.0) {
            let mut seen = [false; 2];
            for &(_, g) in group {
                if seen != [false; 2] {
                    memory::push(&mut self.copies, sheets.face(g))?;
                }
                let seen = &mut seen[usize::from(sheets.origin(g) == lower)];
                self.same_orientation += usize::from(*seen);
                *seen = true;
            }
        }
        Ok(())
    }
}

/// The vertex across from `h` in its triangle.
#[inline]
fn apex(sheets: &Sheets, h: HalfEdgeId) -> VertexId {
    sheets.origin(sheets.prev(h))
}

//! The elements at fault, by name.

use super::sheets::Sheets;
use crate::{BuildError, HalfEdgeId, Topology, memory};
use alloc::vec::Vec;
use core::ops::Range;

/// The elements behind the figures of [`Defects`](super::Defects): faces by their place in the list that was
/// given, vertices by number, all rising. O(faces) in memory, whatever the vertex count.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct DefectLists {
    /// Faces that name a vertex beyond the vertex count.
    pub out_of_range_faces: Vec<u32>,
    /// Faces that name a vertex twice.
    pub degenerate_faces: Vec<u32>,
    /// Faces whose vertex set an earlier one has.
    pub duplicate_faces: Vec<u32>,
    /// The first face of each patch that cannot be oriented.
    pub nonorientable_patches: Vec<u32>,
    /// Edges of three or more faces, the lower vertex first.
    pub nonmanifold_edges: Vec<[u32; 2]>,
    /// Edges of two faces that run the same way, the lower vertex first.
    pub inconsistent_edges: Vec<[u32; 2]>,
    /// Directed edges of two or more faces, as origin and target.
    pub repeated_halfedges: Vec<[u32; 2]>,
    /// Vertices of several fans.
    pub bowtie_vertices: Vec<u32>,
    /// Vertices that are bowties or touch an edge of three or more faces.
    pub nonmanifold_vertices: Vec<u32>,
    /// Vertices in no face but degenerate ones, as runs: there may be far more of them than memory holds.
    pub isolated_vertices: Vec<Range<usize>>,
}

/// The irregular edges, by what is wrong with them.
#[derive(Default)]
pub(crate) struct EdgeFaults {
    pub(crate) nonmanifold: Vec<[u32; 2]>,
    pub(crate) inconsistent: Vec<[u32; 2]>,
    pub(crate) repeated: Vec<[u32; 2]>,
}

impl EdgeFaults {
    /// O(d log d) for d of them.
    pub(crate) fn of(sheets: &Sheets) -> Result<Self, BuildError> {
        let mut faults = Self::default();
        sheets.irregular().try_for_each(|edge| faults.add(sheets, edge))?;
        for list in [&mut faults.nonmanifold, &mut faults.inconsistent, &mut faults.repeated] {
            list.sort_unstable();
        }
        Ok(faults)
    }

    fn add(&mut self, sheets: &Sheets, edge: &[HalfEdgeId]) -> Result<(), BuildError> {
        let ends = sheets.ends(edge[0]);
        let [a, b] = ends.map(|slot| sheets.triangles.vertex(slot));
        let at_fault = if edge.len() > 2 { &mut self.nonmanifold } else { &mut self.inconsistent };
        memory::push(at_fault, [a, b])?;
        let rising = edge.iter().filter(|&&h| sheets.origin(h) == ends[0]).count();
        for (count, run) in [(rising, [a, b]), (edge.len() - rising, [b, a])] {
            if count > 1 {
                memory::push(&mut self.repeated, run)?;
            }
        }
        Ok(())
    }
}

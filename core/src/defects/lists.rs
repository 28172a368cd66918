//! The elements at fault, by name.

use super::edges::EdgeTable;
use super::triangles::Triangles;
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

/// The figures of the edges, and the ones at fault.
#[derive(Default)]
pub(crate) struct EdgeFaults {
    pub(crate) boundary: usize,
    pub(crate) max_faces: usize,
    pub(crate) nonmanifold: Vec<[u32; 2]>,
    pub(crate) inconsistent: Vec<[u32; 2]>,
    pub(crate) repeated: Vec<[u32; 2]>,
}

impl EdgeFaults {
    /// O(half-edges).
    pub(crate) fn of(edges: &EdgeTable, triangles: &Triangles) -> Self {
        let mut faults = Self::default();
        for edge in edges.iter(triangles) {
            let (a, b) = edge.ends();
            let (a, b) = (triangles.vertex(a), triangles.vertex(b));
            let count = edge.sides.len();
            let rising = edge.sides.iter().filter(|&&side| edge.rises(side)).count();
            faults.max_faces = faults.max_faces.max(count);
            faults.boundary += usize::from(count == 1);
            if count > 2 {
                faults.nonmanifold.push([a, b]);
            }
            if count == 2 && rising != 1 {
                faults.inconsistent.push([a, b]);
            }
            if rising > 1 {
                faults.repeated.push([a, b]);
            }
            if count - rising > 1 {
                faults.repeated.push([b, a]);
            }
        }
        // Falling ones came up beside the rising ones of their edge.
        faults.repeated.sort_unstable();
        faults
    }
}

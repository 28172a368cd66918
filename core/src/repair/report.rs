//! What a repair did.

use alloc::vec::Vec;
use core::fmt;

/// A mesh that every backend accepts, what was done to get there, and the maps back.
///
/// Faces and vertices "of the list" are those that went into [`repair`](super::repair).
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Repaired {
    /// How many vertices there are, isolated ones included.
    pub vertex_count: usize,
    /// The faces, in the order of the list.
    pub faces: Vec<[u32; 3]>,
    /// For each face the one of the list that it was; rising.
    pub face_source: Vec<u32>,
    /// For each vertex the one of the list that it was, or is a copy of. Uncopied ones come first, rising: without
    /// welding they keep their numbers.
    pub vertex_source: Vec<u32>,
    /// Faces of the list that were flipped: `[a, b, c]` to `[a, c, b]`. Rising.
    pub flipped: Vec<u32>,
    /// Faces of the list that are gone.
    pub dropped: Dropped,
    /// How many vertices welding took away.
    pub vertices_welded: usize,
    /// Edges of the list whose faces no longer share one edge.
    pub edges_cut: usize,
    /// Those of them that had two faces and could not be made consistent: the seams of patches that have no
    /// orientation.
    pub seam_edges: usize,
    /// Vertices of the list (after welding) that were copied.
    pub vertices_cut: usize,
    /// How many copies were made of them.
    pub vertices_added: usize,
}

/// Faces of the list that a repair took away, by why; rising. Each is in one of the lists.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[non_exhaustive]
pub struct Dropped {
    /// They named a vertex beyond the vertex count.
    pub out_of_range: Vec<u32>,
    /// They named a vertex twice, after welding.
    pub degenerate: Vec<u32>,
    /// An earlier face had the same three vertices, in whatever order.
    pub duplicate: Vec<u32>,
}

impl Dropped {
    /// How many faces were dropped.
    pub fn count(&self) -> usize {
        self.out_of_range.len() + self.degenerate.len() + self.duplicate.len()
    }
}

impl Repaired {
    /// Whether the mesh is what was given.
    pub fn is_unchanged(&self) -> bool {
        self.steps().iter().all(|&(count, ..)| count == 0)
    }

    /// The values of the list's vertices (positions, colours, ...) for the new ones. O(vertices).
    ///
    /// # Panics
    /// If `values` has fewer than the list had vertices.
    pub fn carry_vertices<T: Clone>(&self, values: &[T]) -> Vec<T> {
        self.vertex_source.iter().map(|&v| values[v as usize].clone()).collect()
    }

    /// The values of the list's faces for the new ones. O(faces).
    ///
    /// # Panics
    /// If `values` has fewer than the list had faces.
    pub fn carry_faces<T: Clone>(&self, values: &[T]) -> Vec<T> {
        self.face_source.iter().map(|&f| values[f as usize].clone()).collect()
    }

    fn steps(&self) -> [(usize, [&'static str; 2], &'static str); 8] {
        let (vertices, faces) = (["vertex", "vertices"], ["face", "faces"]);
        let (out_of_range, degenerate) =
            (["out-of-range face", "out-of-range faces"], ["degenerate face", "degenerate faces"]);
        let dropped = &self.dropped;
        [
            (self.vertices_welded, vertices, "welded away"),
            (dropped.out_of_range.len(), out_of_range, "dropped"),
            (dropped.degenerate.len(), degenerate, "dropped"),
            (dropped.duplicate.len(), ["duplicate face", "duplicate faces"], "dropped"),
            (self.flipped.len(), faces, "flipped"),
            (self.edges_cut, ["edge", "edges"], "cut"),
            (self.vertices_cut, vertices, "cut"),
            (self.vertices_added, vertices, "added"),
        ]
    }
}

/// One line: `nothing to repair`, or what was done, with how many of each.
impl fmt::Display for Repaired {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_unchanged() {
            return f.write_str("nothing to repair");
        }
        let done = self.steps().into_iter().filter(|&(count, ..)| count > 0);
        for (i, (count, nouns, done)) in done.enumerate() {
            let separator = if i == 0 { "" } else { ", " };
            write!(f, "{separator}{count} {} {done}", nouns[usize::from(count != 1)])?;
        }
        Ok(())
    }
}

//! Which levels cross which faces, found in one pass over the faces.
use crate::{Map, Topology};
use alloc::{vec, vec::Vec};

/// For each vertex, how many levels are not above it: it is above level `k` where its rank is more than `k`.
pub(super) fn ranks<V: crate::Handle>(field: &Map<V, f32>, levels: &[f32]) -> Map<V, u32> {
    let rank = |&value: &f32| levels.partition_point(|&level| level <= value) as u32;
    field.as_slice().iter().map(rank).collect()
}

/// The faces that each level crosses, ascending: a counting sort, four bytes a segment.
pub(super) struct Buckets<F> {
    ends: Vec<usize>,
    faces: Vec<F>,
}

impl<F: crate::Handle> Buckets<F> {
    pub(super) fn new<M>(mesh: &M, ranks: &Map<M::Vertex, u32>, level_count: usize) -> Self
    where
        M: Topology<Face = F> + ?Sized,
    {
        let span = |f| {
            let [a, b, c] = mesh.face_vertices(f).map(|v| ranks[v] as usize);
            a.min(b).min(c)..a.max(b).max(c)
        };
        // Where each level starts; then, as it is filled, where it ends.
        let mut ends = vec![0; level_count + 1];
        mesh.faces().flat_map(span).for_each(|level| ends[level + 1] += 1);
        (0..level_count).for_each(|level| ends[level + 1] += ends[level]);
        let mut faces = vec![F::new(0); ends[level_count]];
        for f in mesh.faces() {
            for level in span(f) {
                faces[ends[level]] = f;
                ends[level] += 1;
            }
        }
        Self { ends, faces }
    }

    /// The faces that `level` crosses.
    pub(super) fn of(&self, level: usize) -> &[F] {
        let start = level.checked_sub(1).map_or(0, |before| self.ends[before]);
        &self.faces[start..self.ends[level]]
    }
}

//! The triangles and what meets at their edges, whatever that is.
//!
//! This is a [`Topology`] and no [`Adjacency`](crate::Adjacency): the public algorithms walk the fan of each edge.
//! When they marked half-edges to see each edge once, `Defects::of` over them took 1.9 times as long as this on an
//! isosurface of 963,000 faces, and three to four times as long where those are shuffled or flipped. The pairing tells
//! the couples of half-edges at once, so what is shared is the algorithms over couples.

use super::triangles::Triangles;
use crate::pairing::{self, EdgeRecords, Paired, Pairing};
use crate::{BuildError, FaceId, HalfEdgeId, Handle, Map, Slot, Topology, VertexId};

/// Triangles with their edges; 4 bytes for each half-edge beside the triangles.
pub(crate) struct Sheets {
    pub(crate) triangles: Triangles,
    /// The opposite; none on the boundary, and the half-edge itself along an irregular edge.
    opposite: Map<HalfEdgeId, Slot<HalfEdgeId>>,
    irregular: EdgeRecords,
}

impl Sheets {
    /// Pairs the half-edges, as every backend does.
    pub(crate) fn join(triangles: Triangles) -> Result<Self, BuildError> {
        let Paired { opposite, irregular, .. } =
            pairing::pair(triangles.vertex_bound, &triangles.faces, Pairing::Auto)?;
        let mut opposite: Map<HalfEdgeId, _> = opposite.into();
        irregular.iter().flatten().for_each(|&h| opposite[h] = Slot::some(h));
        Ok(Self { triangles, opposite, irregular })
    }

    /// The triangles alone; the memory of the edges is free then.
    pub(crate) fn into_triangles(self) -> Triangles {
        self.triangles
    }

    /// The edges of one triangle.
    pub(crate) fn alone(&self) -> impl Iterator<Item = HalfEdgeId> {
        self.opposite.iter().filter(|(_, opposite)| opposite.get().is_none()).map(|(h, _)| h)
    }

    /// The edges of two triangles that run in opposite directions, as they should; the less half-edge first.
    pub(crate) fn paired(&self) -> impl Iterator<Item = (HalfEdgeId, HalfEdgeId)> {
        self.opposite.iter().filter_map(|(h, opposite)| Some((h, opposite.get().filter(|&g| g > h)?)))
    }

    /// The edges of three or more triangles, or of two that run in the same direction.
    pub(crate) fn irregular(&self) -> impl Iterator<Item = &[HalfEdgeId]> {
        self.irregular.iter()
    }

    /// The edges of two triangles that run in the same direction.
    pub(crate) fn inconsistent(&self) -> impl Iterator<Item = (HalfEdgeId, HalfEdgeId)> {
        self.irregular().filter_map(|edge| <[_; 2]>::try_from(edge).ok()).map(|[h, g]| (h, g))
    }

    /// What hangs together along an edge, however many triangles it has.
    pub(crate) fn couples(&self) -> impl Iterator<Item = (HalfEdgeId, HalfEdgeId)> {
        self.paired().chain(self.irregular().flat_map(|edge| edge.windows(2).map(|two| (two[0], two[1]))))
    }

    /// One half-edge along each edge.
    pub(crate) fn edges(&self) -> impl Iterator<Item = HalfEdgeId> {
        self.alone().chain(self.paired().map(|(h, _)| h)).chain(self.irregular().map(|edge| edge[0]))
    }

    /// The most triangles that an edge has.
    pub(crate) fn max_faces_per_edge(&self) -> usize {
        let regular = if self.paired().next().is_some() { 2 } else { self.face_count().min(1) };
        self.irregular().map(<[_]>::len).fold(regular, usize::max)
    }

    /// The vertices at both ends of `h`, the lower one first.
    #[inline]
    pub(crate) fn ends(&self, h: HalfEdgeId) -> [VertexId; 2] {
        let (a, b) = (self.origin(h), self.target(h));
        [a.min(b), a.max(b)]
    }
}

impl Topology for Sheets {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    fn vertex_count(&self) -> usize {
        self.triangles.vertex_bound
    }

    fn face_count(&self) -> usize {
        self.triangles.faces.len()
    }

    #[inline(always)]
    fn origin(&self, h: HalfEdgeId) -> VertexId {
        VertexId::new(self.triangles.faces.as_flattened()[h.index()] as usize)
    }
}

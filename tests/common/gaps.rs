//! A mesh whose half-edges have numbers with gaps, and none that follows from its face.
use onering::{
    BuildError, FaceId, FromFaces, HalfEdgeId, Handle, Pairing, SharedVertex, Topology, VertexId, corner,
};
use std::borrow::Cow;

/// Half-edges count down from the last face to the first, four numbers a face, of which one is no half-edge.
#[derive(Clone, Debug)]
pub(crate) struct Gaps(SharedVertex);

impl Gaps {
    fn corner(&self, h: HalfEdgeId) -> HalfEdgeId {
        let (f, k) = (h.index() / 4, h.index() % 4);
        assert_ne!(k, 0, "{h:?} is a gap");
        HalfEdgeId::new(3 * (self.face_count() - 1 - f) + k - 1)
    }

    fn name(&self, h: HalfEdgeId) -> HalfEdgeId {
        let (f, k) = (h.index() / 3, h.index() % 3);
        HalfEdgeId::new(4 * (self.face_count() - 1 - f) + k + 1)
    }
}

impl FromFaces for Gaps {
    fn build(n: usize, faces: Cow<'_, [[u32; 3]]>, pairing: Pairing) -> Result<Self, BuildError> {
        SharedVertex::build(n, faces, pairing).map(Gaps)
    }
}

impl Topology for Gaps {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    fn vertex_count(&self) -> usize {
        self.0.vertex_count()
    }

    fn face_count(&self) -> usize {
        self.0.face_count()
    }

    fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.0.origin(self.corner(h))
    }

    fn next(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.name(corner::next(self.corner(h)))
    }

    fn prev(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.name(corner::prev(self.corner(h)))
    }

    fn face(&self, h: HalfEdgeId) -> FaceId {
        corner::face(self.corner(h))
    }

    fn first(&self, f: FaceId) -> HalfEdgeId {
        self.name(corner::first(f))
    }

    fn half_edge_bound(&self) -> usize {
        4 * self.face_count()
    }

    fn half_edges(&self) -> impl Iterator<Item = HalfEdgeId> {
        (0..self.half_edge_bound()).filter(|h| h % 4 != 0).map(HalfEdgeId::new)
    }
}

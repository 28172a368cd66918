//! A table taken at its links' word, to check the rest of it by walks.
use super::Table;
use crate::build;
use crate::column::Cells;
use crate::layout::Layout;
use crate::link::Link;
use crate::storage::Storage;
use onering_core::{Adjacency, FaceId, HalfEdgeId, Topology, VertexId};

/// The table with what its links say, whether or not the row is known to have any.
pub(super) struct Linked<'a, L: Layout, S: Storage>(pub(super) &'a Table<L, S>);

impl<L: Layout, S: Storage> Topology for Linked<'_, L, S> {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    fn vertex_count(&self) -> usize {
        self.0.vertex_count
    }

    fn face_count(&self) -> usize {
        self.0.face_count
    }

    #[inline(always)]
    fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.0.origin(h)
    }

    #[inline(always)]
    fn target(&self, h: HalfEdgeId) -> VertexId {
        self.0.target(h)
    }
}

impl<L: Layout, S: Storage> Adjacency for Linked<'_, L, S> {
    #[inline(always)]
    fn opposite(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.0.link_if_any(h).half_edge()
    }

    #[inline]
    fn edge_fan(&self, h: HalfEdgeId) -> impl Iterator<Item = HalfEdgeId> {
        let words = self.0.edge_records.as_slice();
        let record = self.0.edge_place(h).map_or(&[][..], |place| build::record(words, place));
        let others = build::half_edges(record).filter(move |&g| g != h);
        core::iter::once(h).chain(self.opposite(h)).chain(others)
    }

    #[inline]
    fn is_boundary(&self, h: HalfEdgeId) -> bool {
        self.opposite(h).is_none() && self.0.edge_place(h).is_none()
    }
}

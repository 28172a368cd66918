//! [`HalfEdgeMesh`]: the half-edge structure, with everything stored.
use crate::build::{self, Links};
use crate::check::{self, Checked};
use crate::columns::{Column, Columns, FromColumns, Invalid, Source};
use crate::storage::{Owned, Storage};
use alloc::{borrow::Cow, vec, vec::Vec};
use bytemuck::{Pod, Zeroable};
use core::fmt;
use onering_core::footprint::{Bytes, Footprint};
use onering_core::{
    Adjacency, BuildError, FaceId, FromFaces, HalfEdgeId, Handle, Incidence, Pairing, Slot, Topology,
    VertexId, corner,
    memory::{self, Spare},
    pairing,
};

/// What a half-edge knows. One record, so that a step reads one cache line.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
struct Record {
    vertex: VertexId,
    next: HalfEdgeId,
    prev: HalfEdgeId,
    opposite: Slot<HalfEdgeId>,
    face: FaceId,
}

const _: () = assert!(size_of::<Record>() == 20);

/// The half-edge structure (Mäntylä 1988; Emme 2012, 3.3): for each half-edge a record of its vertex (the one
/// that it starts at), next, previous, opposite and face; for each vertex the half-edge where its fan starts.
///
/// Nothing is worked out from an index but the first half-edge of a face, `3f`, where faces would have a
/// reference of their own. Degenerate faces, edges of three or more faces, faces that disagree in orientation
/// and vertices of several fans are refused. Up to 2^32 - 2 half-edges.
#[derive(Clone)]
pub struct HalfEdgeMesh<S: Storage = Owned> {
    records: S::Slice<Record>,
    outgoing: S::Slice<Slot<HalfEdgeId>>,
}

impl<S: Storage> HalfEdgeMesh<S> {
    #[inline(always)]
    fn record(&self, h: HalfEdgeId) -> &Record {
        &self.records[h.index()]
    }
}

impl<S: Storage> fmt::Debug for HalfEdgeMesh<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (vertices, faces) = (self.vertex_count(), self.face_count());
        write!(f, "HalfEdgeMesh {{ vertices: {vertices}, faces: {faces} }}")
    }
}

impl FromFaces for HalfEdgeMesh {
    fn build(vertex_count: usize, faces: Cow<'_, [[u32; 3]]>, pairing: Pairing) -> Result<Self, BuildError> {
        pairing::check_counts(vertex_count, faces.len(), HalfEdgeId::MAX_INDEX)?;
        let fresh = &mut Spare::default();
        let links: Links<Slot<HalfEdgeId>> = build::links(vertex_count, &faces, pairing, true, false, fresh)?;
        let record = |(h, &opposite): (usize, &Slot<HalfEdgeId>)| {
            let vertex = VertexId::new(corner::origin(&faces, h) as usize);
            let h = HalfEdgeId::new(h);
            Record { vertex, next: corner::next(h), prev: corner::prev(h), opposite, face: corner::face(h) }
        };
        let records = memory::collected(links.opposite.iter().enumerate().map(record))?;
        Ok(Self { records: records.into(), outgoing: links.outgoing.into() })
    }
}

impl Footprint for HalfEdgeMesh {
    const BYTES: Bytes = Bytes { vertex: 4, face: 60, ..Bytes::NONE };

    fn heap_bytes(&self) -> usize {
        size_of_val(&*self.records) + size_of_val(&*self.outgoing)
    }
}

impl<S: Storage> Topology for HalfEdgeMesh<S> {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    #[inline(always)]
    fn vertex_count(&self) -> usize {
        self.outgoing.len()
    }

    #[inline(always)]
    fn face_count(&self) -> usize {
        self.records.len() / 3
    }

    #[inline(always)]
    fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.record(h).vertex
    }

    #[inline(always)]
    fn next(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.record(h).next
    }

    #[inline(always)]
    fn prev(&self, h: HalfEdgeId) -> HalfEdgeId {
        self.record(h).prev
    }

    #[inline(always)]
    fn face(&self, h: HalfEdgeId) -> FaceId {
        self.record(h).face
    }
}

impl<S: Storage> Adjacency for HalfEdgeMesh<S> {
    #[inline(always)]
    fn opposite(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.record(h).opposite.get()
    }
}

impl<S: Storage> Incidence for HalfEdgeMesh<S> {
    #[inline(always)]
    fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId> {
        self.outgoing[v.index()].get()
    }
}

impl<S: Storage> Columns for HalfEdgeMesh<S> {
    fn backend(&self) -> Cow<'static, str> {
        Self::backend_name()
    }

    fn counts(&self) -> (usize, usize) {
        (self.outgoing.len(), self.records.len() / 3)
    }

    fn columns(&self) -> Vec<Column<'_>> {
        vec![Column::new("records", &self.records), Column::new("outgoing", &self.outgoing)]
    }

    fn validate(&self) -> Checked {
        let (vertices, half_edges) = (self.outgoing.len(), self.records.len());
        let exists = |h: HalfEdgeId| h.index() < half_edges;
        for (i, record) in self.records.iter().enumerate() {
            let h = HalfEdgeId::new(i);
            let face: FaceId = corner::face(h);
            let is_corner =
                (record.next, record.prev, record.face) == (corner::next(h), corner::prev(h), face);
            if !is_corner || record.vertex.index() >= vertices || !record.opposite.get().is_none_or(exists) {
                return Err(Invalid::element("records", i, "is not a half-edge between others of its face"));
            }
        }
        if let Some(f) = self.faces().find(|&f| !check::is_proper(self.face_vertices(f))) {
            return Err(Invalid::element("records", 3 * f.index(), check::DEGENERATE));
        }
        check::opposites(self, "records")?;
        check::slots("outgoing", &self.outgoing, half_edges)?;
        check::fans(self, "outgoing", |v| self.fans(v))
    }
}

impl<S: Storage> FromColumns for HalfEdgeMesh<S> {
    type Over<T: Storage> = HalfEdgeMesh<T>;

    fn backend_name() -> Cow<'static, str> {
        Cow::Borrowed("half-edge")
    }

    fn from_columns<T: Storage>(source: &impl Source<T>) -> Result<HalfEdgeMesh<T>, Invalid> {
        let (vertex_count, face_count) = (source.vertex_count(), source.face_count());
        pairing::check_counts(vertex_count, face_count, HalfEdgeId::MAX_INDEX)?;
        Ok(HalfEdgeMesh {
            records: source.column("records", Some(3 * face_count))?,
            outgoing: source.column("outgoing", Some(vertex_count))?,
        })
    }
}

//! The columns of [`WingedEdge`], and what is checked of them.
use super::{Edge, WingedEdge, check_handles};
use crate::check::{self, Checked};
use crate::columns::{Column, Columns, FromColumns, Invalid, Source};
use crate::storage::Storage;
use alloc::{borrow::Cow, vec, vec::Vec};
use onering_core::{EdgeId, FaceId, HalfEdgeId, Handle, Incidence, Slot, Topology, pairing};

impl<S: Storage> Columns for WingedEdge<S> {
    fn backend(&self) -> Cow<'static, str> {
        Self::backend_name()
    }

    fn counts(&self) -> (usize, usize) {
        (self.vertices.len(), self.faces.len())
    }

    fn columns(&self) -> Vec<Column<'_>> {
        vec![
            Column::new("edges", &self.edges),
            Column::new("vertices", &self.vertices),
            Column::new("faces", &self.faces),
        ]
    }

    fn validate(&self) -> Checked {
        self.check_edges()?;
        self.check_faces()?;
        self.check_vertices()?;
        check::fans(self, "vertices", |v| self.fans(v))
    }
}

impl<S: Storage> FromColumns for WingedEdge<S> {
    type Over<T: Storage> = WingedEdge<T>;

    fn backend_name() -> Cow<'static, str> {
        Cow::Borrowed("winged-edge")
    }

    fn from_columns<T: Storage>(source: &impl Source<T>) -> Result<WingedEdge<T>, Invalid> {
        let (vertex_count, face_count) = (source.vertex_count(), source.face_count());
        pairing::check_counts(vertex_count, face_count, HalfEdgeId::MAX_INDEX)?;
        let edges = source.column::<Edge>("edges", None)?;
        check_handles(edges.len())?;
        Ok(WingedEdge {
            edges,
            vertices: source.column("vertices", Some(vertex_count))?,
            faces: source.column("faces", Some(face_count))?,
        })
    }
}

impl<S: Storage> WingedEdge<S> {
    /// What an edge names exists, and a side has its next and previous edge just where it has a face.
    fn check_edges(&self) -> Checked {
        let (vertices, edges, faces) = (self.vertices.len(), self.edges.len(), self.faces.len());
        let exists = |e: Slot<EdgeId>| e.get().is_some_and(|e| e.index() < edges);
        let is_side = |edge: &Edge, side: usize| match edge.faces[side].get() {
            Some(f) => f.index() < faces && exists(edge.next[side]) && exists(edge.prev[side]),
            None => side == 1 && edge.next[1].get().is_none() && edge.prev[1].get().is_none(),
        };
        let is_edge = |edge: &Edge| {
            edge.vertices.iter().all(|v| v.index() < vertices)
                && edge.faces[0] != edge.faces[1]
                && is_side(edge, 0)
                && is_side(edge, 1)
        };
        match self.edges.iter().position(|edge| !is_edge(edge)) {
            Some(index) => Err(Invalid::element("edges", index, "has a side that does not exist")),
            None => Ok(()),
        }
    }

    /// Each face is three half-edges with three ends in a row, back and forth, and there are no half-edges besides.
    fn check_faces(&self) -> Checked {
        check::handles("faces", &self.faces, self.edges.len())?;
        for f in self.faces() {
            if !self.is_face(f) {
                return Err(Invalid::element("faces", f.index(), "is not a triangle of edges that name it"));
            }
        }
        if self.half_edges().count() == self.half_edge_count() {
            return Ok(());
        }
        Err(Invalid::column("edges", "has a side that is in no face"))
    }

    fn is_face(&self, f: FaceId) -> bool {
        let is_of = |h: HalfEdgeId| {
            let (edge, side) = self.side(h);
            edge.faces[side] == Slot::some(f)
        };
        // Each is known to be a side of the face before it is asked for the one after.
        let a = self.first(f);
        let Some(b) = is_of(a).then(|| self.next(a)) else { return false };
        let Some(c) = is_of(b).then(|| self.next(b)) else { return false };
        is_of(c)
            && [self.next(c), self.prev(a), self.prev(b), self.prev(c)] == [a, c, a, b]
            && [a, b, c].map(|h| self.target(h)) == [b, c, a].map(|h| self.origin(h))
            && check::is_proper([a, b, c].map(|h| self.origin(h)))
    }

    /// The edge of a vertex has a half-edge that starts there.
    fn check_vertices(&self) -> Checked {
        check::slots("vertices", &self.vertices, self.edges.len())?;
        let starts = |h: HalfEdgeId, v| {
            let (edge, side) = self.side(h);
            edge.vertices[side] == v && edge.faces[side].get().is_some()
        };
        let mut vertices = self.vertices();
        match vertices.find(|&v| self.outgoing(v).is_some_and(|h| !starts(h, v))) {
            Some(v) => {
                Err(Invalid::element("vertices", v.index(), "names an edge that does not start there"))
            }
            None => Ok(()),
        }
    }
}

//! [`WingedEdge`]: undirected edges that know what lies on both sides.
mod columns;

use crate::build::{self, Links};
use crate::storage::{Owned, Storage};
use alloc::borrow::Cow;
use bytemuck::{Pod, Zeroable};
use core::fmt;
use onering_core::footprint::{Bytes, Footprint};
use onering_core::{
    Adjacency, BuildError, EdgeId, EdgeMap, FaceId, FromFaces, HalfEdgeId, Handle, Incidence, Pairing, Slot,
    Topology, VertexId, corner,
    memory::{self, Spare},
    pairing,
};

/// What an edge knows. Side 0 runs from the first vertex to the second and always has a face.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
struct Edge {
    vertices: [VertexId; 2],
    faces: [Slot<FaceId>; 2],
    /// The edge after this one in the face of each side.
    next: [Slot<EdgeId>; 2],
    /// The edge before this one in the face of each side.
    prev: [Slot<EdgeId>; 2],
}

const _: () = assert!(size_of::<Edge>() == 32);

/// The winged-edge structure (Baumgart 1972; Emme 2012, 3.2): for each edge its two vertices, its two faces,
/// and its next and previous edge in each of these; for each vertex and each face one edge.
///
/// An edge does not say which way it is used, so each step asks on which side of the next edge the face lies:
/// the *orientation test*. A half-edge is side 0 or 1 of edge `e`, with the index `2e + side`. Side 1 of a
/// boundary edge has no face and is no half-edge: that index is a gap, which `half_edges` leaves out and
/// for which `next`, `prev` and `face` panic. [`edge`](EdgeMap::edge) is `h / 2`: O(1). Edges are in the order
/// of their first side in the face list.
///
/// Degenerate faces, edges of three or more faces, faces that disagree in orientation and vertices of several
/// fans are refused. Up to 2^31 - 1 edges: two indices for each have to be below 2^32 - 1, which for a
/// closed mesh are as many half-edges as of any other backend, but for separate triangles half as many.
#[derive(Clone)]
pub struct WingedEdge<S: Storage = Owned> {
    edges: S::Slice<Edge>,
    vertices: S::Slice<Slot<EdgeId>>,
    faces: S::Slice<EdgeId>,
}

impl<S: Storage> WingedEdge<S> {
    #[inline(always)]
    fn side(&self, h: HalfEdgeId) -> (&Edge, usize) {
        (&self.edges[h.index() / 2], h.index() % 2)
    }

    /// The orientation test: the side of `e` where `face` lies.
    #[inline(always)]
    fn along(&self, face: Slot<FaceId>, e: EdgeId) -> HalfEdgeId {
        let side = self.edges[e.index()].faces[0] != face;
        HalfEdgeId::new(2 * e.index() + usize::from(side))
    }
}

/// What is there, but for a gap.
#[inline(always)]
fn present<H: Handle>(slot: Slot<H>) -> H {
    match slot.get() {
        Some(h) => h,
        None => panic!("this side of the edge has no face"),
    }
}

/// Whether there are half-edge handles for so many edges.
fn check_handles(edge_count: usize) -> Result<(), BuildError> {
    let (half_edges, limit) = (edge_count.saturating_mul(2), HalfEdgeId::MAX_INDEX);
    if half_edges > limit { Err(BuildError::TooManyHalfEdges { half_edges, limit }) } else { Ok(()) }
}

impl<S: Storage> fmt::Debug for WingedEdge<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (vertices, edges, faces) = (self.vertices.len(), self.edges.len(), self.faces.len());
        write!(f, "WingedEdge {{ vertices: {vertices}, edges: {edges}, faces: {faces} }}")
    }
}

impl FromFaces for WingedEdge {
    fn build(vertex_count: usize, faces: Cow<'_, [[u32; 3]]>, pairing: Pairing) -> Result<Self, BuildError> {
        pairing::check_counts(vertex_count, faces.len(), HalfEdgeId::MAX_INDEX)?;
        let fresh = &mut Spare::default();
        let links: Links<Slot<HalfEdgeId>> = build::links(vertex_count, &faces, pairing, true, false, fresh)?;
        let list = links.edge_list(fresh)?;
        check_handles(list.len())?;
        let index = links.edge_index(fresh)?;
        let vertex = |v: u32| VertexId::new(v as usize);
        let edge = |&h: &HalfEdgeId| {
            let sides = [Slot::some(h), links.opposite[h.index()]];
            let edge_of = |h: HalfEdgeId| index[h.index()];
            Edge {
                vertices: [corner::origin(&faces, h.index()), corner::target(&faces, h.index())].map(vertex),
                faces: sides.map(|side| side.get().map(corner::face).into()),
                next: sides.map(|side| side.get().map(corner::next).map(edge_of).into()),
                prev: sides.map(|side| side.get().map(corner::prev).map(edge_of).into()),
            }
        };
        let of_vertex = |h: &Slot<HalfEdgeId>| Slot::from(h.get().map(|h| index[h.index()]));
        Ok(Self {
            edges: memory::collected(list.iter().map(edge))?.into(),
            vertices: memory::collected(links.outgoing.iter().map(of_vertex))?.into(),
            faces: memory::collected((0..faces.len()).map(|f| index[3 * f]))?.into(),
        })
    }
}

impl Footprint for WingedEdge {
    const BYTES: Bytes = Bytes { vertex: 4, edge: 32, face: 4, ..Bytes::NONE };

    fn heap_bytes(&self) -> usize {
        size_of_val(&*self.edges) + size_of_val(&*self.vertices) + size_of_val(&*self.faces)
    }
}

impl<S: Storage> Topology for WingedEdge<S> {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    #[inline(always)]
    fn vertex_count(&self) -> usize {
        self.vertices.len()
    }

    #[inline(always)]
    fn face_count(&self) -> usize {
        self.faces.len()
    }

    #[inline(always)]
    fn origin(&self, h: HalfEdgeId) -> VertexId {
        let (edge, side) = self.side(h);
        edge.vertices[side]
    }

    #[inline(always)]
    fn target(&self, h: HalfEdgeId) -> VertexId {
        let (edge, side) = self.side(h);
        edge.vertices[side ^ 1]
    }

    #[inline(always)]
    fn next(&self, h: HalfEdgeId) -> HalfEdgeId {
        let (edge, side) = self.side(h);
        self.along(edge.faces[side], present(edge.next[side]))
    }

    #[inline(always)]
    fn prev(&self, h: HalfEdgeId) -> HalfEdgeId {
        let (edge, side) = self.side(h);
        self.along(edge.faces[side], present(edge.prev[side]))
    }

    #[inline(always)]
    fn face(&self, h: HalfEdgeId) -> FaceId {
        let (edge, side) = self.side(h);
        present(edge.faces[side])
    }

    #[inline(always)]
    fn first(&self, f: FaceId) -> HalfEdgeId {
        self.along(Slot::some(f), self.faces[f.index()])
    }

    fn half_edge_bound(&self) -> usize {
        2 * self.edges.len()
    }

    fn half_edges(&self) -> impl Iterator<Item = HalfEdgeId> {
        let has_face = |&h: &HalfEdgeId| self.side(h).0.faces[h.index() % 2].get().is_some();
        (0..self.half_edge_bound()).map(HalfEdgeId::new).filter(has_face)
    }
}

impl<S: Storage> Adjacency for WingedEdge<S> {
    #[inline(always)]
    fn opposite(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        let (edge, side) = self.side(h);
        edge.faces[side ^ 1].get().map(|_| HalfEdgeId::new(h.index() ^ 1))
    }
}

impl<S: Storage> Incidence for WingedEdge<S> {
    #[inline]
    fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId> {
        let e = self.vertices[v.index()].get()?;
        let side = self.edges[e.index()].vertices[0] != v;
        Some(HalfEdgeId::new(2 * e.index() + usize::from(side)))
    }
}

impl<S: Storage> EdgeMap for WingedEdge<S> {
    type Edge = EdgeId;

    #[inline(always)]
    fn edge_count(&self) -> usize {
        self.edges.len()
    }

    #[inline(always)]
    fn edge(&self, h: HalfEdgeId) -> EdgeId {
        EdgeId::new(h.index() / 2)
    }

    #[inline(always)]
    fn half_edge(&self, e: EdgeId) -> HalfEdgeId {
        assert!(e.index() < self.edges.len(), "{e:?} is out of range");
        HalfEdgeId::new(2 * e.index())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn two_handles_an_edge_are_the_limit() {
        let most = i32::MAX as usize;
        assert_eq!(check_handles(most), Ok(()));
        let limit = u32::MAX as usize - 1;
        let error = BuildError::TooManyHalfEdges { half_edges: 2 * (most + 1), limit };
        assert_eq!(check_handles(most + 1), Err(error));
    }
}

//! [`AdjacencyGraph`]: the neighbours of each vertex in one run of memory, beside faces and opposites.
use crate::DirectedEdgesSmall;
use crate::check::{self, Checked, Once};
use crate::columns::{Column, Columns, FromColumns, Invalid, Source};
use crate::storage::{Owned, Storage};
use alloc::{borrow::Cow, vec::Vec};
use core::fmt;
use onering_core::footprint::{Bytes, Footprint};
use onering_core::{
    Adjacency, BuildError, FaceId, FromFaces, HalfEdgeId, Handle, Incidence, Pairing, Topology, VertexId,
    memory, ring::OneRing,
};

/// A vertex graph in the manner of TopTri (Figueiredo et al. 2014) that knows its faces: directed edges with
/// the neighbours of each vertex listed beside them.
///
/// Rings are read from one run of memory instead of walked over opposites, so the order of faces in memory
/// does not matter to them. Where a vertex has one fan its list is its `one_ring`, in order; otherwise the list
/// begins with the first fan, has each neighbour once, and serves `neighbours` alone.
///
/// Faces and links are those of [`DirectedEdgesSmall`]: the half-edges of a `star` leave the vertex, so what is
/// asked of them is their target, which that row stores; and it holds edges of three or more faces, faces that
/// disagree in orientation and vertices of several fans. Degenerate faces are refused.
#[derive(Clone)]
pub struct AdjacencyGraph<S: Storage = Owned> {
    table: DirectedEdgesSmall<S>,
    /// Where each list starts, and the end of the last.
    offsets: S::Slice<u32>,
    neighbours: S::Slice<VertexId>,
    /// Whether some vertex has several fans: asked before the table is, whose links are elsewhere in memory.
    has_several: bool,
}

impl<S: Storage> AdjacencyGraph<S> {
    #[inline(always)]
    fn list(&self, v: VertexId) -> &[VertexId] {
        &self.neighbours[self.offsets[v.index()] as usize..self.offsets[v.index() + 1] as usize]
    }
}

impl<S: Storage> fmt::Debug for AdjacencyGraph<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (vertices, faces) = (self.vertex_count(), self.face_count());
        write!(f, "AdjacencyGraph {{ vertices: {vertices}, faces: {faces} }}")
    }
}

impl FromFaces for AdjacencyGraph {
    fn build(vertex_count: usize, faces: Cow<'_, [[u32; 3]]>, pairing: Pairing) -> Result<Self, BuildError> {
        let table = DirectedEdgesSmall::build(vertex_count, faces, pairing)?;
        let has_several = table.vertices().any(|v| table.has_several_fans(v));
        let mut once = Once::new(if has_several { vertex_count } else { 0 })?;
        let mut offsets = memory::with_room(vertex_count + 1)?;
        let mut neighbours = memory::with_room(2 * edge_count(&table))?;
        for v in table.vertices() {
            offsets.push(neighbours.len() as u32);
            if has_several && table.has_several_fans(v) {
                neighbours.extend(rings(&table, v).filter(|&w| once.is_new(v, w)));
            } else {
                table.one_ring(v).for_each(|w| neighbours.push(w));
            }
        }
        offsets.push(neighbours.len() as u32);
        Ok(Self { table, offsets: offsets.into(), neighbours: neighbours.into(), has_several })
    }
}

/// Ring after ring: a neighbour that fans share comes more than once.
fn rings<S: Storage>(table: &DirectedEdgesSmall<S>, v: VertexId) -> impl Iterator<Item = VertexId> {
    table.fans(v).flat_map(|start| OneRing::new(table, Some(start)))
}

/// Number of edges. O(half-edges), however many faces share one.
fn edge_count(table: &DirectedEdgesSmall) -> usize {
    // After the half-edge itself the table gives the others ascending: the least is among the first two.
    let is_least = |&h: &HalfEdgeId| table.edge_fan(h).take(2).all(|g| h <= g);
    table.half_edges().filter(is_least).count()
}

impl Footprint for AdjacencyGraph {
    const BYTES: Bytes = {
        let table = DirectedEdgesSmall::BYTES;
        Bytes { constant: table.constant + 4, vertex: table.vertex + 4, edge: table.edge + 8, ..table }
    };

    fn heap_bytes(&self) -> usize {
        self.table.heap_bytes() + size_of_val(&*self.offsets) + size_of_val(&*self.neighbours)
    }
}

impl<S: Storage> Topology for AdjacencyGraph<S> {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    #[inline(always)]
    fn vertex_count(&self) -> usize {
        self.table.vertex_count()
    }

    #[inline(always)]
    fn face_count(&self) -> usize {
        self.table.face_count()
    }

    #[inline(always)]
    fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.table.origin(h)
    }

    #[inline(always)]
    fn target(&self, h: HalfEdgeId) -> VertexId {
        self.table.target(h)
    }
}

impl<S: Storage> Adjacency for AdjacencyGraph<S> {
    #[inline(always)]
    fn opposite(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.table.opposite(h)
    }

    #[inline]
    fn edge_fan(&self, h: HalfEdgeId) -> impl Iterator<Item = HalfEdgeId> {
        self.table.edge_fan(h)
    }

    #[inline(always)]
    fn is_boundary(&self, h: HalfEdgeId) -> bool {
        self.table.is_boundary(h)
    }

    #[inline(always)]
    fn rotate_ccw(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.table.rotate_ccw(h)
    }
}

impl<S: Storage> Incidence for AdjacencyGraph<S> {
    #[inline(always)]
    fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId> {
        self.table.outgoing(v)
    }

    #[inline]
    fn fans(&self, v: VertexId) -> impl Iterator<Item = HalfEdgeId> {
        self.table.fans(v)
    }

    #[inline]
    fn has_several_fans(&self, v: VertexId) -> bool {
        self.has_several && self.table.has_several_fans(v)
    }

    #[inline]
    fn star(&self, v: VertexId) -> impl Iterator<Item = HalfEdgeId> {
        self.table.star(v)
    }

    /// The list of `v` where it has one fan, otherwise a walk.
    #[inline]
    fn one_ring(&self, v: VertexId) -> impl Iterator<Item = VertexId> {
        let walks = self.has_several_fans(v);
        let (list, start) = if walks { (&[][..], self.table.outgoing(v)) } else { (self.list(v), None) };
        list.iter().copied().chain(start.into_iter().flat_map(|h| OneRing::new(&self.table, Some(h))))
    }

    #[inline]
    fn neighbours(&self, v: VertexId) -> impl Iterator<Item = VertexId> {
        self.list(v).iter().copied()
    }
}

impl<S: Storage> Columns for AdjacencyGraph<S> {
    fn backend(&self) -> Cow<'static, str> {
        Self::backend_name()
    }

    fn counts(&self) -> (usize, usize) {
        (self.vertex_count(), self.face_count())
    }

    fn columns(&self) -> Vec<Column<'_>> {
        let mut columns = self.table.columns();
        columns.push(Column::new("offsets", &self.offsets));
        columns.push(Column::new("neighbours", &self.neighbours));
        columns
    }

    fn validate(&self) -> Checked {
        self.table.validate()?;
        check::offsets("offsets", &self.offsets, self.neighbours.len())?;
        let mut once = Once::new(self.vertex_count())?;
        for v in self.vertices() {
            let mut list = self.list(v).iter().copied();
            let is_ring = rings(&self.table, v).all(|w| !once.is_new(v, w) || list.next() == Some(w));
            if !is_ring || list.next().is_some() {
                return Err(Invalid::element(
                    "offsets",
                    v.index(),
                    "the list is not of the rings of the vertex",
                ));
            }
        }
        Ok(())
    }
}

impl<S: Storage> FromColumns for AdjacencyGraph<S> {
    type Over<T: Storage> = AdjacencyGraph<T>;

    fn backend_name() -> Cow<'static, str> {
        Cow::Borrowed("adjacency-graph")
    }

    fn from_columns<T: Storage>(source: &impl Source<T>) -> Result<AdjacencyGraph<T>, Invalid> {
        let table = DirectedEdgesSmall::<S>::from_columns(source)?;
        Ok(AdjacencyGraph {
            offsets: source.column("offsets", Some(source.vertex_count() + 1))?,
            neighbours: source.column("neighbours", None)?,
            has_several: table.has_vertex_records(),
            table,
        })
    }
}

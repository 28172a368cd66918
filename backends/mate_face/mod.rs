//! [`MateFace`]: cells that know their neighbours as cells.
mod cell;
mod columns;
mod fans;

use crate::build;
use crate::link::{Coded, CodedLink, Coding, Link};
use crate::storage::{Owned, Storage};
use alloc::{borrow::Cow, boxed::Box, vec::Vec};
use cell::{Cell, NEXT, PREV, Walk};
use core::fmt;
use onering_core::footprint::{Bytes, Footprint};
use onering_core::{
    Adjacency, BuildError, FaceId, FromFaces, HalfEdgeId, Handle, Incidence, Pairing, Recycle, Slot,
    Topology, VertexId,
    memory::{self, Spare},
    pairing,
};

/// Mate-Face (Lizier and Cunha; Biscaro et al. 2016, section 4.1): for each face three vertices and three
/// *mates*, the faces across its sides; for each vertex one cell of each of its fans.
///
/// Mates are paired by unordered edges, so faces that disagree in orientation, and surfaces that have none,
/// are held as they are, and vertices of several fans too. An edge of three or more faces and a degenerate face
/// are refused. Half-edges are numbered by corners; a mate is a face and not a half-edge, so what has to know
/// the side, `opposite` and each step around a vertex, finds it by comparing up to three vertices.
///
/// # Fans
///
/// A *fan* of a vertex is here a run of its faces, each a mate of the one before, **whatever their
/// orientation**: wider than the turn by [`rotate_ccw`](Adjacency::rotate_ccw), which stops at an edge that its
/// two faces run along in the same direction. `fans`, `star`, `one_ring` and `neighbours` go by this notion, so
/// an inner vertex of a Klein bottle has one closed fan. `opposite`, `rotate_ccw` and `rotate_cw` know nothing
/// beyond such an edge; `edge_fan`, `is_boundary` and [`mate`](Self::mate) do.
///
/// An open fan starts at an end of it, at the one from where the walk is counter-clockwise where there is such
/// an end; a closed one starts at its lowest face. Open fans come before closed ones, and among the open ones
/// those that start counter-clockwise. Where the faces of a vertex agree, all this is as `Incidence` says;
/// where they do not, a walk is counter-clockwise, or clockwise, as its first face goes, and whether a fan is
/// open is told by `star` having one face fewer than `neighbours`, no longer by `opposite(outgoing(v))`.
///
/// ```
/// use onering::{FromFaces, Incidence, MateFace, Topology};
/// // Two faces that disagree: both run from vertex 0 to 1.
/// let mesh = MateFace::from_faces(4, &[[0, 1, 2], [0, 1, 3]])?;
/// let v = mesh.vertices().next().unwrap();
/// assert_eq!((mesh.fans(v).count(), mesh.star(v).count(), mesh.one_ring(v).count()), (1, 2, 3));
/// # Ok::<(), onering::BuildError>(())
/// ```
#[derive(Clone)]
pub struct MateFace<S: Storage = Owned> {
    cells: S::Slice<Cell>,
    /// For each vertex: its cell, none, or the place of its record. Written as a link to a half-edge is.
    vertices: S::Slice<CodedLink>,
    /// For each vertex of several fans: their number, then a cell of each.
    records: S::Slice<u32>,
}

impl<S: Storage> MateFace<S> {
    /// The face across the side of `f` that is opposite its vertex `side` (0, 1 or 2): the one from vertex
    /// `side + 1` to `side + 2`. `None` on the boundary. Known whichever way round the two faces go.
    ///
    /// # Panics
    /// Where `f` is out of range or `side` is above 2.
    #[inline(always)]
    pub fn mate(&self, f: FaceId, side: usize) -> Option<FaceId> {
        self.cells[f.index()].mates[side].get()
    }

    #[inline(always)]
    fn cell(&self, h: HalfEdgeId) -> (&Cell, usize) {
        (&self.cells[h.index() / 3], h.index() % 3)
    }

    /// The half-edge of the mate along the edge of `h`, and whether it runs the other way.
    #[inline]
    fn across(&self, h: HalfEdgeId) -> Option<(HalfEdgeId, bool)> {
        let (cell, i) = self.cell(h);
        let mate = cell.across_out(i)?;
        let [a, b] = [cell.vertices[i], cell.vertices[NEXT[i]]];
        let other = &self.cells[mate.index()];
        // Both ends are compared: the face alone does not tell the side, as two faces can share more than one.
        let j = other.position(b);
        let is_opposite = other.vertices[NEXT[j]] == a;
        let side = if is_opposite { j } else { PREV[j] };
        Some((HalfEdgeId::new(3 * mate.index() + side), is_opposite))
    }

    /// A cell of the first fan of `v`, and cells of the further ones.
    #[inline]
    fn starts(&self, v: VertexId) -> (Option<FaceId>, impl Iterator<Item = FaceId>) {
        let as_face = |&f: &u32| FaceId::new(f as usize);
        let link = self.vertices[v.index()];
        let record = link.number().map_or(&[][..], |place| build::record(&self.records, place));
        let only = link.half_edge().map(|number| FaceId::new(number.index()));
        (only.or_else(|| record.first().map(as_face)), record.iter().skip(1).map(as_face))
    }

    /// A cell of the first fan of `v`.
    #[inline(always)]
    fn start(&self, v: VertexId) -> Option<FaceId> {
        let only = self.vertices[v.index()].half_edge().map(|number| FaceId::new(number.index()));
        only.or_else(|| self.start_of_several(v))
    }

    #[cold]
    #[inline(never)]
    fn start_of_several(&self, v: VertexId) -> Option<FaceId> {
        self.starts(v).0
    }

    #[inline(always)]
    fn walk(&self, v: VertexId, start: Option<FaceId>) -> Walk<'_> {
        Walk::new(&self.cells, v, start)
    }

    /// The half-edge out of `v` in face `f`.
    #[inline]
    fn out_of(&self, v: VertexId, f: FaceId) -> HalfEdgeId {
        HalfEdgeId::new(3 * f.index() + self.cells[f.index()].position(v))
    }
}

impl<S: Storage> fmt::Debug for MateFace<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "MateFace {{ vertices: {}, faces: {} }}", self.vertices.len(), self.cells.len())
    }
}

/// The cells of `faces`, in the memory of what lies across each half-edge.
fn cells(faces: &[[u32; 3]], across: Vec<Slot<HalfEdgeId>>) -> Result<Box<[Cell]>, BuildError> {
    const NONE: u32 = u32::MAX;
    let mut words: Vec<u32> = bytemuck::cast_vec(across);
    memory::resize(&mut words, 6 * faces.len(), NONE)?;
    // From the last on: a cell comes to lie behind all that is still to be read.
    for (f, face) in faces.iter().enumerate().rev() {
        let mates = NEXT.map(|side| words[3 * f + side]).map(|h| if h == NONE { NONE } else { h / 3 });
        words[6 * f..][..3].copy_from_slice(face);
        words[6 * f + 3..][..3].copy_from_slice(&mates);
    }
    Ok(bytemuck::allocation::cast_slice_box(words.into_boxed_slice()))
}

impl FromFaces for MateFace {
    fn build(vertex_count: usize, faces: Cow<'_, [[u32; 3]]>, pairing: Pairing) -> Result<Self, BuildError> {
        Self::build_in(vertex_count, faces, pairing, &mut Spare::default())
    }
}

/// Records are made afresh each time, and the vertices where faces disagree in orientation.
impl Recycle for MateFace {
    fn build_in(
        vertex_count: usize,
        faces: Cow<'_, [[u32; 3]]>,
        pairing: Pairing,
        spare: &mut Spare,
    ) -> Result<Self, BuildError> {
        pairing::check_counts(vertex_count, faces.len(), Coded::MAX_HALF_EDGES)?;
        // Opposites become mates where they are: so there is room for cells from the start.
        let mut table = spare.table(6 * faces.len())?;
        table.truncate(3 * faces.len());
        let (paired, starts) = pairing::pair_with_starts(vertex_count, &faces, pairing, table, spare)?;
        let paired = paired.refuse_non_manifold(&faces)?;
        let mut across = paired.opposite;
        if paired.irregular.is_empty() {
            let (vertices, records) = fans::of_opposites(vertex_count, &faces, &across, starts, spare)?;
            let cells = cells(&faces, across)?;
            return Ok(Self { cells, vertices: vertices.into(), records: records.into() });
        }
        // What is left in records is two half-edges each, which run in the same direction.
        for record in paired.irregular.iter() {
            let [g, h] = [record[0], record[1]];
            (across[g.index()], across[h.index()]) = (Slot::some(h), Slot::some(g));
        }
        let cells = cells(&faces, across)?;
        let (vertices, records) = fans::find(vertex_count, &cells)?;
        Ok(Self { cells, vertices: vertices.into(), records: records.into() })
    }

    fn leave(self, spare: &mut Spare) {
        let words: Box<[u32]> = bytemuck::allocation::cast_slice_box(self.cells);
        spare.keep(words.into_vec());
        spare.keep(self.vertices.into_vec());
    }
}

impl Footprint for MateFace {
    const BYTES: Bytes = Bytes { vertex: 4, face: 24, vertex_record: 4, ..Bytes::NONE };

    fn heap_bytes(&self) -> usize {
        size_of_val(&*self.cells) + size_of_val(&*self.vertices) + size_of_val(&*self.records)
    }
}

impl<S: Storage> Topology for MateFace<S> {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    #[inline(always)]
    fn vertex_count(&self) -> usize {
        self.vertices.len()
    }

    #[inline(always)]
    fn face_count(&self) -> usize {
        self.cells.len()
    }

    #[inline(always)]
    fn origin(&self, h: HalfEdgeId) -> VertexId {
        let (cell, i) = self.cell(h);
        cell.vertices[i]
    }

    #[inline(always)]
    fn face_vertices(&self, f: FaceId) -> [VertexId; 3] {
        self.cells[f.index()].vertices
    }
}

impl<S: Storage> Adjacency for MateFace<S> {
    #[inline]
    fn opposite(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.across(h).and_then(|(g, is_opposite)| is_opposite.then_some(g))
    }

    #[inline]
    fn edge_fan(&self, h: HalfEdgeId) -> impl Iterator<Item = HalfEdgeId> {
        core::iter::once(h).chain(self.across(h).map(|(g, _)| g))
    }

    #[inline(always)]
    fn is_boundary(&self, h: HalfEdgeId) -> bool {
        let (cell, i) = self.cell(h);
        cell.across_out(i).is_none()
    }
}

/// By the wider notion of a fan: see [`MateFace`].
impl<S: Storage> Incidence for MateFace<S> {
    #[inline]
    fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId> {
        self.start(v).map(|f| self.out_of(v, f))
    }

    #[inline]
    fn fans(&self, v: VertexId) -> impl Iterator<Item = HalfEdgeId> {
        let (first, further) = self.starts(v);
        first.into_iter().chain(further).map(move |f| self.out_of(v, f))
    }

    #[inline]
    fn star(&self, v: VertexId) -> impl Iterator<Item = HalfEdgeId> {
        let (first, further) = self.starts(v);
        let further = further.flat_map(move |f| self.walk(v, Some(f)));
        self.walk(v, first).chain(further).map(|(h, _)| h)
    }

    #[inline]
    fn has_several_fans(&self, v: VertexId) -> bool {
        self.vertices[v.index()].number().is_some()
    }

    #[inline(always)]
    fn one_ring(&self, v: VertexId) -> impl Iterator<Item = VertexId> {
        self.walk(v, self.start(v)).ring()
    }
}

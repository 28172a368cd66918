//! [`Table`]: one struct for every row of the layout table.
mod checks;
mod columns;
mod linked;
mod walk;

use crate::build::{self, Links};
use crate::column::{Answered, Cells, Kept, Policy};
use crate::layout::{Defects, Edges, Layout};
use crate::link::{Coding, Link};
use crate::storage::{Element, Owned, Storage};
use alloc::{borrow::Cow, vec::Vec};
use core::fmt;
use onering_core::footprint::{Bytes, Footprint};
use onering_core::{
    Adjacency, Boundaries, BuildError, CurveId, EdgeId, EdgeMap, FaceId, FromFaces, HalfEdgeId, Handle,
    Incidence, Pairing, Recycle, Topology, VertexId, corner, memory::Spare, pairing,
};

type Column<P, S, T> = <P as Policy>::Cells<S, T>;
type LinkOf<L> = <<L as Layout>::Links as Coding>::Link;
type EdgeList<L> = <<L as Layout>::Edges as Edges>::List;
type EdgeIndex<L> = <<L as Layout>::Edges as Edges>::Index;
type RecordsOf<L> = <<L as Layout>::Defects as Defects>::Records;

/// Triangle topology laid out as the row `L` of [`with_layouts!`](crate::with_layouts) says. Half-edges are
/// numbered by corners.
#[derive(Clone)]
pub struct Table<L: Layout, S: Storage = Owned> {
    vertex_count: usize,
    face_count: usize,
    origin: Column<L::Origin, S, VertexId>,
    target: Column<L::Target, S, VertexId>,
    next: Column<L::Next, S, HalfEdgeId>,
    prev: Column<L::Prev, S, HalfEdgeId>,
    opposite: Column<L::Opposite, S, LinkOf<L>>,
    outgoing: Column<L::Outgoing, S, LinkOf<L>>,
    edge_list: Column<EdgeList<L>, S, HalfEdgeId>,
    edge_index: Column<EdgeIndex<L>, S, EdgeId>,
    curve_list: Column<L::Curves, S, HalfEdgeId>,
    edge_records: Column<RecordsOf<L>, S, u32>,
    vertex_records: Column<RecordsOf<L>, S, u32>,
}

impl<L: Layout, S: Storage> fmt::Debug for Table<L, S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {{ vertices: {}, faces: {} }}", L::NAME, self.vertex_count, self.face_count)
    }
}

impl<L: Layout, S: Storage> Table<L, S> {
    const HOLDS: bool = RecordsOf::<L>::CELLS > 0;

    /// Whether the row has a column that half-edges have to be paired for.
    const PAIRS: bool = L::Opposite::CELLS + L::Outgoing::CELLS + EdgeList::<L>::CELLS + L::Curves::CELLS > 0;

    /// Whether the link across `h` is in the cell of `next(h)`, so that a turn around a vertex finds in one cell the next
    /// half-edge and beside it the neighbour that the last one led to, and need not work out a place.
    const IS_TURNED: bool = L::Target::CELLS > 0;

    /// The cell of the link across `h`.
    #[inline(always)]
    fn link_cell(h: HalfEdgeId) -> usize {
        if Self::IS_TURNED { corner::next(h).index() } else { h.index() }
    }

    /// The cell of the link across `prev(h)`. The compiler does not see by itself that `next(prev(h))` is `h`.
    #[inline(always)]
    fn turn_cell(h: HalfEdgeId) -> usize {
        if Self::IS_TURNED { h.index() } else { corner::prev(h).index() }
    }

    /// Moves links across half-edges to their cells.
    fn place_links(links: &mut [LinkOf<L>]) {
        if Self::IS_TURNED {
            links.as_chunks_mut::<3>().0.iter_mut().for_each(|face| face.rotate_right(1));
        }
    }

    const IS_SOUND: () = {
        assert!(L::Origin::CELLS + L::Target::CELLS > 0, "a layout stores `Origin` or `Target`");
        let coded = L::Links::MAX_HALF_EDGES < u32::MAX as usize - 1;
        assert!(
            coded || !Self::HOLDS && L::Curves::CELLS == 0,
            "a layout with records or curves has `Coded` links"
        );
    };

    #[inline(always)]
    fn link(&self, h: HalfEdgeId) -> LinkOf<L>
    where
        L::Opposite: Kept,
    {
        L::Opposite::get(&self.opposite, Self::link_cell(h))
    }

    /// The half-edges along the irregular edge of `h`; none where its edge is regular.
    #[inline]
    fn edge_record(&self, h: HalfEdgeId) -> &[u32]
    where
        L::Opposite: Kept,
    {
        let number = self.link(h).number();
        let place = number.and_then(|k| k.checked_sub(self.curve_list.as_slice().len()));
        place.map_or(&[], |place| build::record(self.edge_records.as_slice(), place))
    }

    /// Whether some vertex has several fans.
    pub(crate) fn has_vertex_records(&self) -> bool {
        !self.vertex_records.as_slice().is_empty()
    }

    /// The start of the first fan of `v` where it has several.
    #[cold]
    #[inline(never)]
    fn first_of_several(&self, v: VertexId) -> Option<HalfEdgeId>
    where
        L::Outgoing: Kept,
    {
        build::half_edges(self.vertex_record(v)).next()
    }

    /// The starts of the fans of `v`; none where it has one fan or no face.
    #[inline]
    fn vertex_record(&self, v: VertexId) -> &[u32]
    where
        L::Outgoing: Kept,
    {
        let place = L::Outgoing::get(&self.outgoing, v.index()).number();
        place.map_or(&[], |place| build::record(self.vertex_records.as_slice(), place))
    }
}

impl<L: Layout> FromFaces for Table<L> {
    fn build(vertex_count: usize, faces: Cow<'_, [[u32; 3]]>, pairing: Pairing) -> Result<Self, BuildError> {
        Self::build_in(vertex_count, faces, pairing, &mut Spare::default())
    }
}

/// Curves and records are made afresh each time.
impl<L: Layout> Recycle for Table<L> {
    fn build_in(
        vertex_count: usize,
        faces: Cow<'_, [[u32; 3]]>,
        pairing: Pairing,
        spare: &mut Spare,
    ) -> Result<Self, BuildError> {
        let () = Self::IS_SOUND;
        pairing::check_counts(vertex_count, faces.len(), L::Links::MAX_HALF_EDGES)?;
        let mut links = if Self::PAIRS {
            build::links(vertex_count, &faces, pairing, L::Outgoing::CELLS > 0, Self::HOLDS, spare)?
        } else {
            pairing::check_vertices(vertex_count, &faces)?;
            Links::default()
        };
        let face_count = faces.len();
        let half_edges = || (0..3 * face_count).map(HalfEdgeId::new);
        // Curves last: they renumber what the links say.
        let edge_list = Cells::build(|| links.edge_list(spare))?;
        let edge_index = Cells::build(|| links.edge_index(spare))?;
        let curve_list = Cells::build(|| links.name_curves(&faces))?;
        Self::place_links(&mut links.opposite);
        let (origin, target);
        if L::Origin::CELLS > 0 {
            target = Cells::build(|| build::targets(&faces, spare))?;
            origin = Cells::build(|| build::into_origins(faces, spare))?;
        } else {
            origin = Cells::build(|| Ok(Vec::new()))?;
            target = Cells::build(|| build::into_targets(faces, spare))?;
        }
        let mut in_faces = |of: fn(HalfEdgeId) -> HalfEdgeId| {
            let mut column = spare.room(3 * face_count)?;
            column.extend(half_edges().map(of));
            Ok(column)
        };
        let table = Self {
            vertex_count,
            face_count,
            origin,
            target,
            next: Cells::build(|| in_faces(corner::next))?,
            prev: Cells::build(|| in_faces(corner::prev))?,
            opposite: Cells::build(|| Ok(links.opposite))?,
            outgoing: Cells::build(|| Ok(links.outgoing))?,
            edge_list,
            edge_index,
            curve_list,
            edge_records: Cells::build(|| Ok(links.edge_records.words))?,
            vertex_records: Cells::build(|| Ok(links.vertex_records.words))?,
        };
        assert!(table.check_turns().is_ok(), "pairing gives half-edges that exist");
        Ok(table)
    }

    fn leave(self, spare: &mut Spare) {
        leave(self.origin, spare);
        leave(self.target, spare);
        leave(self.next, spare);
        leave(self.prev, spare);
        leave(self.opposite, spare);
        leave(self.outgoing, spare);
        leave(self.edge_list, spare);
        leave(self.edge_index, spare);
    }
}

fn leave<T: Element>(column: impl Cells<Owned, T>, spare: &mut Spare) {
    if let Some(cells) = column.into_slice() {
        spare.keep(cells.into_vec());
    }
}

impl<L: Layout> Footprint for Table<L> {
    const BYTES: Bytes = Bytes {
        constant: 0,
        vertex: 4 * L::Outgoing::CELLS,
        edge: 4 * EdgeList::<L>::CELLS,
        face: 12
            * (L::Origin::CELLS
                + L::Target::CELLS
                + L::Next::CELLS
                + L::Prev::CELLS
                + L::Opposite::CELLS
                + EdgeIndex::<L>::CELLS),
        curve: 4 * L::Curves::CELLS,
        edge_record: 4 * RecordsOf::<L>::CELLS * L::Opposite::CELLS,
        vertex_record: 4 * RecordsOf::<L>::CELLS * L::Outgoing::CELLS,
        unmatched: 0,
    };

    fn heap_bytes(&self) -> usize {
        size_of_val(self.origin.as_slice())
            + size_of_val(self.target.as_slice())
            + size_of_val(self.next.as_slice())
            + size_of_val(self.prev.as_slice())
            + size_of_val(self.opposite.as_slice())
            + size_of_val(self.outgoing.as_slice())
            + size_of_val(self.edge_list.as_slice())
            + size_of_val(self.edge_index.as_slice())
            + size_of_val(self.curve_list.as_slice())
            + size_of_val(self.edge_records.as_slice())
            + size_of_val(self.vertex_records.as_slice())
    }
}

impl<L: Layout, S: Storage> Topology for Table<L, S> {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    #[inline(always)]
    fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    #[inline(always)]
    fn face_count(&self) -> usize {
        self.face_count
    }

    #[inline(always)]
    fn origin(&self, h: HalfEdgeId) -> VertexId {
        L::Origin::get_or(&self.origin, h.index(), || self.target(self.prev(h)))
    }

    #[inline(always)]
    fn target(&self, h: HalfEdgeId) -> VertexId {
        L::Target::get_or(&self.target, h.index(), || self.origin(self.next(h)))
    }

    /// Where only the previous is stored (directed edges, medium), the next is the previous of the previous.
    #[inline(always)]
    fn next(&self, h: HalfEdgeId) -> HalfEdgeId {
        let by_prev = || if L::Prev::CELLS > 0 { self.prev(self.prev(h)) } else { corner::next(h) };
        L::Next::get_or(&self.next, h.index(), by_prev)
    }

    #[inline(always)]
    fn prev(&self, h: HalfEdgeId) -> HalfEdgeId {
        L::Prev::get_or(&self.prev, h.index(), || corner::prev(h))
    }
}

#[diagnostic::do_not_recommend] // the error is then of the trait, and names the remedy
impl<L: Layout<Opposite: Kept>, S: Storage> Adjacency for Table<L, S> {
    #[inline(always)]
    fn opposite(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.link(h).half_edge()
    }

    #[inline(always)]
    fn rotate_ccw(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        L::Opposite::get(&self.opposite, Self::turn_cell(h)).half_edge()
    }

    #[inline]
    fn edge_fan(&self, h: HalfEdgeId) -> impl Iterator<Item = HalfEdgeId> {
        let others = build::half_edges(self.edge_record(h)).filter(move |&g| g != h);
        core::iter::once(h).chain(self.opposite(h)).chain(others)
    }

    #[inline(always)]
    fn is_boundary(&self, h: HalfEdgeId) -> bool {
        self.opposite(h).is_none() && (!Self::HOLDS || self.edge_record(h).is_empty())
    }
}

#[diagnostic::do_not_recommend] // the error is then of the trait, and names the remedy
impl<L: Layout<Opposite: Kept, Outgoing: Kept>, S: Storage> Incidence for Table<L, S> {
    #[inline(always)]
    fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId> {
        let first = L::Outgoing::get(&self.outgoing, v.index()).half_edge();
        if Self::HOLDS { first.or_else(|| self.first_of_several(v)) } else { first }
    }

    #[inline]
    fn fans(&self, v: VertexId) -> impl Iterator<Item = HalfEdgeId> {
        let further = if Self::HOLDS { self.vertex_record(v) } else { &[] };
        self.outgoing(v).into_iter().chain(build::half_edges(further).skip(1))
    }

    #[inline]
    fn has_several_fans(&self, v: VertexId) -> bool {
        Self::HOLDS && L::Outgoing::get(&self.outgoing, v.index()).number().is_some()
    }

    #[inline]
    fn star(&self, v: VertexId) -> impl Iterator<Item = HalfEdgeId> {
        self.turns(self.fans(v))
    }

    #[inline(always)]
    fn one_ring(&self, v: VertexId) -> impl Iterator<Item = VertexId> {
        self.ring(self.outgoing(v))
    }
}

#[diagnostic::do_not_recommend] // the error is then of the trait, and names the remedy
impl<L: Layout<Opposite: Kept, Edges: Edges<List: Kept, Index: Answered>>, S: Storage> EdgeMap
    for Table<L, S>
{
    type Edge = EdgeId;

    #[inline(always)]
    fn edge_count(&self) -> usize {
        self.edge_list.as_slice().len()
    }

    #[inline]
    fn edge(&self, h: HalfEdgeId) -> EdgeId {
        let by_search = || {
            let least = self.edge_fan(h).take(2).min().unwrap_or(h);
            EdgeId::new(self.edge_list.as_slice().partition_point(|&g| g < least))
        };
        EdgeIndex::<L>::get_or(&self.edge_index, h.index(), by_search)
    }

    #[inline(always)]
    fn half_edge(&self, e: EdgeId) -> HalfEdgeId {
        EdgeList::<L>::get(&self.edge_list, e.index())
    }
}

#[diagnostic::do_not_recommend] // the error is then of the trait, and names the remedy
impl<L: Layout<Opposite: Kept, Curves: Kept>, S: Storage> Boundaries for Table<L, S> {
    type Curve = CurveId;

    #[inline(always)]
    fn curve_count(&self) -> usize {
        self.curve_list.as_slice().len()
    }

    #[inline(always)]
    fn curve_start(&self, c: CurveId) -> HalfEdgeId {
        L::Curves::get(&self.curve_list, c.index())
    }

    #[inline]
    fn curve_of(&self, h: HalfEdgeId) -> Option<CurveId> {
        let number = self.link(h).number()?;
        (number < self.curve_count()).then(|| CurveId::new(number))
    }
}

//! Turns around a vertex of a [`Table`], without a check of bounds at each step where that is known to be needless.
#![expect(unsafe_code, reason = "checks cost 3 to 44 % of a turn: see docs/internals.md")]
use super::{LinkOf, Table};
use crate::column::{Cells, Kept};
use crate::layout::Layout;
use crate::link::Link;
use crate::storage::Storage;
use bytemuck::TransparentWrapper;
use onering_core::{
    Adjacency, FaceId, HalfEdgeId, Handle, Topology, VertexId, corner,
    ring::{OneRing, Star},
};

/// A table as turns see it, which ask only for half-edges that its own links lead to, after a first one that exists.
///
/// None is ever given away: who could ask it for any half-edge could read out of bounds.
#[derive(TransparentWrapper)]
#[repr(transparent)]
pub(super) struct Walked<L: Layout, S: Storage>(Table<L, S>);

impl<L: Layout<Opposite: Kept>, S: Storage> Table<L, S> {
    /// The ring around the fan that begins with `start`. Always inline: as a call that gives its iterator by way of memory
    /// it took 47 of 131 instructions a vertex (directed edges small, valence 6).
    #[inline(always)]
    pub(super) fn ring(&self, start: Option<HalfEdgeId>) -> OneRing<'_, impl Adjacency<Vertex = VertexId>> {
        OneRing::new(Walked::wrap_ref(self), start.inspect(|&h| self.assert_exists(h)))
    }

    /// The fans that begin with `starts`.
    #[inline]
    pub(super) fn turns(&self, starts: impl Iterator<Item = HalfEdgeId>) -> impl Iterator<Item = HalfEdgeId> {
        Star::new(Walked::wrap_ref(self), starts.inspect(|&h| self.assert_exists(h)))
    }

    #[inline(always)]
    fn assert_exists(&self, h: HalfEdgeId) {
        assert!(h.index() < 3 * self.face_count, "{h:?} is no half-edge of {self:?}");
    }
}

impl<L: Layout, S: Storage> Walked<L, S> {
    /// # Safety
    /// `i` is below the number of cells, or somebody else owns them.
    #[inline(always)]
    unsafe fn get<T: Copy>(cells: &[T], i: usize) -> T {
        // SAFETY: so the caller says.
        if S::IS_OWNED { unsafe { *cells.get_unchecked(i) } } else { cells[i] }
    }

    /// # Safety
    /// `i` is below three times the number of faces.
    #[inline(always)]
    unsafe fn link(&self, i: usize) -> Option<HalfEdgeId> {
        let links = self.0.opposite.as_slice();
        // SAFETY: the column has a cell for each half-edge.
        let link: LinkOf<L> = unsafe { Self::get(links, i) };
        link.half_edge()
    }
}

impl<L: Layout, S: Storage> Walked<L, S> {
    /// The neighbour after the last face of an open fan. Out of the loop, where its place was worked out at every step.
    #[cold]
    #[inline(never)]
    fn last_of_open(&self, h: HalfEdgeId) -> VertexId {
        self.0.target(corner::next(h))
    }
}

impl<L: Layout, S: Storage> Topology for Walked<L, S> {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    #[inline(always)]
    fn vertex_count(&self) -> usize {
        self.0.vertex_count()
    }

    #[inline(always)]
    fn face_count(&self) -> usize {
        self.0.face_count()
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

impl<L: Layout<Opposite: Kept>, S: Storage> Adjacency for Walked<L, S> {
    #[inline(always)]
    fn opposite(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.0.opposite(h)
    }

    #[inline(always)]
    fn rotate_ccw(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        // SAFETY: `h` exists, and so does what is before it in its face.
        unsafe { self.link(Table::<L, S>::turn_cell(h)) }
    }

    #[inline(always)]
    fn turn(&self, h: HalfEdgeId) -> (VertexId, Option<HalfEdgeId>) {
        let found = self.rotate_ccw(h);
        let v = match found {
            // SAFETY: links of columns that are owned lead to half-edges that exist, as was seen when the table was
            // made; the column, which the row keeps, has a cell for each.
            Some(g) if Table::<L, S>::IS_TURNED => unsafe { Self::get(self.0.target.as_slice(), g.index()) },
            None if Table::<L, S>::IS_TURNED => self.last_of_open(h),
            // SAFETY: as above, and of `h` as well.
            _ => unsafe { Self::get(self.0.origin.as_slice(), corner::prev(h).index()) },
        };
        (v, found)
    }
}

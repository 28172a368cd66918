//! Cells and the walk around a vertex over them.
use bytemuck::{Pod, Zeroable};
use onering_core::{FaceId, HalfEdgeId, Handle, Slot, VertexId};

/// Local indices after and before `i`: Eqs. (2) and (3) of Biscaro et al. (2016).
pub(super) const NEXT: [usize; 3] = [1, 2, 0];
pub(super) const PREV: [usize; 3] = [2, 0, 1];

/// One triangle: `mates[i]` is the face across the side opposite `vertices[i]`.
#[derive(Clone, Copy, Debug, Pod, Zeroable)]
#[repr(C)]
pub(super) struct Cell {
    pub(super) vertices: [VertexId; 3],
    pub(super) mates: [Slot<FaceId>; 3],
}

const _: () = assert!(size_of::<Cell>() == 24);

impl Cell {
    /// Where `v` stands among the vertices: the local search of Algorithm 1, lines 3 and 8. Without a branch, which would
    /// be mispredicted as often as not.
    #[inline(always)]
    pub(super) fn position(&self, v: VertexId) -> usize {
        let is_second = usize::from(self.vertices[1] == v);
        if self.vertices[2] == v { 2 } else { is_second }
    }

    /// The third vertex beside `u` and `v`, without a search.
    #[inline(always)]
    fn third(&self, u: VertexId, v: VertexId) -> VertexId {
        let all = self.vertices.iter().fold(0, |all, w| all ^ w.index());
        VertexId::new(all ^ u.index() ^ v.index())
    }

    /// The mate across the half-edge out of vertex `i`.
    #[inline(always)]
    pub(super) fn across_out(&self, i: usize) -> Option<FaceId> {
        self.mates[PREV[i]].get()
    }

    /// The mate across the half-edge into vertex `i`.
    #[inline(always)]
    pub(super) fn across_in(&self, i: usize) -> Option<FaceId> {
        self.mates[NEXT[i]].get()
    }
}

/// The cells of one fan about `v`, each with the half-edge out of `v` and the neighbour on the side by which
/// the walk leaves it.
///
/// Algorithm 1 of Biscaro et al. (2016) with what it leaves out: the end of an open fan, and faces that
/// disagree in orientation. It is told by which edge of `v` a cell was entered (`from`) and leaves by the
/// other one, whichever way round the cell's vertices go.
#[derive(Clone, Debug)]
pub(super) struct Walk<'a> {
    cells: &'a [Cell],
    v: VertexId,
    start: Slot<FaceId>,
    at: Slot<FaceId>,
    from: VertexId,
    is_open: bool,
    has_begun: bool,
}

impl<'a> Walk<'a> {
    /// The walk from `start`, an end of the fan where it is open; nothing where there is no start.
    ///
    /// It is counter-clockwise in the first cell, but where that is the counter-clockwise end of an open fan.
    #[inline(always)]
    pub(super) fn new(cells: &'a [Cell], v: VertexId, start: Option<FaceId>) -> Self {
        let (from, is_open) = start.map_or((v, false), |f| {
            let cell = &cells[f.index()];
            let i = cell.position(v);
            let [ends_in, ends_out] = [cell.across_in(i), cell.across_out(i)].map(|mate| mate.is_none());
            let first = if ends_in && !ends_out { PREV[i] } else { NEXT[i] };
            (cell.vertices[first], ends_in || ends_out)
        });
        let start = start.into();
        Self { cells, v, start, at: start, from, is_open, has_begun: false }
    }

    /// The neighbours around the fan: one for each cell, and one more before them where it is open. To be asked before
    /// the first step.
    #[inline(always)]
    pub(super) fn ring(self) -> Ring<'a> {
        Ring { lead: self.is_open.then_some(self.from).into(), walk: self }
    }
}

/// The neighbours around one fan.
#[derive(Clone, Debug)]
pub(super) struct Ring<'a> {
    lead: Slot<VertexId>,
    walk: Walk<'a>,
}

impl Iterator for Ring<'_> {
    type Item = VertexId;

    #[inline]
    fn next(&mut self) -> Option<VertexId> {
        if let Some(v) = self.lead.get() {
            self.lead = Slot::NONE;
            return Some(v);
        }
        self.walk.next().map(|(_, to)| to)
    }

    /// Keeps the `lead` out of the loop.
    #[inline]
    fn fold<B, F: FnMut(B, VertexId) -> B>(self, mut acc: B, mut f: F) -> B {
        if let Some(v) = self.lead.get() {
            acc = f(acc, v);
        }
        self.walk.fold(acc, |acc, (_, to)| f(acc, to))
    }
}

impl Iterator for Walk<'_> {
    type Item = (HalfEdgeId, VertexId);

    #[inline]
    fn next(&mut self) -> Option<(HalfEdgeId, VertexId)> {
        let f = self.at.get()?;
        if self.has_begun && self.at == self.start {
            return None;
        }
        self.has_begun = true;
        let cell = &self.cells[f.index()];
        // The other end of the side tells by which side the cell was entered, and so the one to leave by, which lies
        // opposite it. The face that it was entered from would not: two faces can be mates across two sides of one
        // vertex.
        self.at = cell.mates[cell.position(self.from)];
        self.from = cell.third(self.v, self.from);
        Some((HalfEdgeId::new(3 * f.index() + cell.position(self.v)), self.from))
    }
}

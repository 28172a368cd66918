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
    /// Where `v` stands among the vertices: the local search of Algorithm 1, lines 3 and 8.
    #[inline(always)]
    pub(super) fn position(&self, v: VertexId) -> usize {
        if self.vertices[0] == v {
            0
        } else if self.vertices[1] == v {
            1
        } else {
            2
        }
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
}

impl<'a> Walk<'a> {
    /// The walk from `start`, an end of the fan where it is open; nothing where there is no start.
    ///
    /// It is counter-clockwise in the first cell, but where that is the counter-clockwise end of an open fan.
    #[inline]
    pub(super) fn new(cells: &'a [Cell], v: VertexId, start: Option<FaceId>) -> Self {
        let from = start.map_or(v, |f| {
            let cell = &cells[f.index()];
            let i = cell.position(v);
            let is_clockwise = cell.across_in(i).is_none() && cell.across_out(i).is_some();
            cell.vertices[if is_clockwise { PREV[i] } else { NEXT[i] }]
        });
        Self { cells, v, start: start.into(), at: start.into(), from }
    }

    /// The neighbours around the fan: one for each cell, and one more before them where it is open.
    #[inline]
    pub(super) fn ring(self) -> impl Iterator<Item = VertexId> + use<'a> {
        self.lead().into_iter().chain(self.map(|(_, to)| to))
    }

    /// The neighbour before the first cell of an open fan. To be asked before the first step.
    #[inline]
    fn lead(&self) -> Option<VertexId> {
        let cell = &self.cells[self.start.get()?.index()];
        let i = cell.position(self.v);
        let is_out = cell.vertices[NEXT[i]] == self.from;
        let behind = if is_out { cell.across_out(i) } else { cell.across_in(i) };
        behind.is_none().then_some(self.from)
    }
}

impl Iterator for Walk<'_> {
    type Item = (HalfEdgeId, VertexId);

    #[inline]
    fn next(&mut self) -> Option<(HalfEdgeId, VertexId)> {
        let f = self.at.get()?;
        let cell = &self.cells[f.index()];
        let i = cell.position(self.v);
        let [next, prev] = [NEXT[i], PREV[i]];
        // The other end of the side tells by which side the cell was entered. Its face would not: two faces
        // can be mates across two sides of one vertex.
        let to = if cell.vertices[next] == self.from { prev } else { next };
        let mate = cell.mates[next + prev - to];
        self.from = cell.vertices[to];
        self.at = if mate == self.start { Slot::NONE } else { mate };
        Some((HalfEdgeId::new(3 * f.index() + i), self.from))
    }
}

//! What is checked of the columns of [`Table`], before a walk relies on it.
use super::linked::Linked;
use super::{EdgeList, LinkOf, Table};
use crate::build;
use crate::check::{self, Checked};
use crate::column::{Cells, Policy};
use crate::columns::Invalid;
use crate::layout::Layout;
use crate::link::Link;
use crate::storage::{Element, Storage};
use onering_core::{
    Adjacency, HalfEdgeId, Handle, Pairing, Topology, VertexId, boundary, corner,
    memory::{self, Spare},
};

impl<L: Layout, S: Storage> Table<L, S> {
    /// The name of the column of links across half-edges, by the half-edge whose cell it is.
    pub(super) const LINKS: &'static str = if Self::IS_TURNED { "rotate_ccw" } else { "opposite" };

    /// What is wrong with the link across a half-edge, said of its cell.
    pub(super) fn in_its_cell(problem: Invalid) -> Invalid {
        match problem {
            Invalid::Element { column, index, problem } => {
                Invalid::element(column, Self::link_cell(HalfEdgeId::new(index)), problem)
            }
            other => other,
        }
    }

    /// The link across `h`, whether or not the row is known to have any.
    #[inline(always)]
    pub(super) fn link_if_any(&self, h: HalfEdgeId) -> LinkOf<L> {
        self.opposite.as_slice()[Self::link_cell(h)]
    }

    /// The column that faces are in.
    pub(super) fn corner_column(&self) -> &'static str {
        if L::Origin::CELLS > 0 { "origin" } else { "target" }
    }

    /// Vertices exist, and what is stored beside them is what the numbers of corners say.
    pub(super) fn check_corners(&self) -> Checked {
        check::handles("origin", self.origin.as_slice(), self.vertex_count)?;
        check::handles("target", self.target.as_slice(), self.vertex_count)?;
        follows("next", self.next.as_slice(), corner::next)?;
        follows("prev", self.prev.as_slice(), corner::prev)?;
        if L::Origin::CELLS == 0 {
            return Ok(());
        }
        let origin = self.origin.as_slice();
        follows("target", self.target.as_slice(), |h: HalfEdgeId| origin[corner::next(h).index()])
    }

    /// Links lead to half-edges that exist.
    pub(super) fn check_links(&self, column: &'static str, links: &[LinkOf<L>]) -> Checked {
        // As a word, like the links: four are compared at a time. No half-edge has the last number.
        let bound = u32::try_from(3 * self.face_count).unwrap_or(u32::MAX);
        // Looked at once more where one is out of range, so that the loop is without a branch until then.
        let past = |link: &LinkOf<L>| link.half_edge().is_some_and(|h| h.index() as u32 >= bound);
        if links.iter().fold(false, |any, link| any | past(link)) {
            let index = links.iter().position(past).unwrap_or(0);
            return Err(Invalid::element(column, index, check::OUT_OF_RANGE));
        }
        Ok(())
    }

    pub(super) fn check_links_across(&self) -> Checked {
        self.check_links(Self::LINKS, self.opposite.as_slice())
    }

    /// What turns without checks of bounds rely on: a cell for each half-edge in the columns that they read, and links
    /// to half-edges that exist.
    pub(super) fn check_turns(&self) -> Checked {
        if L::Opposite::CELLS == 0 {
            return Ok(());
        }
        let vertices = if Self::IS_TURNED { self.target.as_slice() } else { self.origin.as_slice() };
        // What wraps is no count of cells that there are.
        let cells = self.face_count.checked_mul(3);
        if [vertices.len(), self.opposite.as_slice().len()].map(Some) != [cells; 2] {
            return Err(Invalid::column(Self::LINKS, "has more or fewer cells than there are half-edges"));
        }
        self.check_links_across()
    }

    /// The place of the record that the link of a half-edge names.
    pub(super) fn edge_place(&self, h: HalfEdgeId) -> Option<usize> {
        self.link_if_any(h).number()?.checked_sub(self.curve_list.as_slice().len())
    }

    /// Each record is of one irregular edge, ascending, and named by all of its half-edges and no others.
    pub(super) fn check_edge_records(&self) -> Checked {
        let words = self.edge_records.as_slice();
        let ends = |h: HalfEdgeId| {
            let (a, b) = (self.origin(h), self.target(h));
            (a.min(b), a.max(b))
        };
        let mut members = 0;
        let bound = if L::Opposite::CELLS > 0 { 3 * self.face_count } else { 0 };
        records("edge_records", words, bound, |place, record| {
            let mut along = build::half_edges(record);
            let first = HalfEdgeId::new(record[0] as usize);
            members += record.len();
            let is_one_edge = along.all(|h| ends(h) == ends(first) && self.edge_place(h) == Some(place));
            let is_pair =
                record.len() == 2 && self.origin(first) != self.origin(HalfEdgeId::new(record[1] as usize));
            is_one_edge && record.is_sorted_by(|a, b| a < b) && !is_pair
        })?;
        let half_edges = (0..self.opposite.as_slice().len()).map(HalfEdgeId::new);
        if half_edges.filter(|&h| self.edge_place(h).is_some()).count() != members {
            return Err(Invalid::column(Self::LINKS, "names a record that does not have the half-edge"));
        }
        Ok(())
    }

    /// Each record is of one vertex, which names it.
    pub(super) fn check_vertex_records(&self) -> Checked {
        let (words, outgoing) = (self.vertex_records.as_slice(), self.outgoing.as_slice());
        let mut owners = 0;
        records("vertex_records", words, 3 * self.face_count, |place, record| {
            owners += 1;
            let v = self.origin(HalfEdgeId::new(record[0] as usize));
            outgoing[v.index()].number() == Some(place)
        })?;
        if outgoing.iter().filter(|link| link.number().is_some()).count() != owners {
            return Err(Invalid::column("outgoing", "names a record that is not of the vertex"));
        }
        Ok(())
    }

    /// The starts of the fans of `v`; records are in order.
    #[inline]
    pub(super) fn fan_starts(&self, v: VertexId) -> impl Iterator<Item = HalfEdgeId> {
        let link = self.outgoing.as_slice()[v.index()];
        let words = self.vertex_records.as_slice();
        let record = link.number().map_or(&[][..], |place| build::record(words, place));
        link.half_edge().into_iter().chain(build::half_edges(record))
    }

    /// Without a start for each vertex, what has no opposite cannot be told from what could have one but by looking
    /// for it.
    pub(super) fn compare_opposites(&self) -> Checked {
        let faces = self.faces().map(|f| self.face_vertices(f).map(|v| v.index() as u32));
        let faces = memory::collected(faces)?;
        let fresh = &mut Spare::default();
        let (n, pairing) = (self.vertex_count, Pairing::Auto);
        let found = build::links::<LinkOf<L>>(n, &faces, pairing, false, Self::HOLDS, fresh)?;
        let link = |i: usize| self.link_if_any(HalfEdgeId::new(i)).half_edge();
        let differs = |i: &usize| found.opposite[*i].half_edge() != link(*i);
        if let Some(index) = (0..found.opposite.len()).find(differs) {
            let problem = Invalid::element(Self::LINKS, index, "is not what lies across the edge");
            return Err(Self::in_its_cell(problem));
        }
        if self.edge_records.as_slice() != found.edge_records.words {
            return Err(Invalid::column("edge_records", "are not those of the irregular edges"));
        }
        Ok(())
    }

    /// The list has the least half-edge of every edge, ascending, and the index is its inverse.
    pub(super) fn check_edge_list(&self) -> Checked {
        let (list, index) = (self.edge_list.as_slice(), self.edge_index.as_slice());
        if EdgeList::<L>::CELLS == 0 || L::Opposite::CELLS == 0 {
            return Ok(());
        }
        check::handles("edge_list", list, 3 * self.face_count)?;
        let linked = Linked(self);
        let mut count = 0;
        for h in self.half_edges() {
            let least = linked.edge_fan(h).nth(1).map_or(h, |other| other.min(h));
            if least == h && list.get(count) != Some(&h) {
                return Err(Invalid::column(
                    "edge_list",
                    "is not the least half-edge of each edge, ascending",
                ));
            }
            let is_named = |e: onering_core::EdgeId| match least == h {
                true => e.index() == count,
                false => e == index[least.index()],
            };
            if index.get(h.index()).is_some_and(|&e| !is_named(e)) {
                return Err(Invalid::element("edge_index", h.index(), "is not the place in the list"));
            }
            count += usize::from(least == h);
        }
        if count == list.len() {
            return Ok(());
        }
        Err(Invalid::column("edge_list", "has more half-edges than there are edges"))
    }

    /// The list has the first half-edge of every curve, ascending, and each boundary half-edge names its own.
    pub(super) fn check_curves(&self) -> Checked {
        let starts = self.curve_list.as_slice();
        if L::Curves::CELLS == 0 || L::Opposite::CELLS == 0 {
            return Ok(());
        }
        check::handles("curve_list", starts, 3 * self.face_count)?;
        let linked = Linked(self);
        let is_of = |h: HalfEdgeId, k| self.link_if_any(h).number() == Some(k);
        let mut named = 0;
        for (k, &start) in starts.iter().enumerate() {
            let fail = |problem| Err(Invalid::element("curve_list", k, problem));
            if k > 0 && starts[k - 1] >= start {
                return fail("is not above the one before");
            }
            let mut at = Some(start);
            while let Some(h) = at {
                if !is_of(h, k) {
                    return fail("is a curve whose half-edges do not name it");
                }
                named += 1;
                // A closed curve starts at its least half-edge; only one that ends may have less further on.
                at = boundary::next_along(&linked, h);
                if at == Some(start) {
                    let mut curve = boundary::Curve::new(&linked, start);
                    if curve.any(|h| h < start) {
                        return fail("is not the least half-edge of its curve");
                    }
                    break;
                }
            }
        }
        let on_boundary = self.half_edges().filter(|&h| linked.is_boundary(h)).count();
        if on_boundary == named { Ok(()) } else { Err(Invalid::column("curve_list", "a curve is left out")) }
    }
}

/// Whether the cell of every half-edge is what its number says.
fn follows<H: Handle, T: Element + PartialEq>(
    column: &'static str,
    cells: &[T],
    of: impl Fn(H) -> T,
) -> Checked {
    match (0..cells.len()).position(|i| cells[i] != of(H::new(i))) {
        Some(index) => Err(Invalid::element(column, index, "is not what the faces say")),
        None => Ok(()),
    }
}

/// Whether a column is records of at least two half-edges below `bound` each, all of which are `good`.
fn records(
    column: &'static str,
    words: &[u32],
    bound: usize,
    mut good: impl FnMut(usize, &[u32]) -> bool,
) -> Checked {
    let mut place = 0;
    while place < words.len() {
        let fail = |problem| Err(Invalid::element(column, place, problem));
        let Some(record) = words[place + 1..].get(..words[place] as usize).filter(|r| r.len() >= 2) else {
            return fail("the record has fewer than two half-edges or ends after the column");
        };
        if record.iter().any(|&h| h as usize >= bound) {
            return fail(check::OUT_OF_RANGE);
        }
        if !good(place, record) {
            return fail("the record is not of one element that names it");
        }
        place += 1 + record.len();
    }
    Ok(())
}

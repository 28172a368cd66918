//! The columns of [`MateFace`], and what is checked of them.
use super::cell::{Cell, NEXT, PREV};
use super::fans::Place;
use super::{MateFace, Walk};
use crate::check::{self, Checked, Once};
use crate::columns::{Column, Columns, FromColumns, Invalid, Source};
use crate::link::{Coded, Coding, Link};
use crate::storage::Storage;
use alloc::{borrow::Cow, vec, vec::Vec};
use onering_core::{FaceId, Handle, Incidence, Topology, VertexId, pairing};

impl<S: Storage> Columns for MateFace<S> {
    fn backend(&self) -> Cow<'static, str> {
        Self::backend_name()
    }

    fn counts(&self) -> (usize, usize) {
        (self.vertices.len(), self.cells.len())
    }

    fn columns(&self) -> Vec<Column<'_>> {
        vec![
            Column::new("cells", &self.cells),
            Column::new("vertices", &self.vertices),
            Column::new("records", &self.records),
        ]
    }

    fn validate(&self) -> Checked {
        self.check_cells()?;
        self.check_starts()?;
        self.check_fans()
    }
}

impl<S: Storage> FromColumns for MateFace<S> {
    type Over<T: Storage> = MateFace<T>;

    fn backend_name() -> Cow<'static, str> {
        Cow::Borrowed("mate-face")
    }

    fn from_columns<T: Storage>(source: &impl Source<T>) -> Result<MateFace<T>, Invalid> {
        let (vertex_count, face_count) = (source.vertex_count(), source.face_count());
        pairing::check_counts(vertex_count, face_count, Coded::MAX_HALF_EDGES)?;
        Ok(MateFace {
            cells: source.column("cells", Some(face_count))?,
            vertices: source.column("vertices", Some(vertex_count))?,
            records: source.column("records", None)?,
        })
    }
}

impl<S: Storage> MateFace<S> {
    /// Three different vertices that exist, and mates that exist: then, mates of their mates across the same edge.
    fn check_cells(&self) -> Checked {
        let (vertices, faces) = (self.vertices.len(), self.cells.len());
        let fail = |f, problem| Err(Invalid::element("cells", f, problem));
        let exists = |cell: &Cell| {
            cell.vertices.iter().all(|v| v.index() < vertices)
                && cell.mates.iter().all(|mate| mate.get().is_none_or(|g| g.index() < faces))
        };
        for (f, cell) in self.cells.iter().enumerate() {
            if !exists(cell) {
                return fail(f, check::OUT_OF_RANGE);
            }
            if !check::is_proper(cell.vertices) {
                return fail(f, check::DEGENERATE);
            }
        }
        let is_mated = |f: usize, cell: &Cell, side: usize| {
            let Some(mate) = cell.mates[side].get() else { return true };
            let other = &self.cells[mate.index()];
            let [a, b] = [cell.vertices[NEXT[side]], cell.vertices[PREV[side]]];
            let across = |j: usize| {
                let [c, d] = [other.vertices[NEXT[j]], other.vertices[PREV[j]]];
                (c, d) == (a, b) || (d, c) == (a, b)
            };
            mate.index() != f && (0..3).any(|j| across(j) && other.mates[j].get() == Some(FaceId::new(f)))
        };
        for (f, cell) in self.cells.iter().enumerate() {
            if !(0..3).all(|side| is_mated(f, cell, side)) {
                return fail(f, "is not the mate of its mate");
            }
        }
        Ok(())
    }

    /// Links of vertices lead to cells that have the vertex, and to records of such cells.
    fn check_starts(&self) -> Checked {
        let is_at = |v: usize, f: usize| {
            self.cells.get(f).is_some_and(|cell| cell.vertices.contains(&VertexId::new(v)))
        };
        // No vertex has more fans than there are faces, so a word that is more is neither a length nor a cell.
        if let Some(index) = self.records.iter().position(|&word| word as usize > self.cells.len()) {
            return Err(Invalid::element("records", index, check::OUT_OF_RANGE));
        }
        for (v, link) in self.vertices.iter().enumerate() {
            let is_good = match (link.half_edge(), link.number()) {
                (Some(f), _) => is_at(v, f.index()),
                (None, Some(place)) => {
                    let length = self.records.get(place).map_or(0, |&length| length as usize);
                    let record = self.records.get(place.saturating_add(1)..).unwrap_or(&[]).get(..length);
                    // Its other cells are looked at when the fans are: records that overlap would be read many times.
                    record.is_some_and(|record| record.len() >= 2 && is_at(v, record[0] as usize))
                }
                (None, None) => true,
            };
            if !is_good {
                return Err(Invalid::element("vertices", v, "names no cell of the vertex"));
            }
        }
        Ok(())
    }

    /// Every fan of every vertex is there once, begins where it should, and no two edges lead to one neighbour.
    ///
    /// Mates being pairs of sides, a walk comes round or ends.
    fn check_fans(&self) -> Checked {
        let mut once = Once::new(self.vertices.len())?;
        let (mut walked, mut words) = (0, 0);
        for v in self.vertices() {
            let fail = |problem| Err(Invalid::element("vertices", v.index(), problem));
            let place_of = |f: FaceId| {
                let cell = &self.cells[f.index()];
                Place::of(cell, cell.position(v))
            };
            let mut previous = None;
            let (first, further) = self.starts(v);
            for start in first.into_iter().chain(further) {
                let is_here = self.cells.get(start.index()).is_some_and(|cell| cell.vertices.contains(&v));
                if !is_here || previous >= Some((place_of(start), start)) {
                    return fail("fans are not in order, or one is there twice");
                }
                previous = Some((place_of(start), start));
                for (h, _) in Walk::new(&self.cells, v, Some(start)) {
                    walked += 1;
                    let f = FaceId::new(h.index() / 3);
                    if previous > Some((place_of(f), f)) {
                        return fail("a fan does not start where it should");
                    }
                }
            }
            if let Some(place) = self.vertices[v.index()].number() {
                words += 1 + self.records[place] as usize;
            }
            if !self.neighbours(v).fold(true, |all, w| all & once.is_new(v, w)) {
                return fail("two edges lead to the same neighbour");
            }
        }
        if walked != self.half_edge_count() {
            return Err(Invalid::column("vertices", "a fan is left out"));
        }
        if words != self.records.len() {
            return Err(Invalid::column("records", "has records of no vertex"));
        }
        Ok(())
    }
}

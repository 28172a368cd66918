//! The columns of [`Table`], and what is checked of them.
use super::linked::Linked;
use super::{EdgeIndex, EdgeList, RecordsOf, Table};
use crate::check::{self, Checked};
use crate::column::{Cells, Policy};
use crate::columns::{Column, Columns, FromColumns, Invalid, Source};
use crate::layout::Layout;
use crate::link::Coding;
use crate::storage::Storage;
use alloc::{borrow::Cow, string::String, vec::Vec};
use onering_core::{Handle, Topology, pairing};

/// `CheL2` is `che-l2` in the registry.
fn dashed(name: &str) -> String {
    let mut dashed = String::new();
    for (i, letter) in name.char_indices() {
        if i > 0 && letter.is_uppercase() {
            dashed.push('-');
        }
        dashed.push(letter.to_ascii_lowercase());
    }
    dashed
}

impl<L: Layout, S: Storage> Columns for Table<L, S> {
    fn backend(&self) -> Cow<'static, str> {
        Self::backend_name()
    }

    fn counts(&self) -> (usize, usize) {
        (self.vertex_count, self.face_count)
    }

    fn columns(&self) -> Vec<Column<'_>> {
        let mut columns = Vec::new();
        let mut list = |cells: usize, column| columns.extend((cells > 0).then_some(column));
        list(L::Origin::CELLS, Column::new("origin", self.origin.as_slice()));
        list(L::Target::CELLS, Column::new("target", self.target.as_slice()));
        list(L::Next::CELLS, Column::new("next", self.next.as_slice()));
        list(L::Prev::CELLS, Column::new("prev", self.prev.as_slice()));
        list(L::Opposite::CELLS, Column::new(Self::LINKS, self.opposite.as_slice()));
        list(L::Outgoing::CELLS, Column::new("outgoing", self.outgoing.as_slice()));
        list(EdgeList::<L>::CELLS, Column::new("edge_list", self.edge_list.as_slice()));
        list(EdgeIndex::<L>::CELLS, Column::new("edge_index", self.edge_index.as_slice()));
        list(L::Curves::CELLS, Column::new("curve_list", self.curve_list.as_slice()));
        list(RecordsOf::<L>::CELLS, Column::new("edge_records", self.edge_records.as_slice()));
        list(RecordsOf::<L>::CELLS, Column::new("vertex_records", self.vertex_records.as_slice()));
        columns
    }

    fn validate(&self) -> Checked {
        self.check_corners()?;
        if !Self::PAIRS {
            return Ok(());
        }
        if let Some(f) = self.faces().find(|&f| !check::is_proper(self.face_vertices(f))) {
            return Err(Invalid::element(self.corner_column(), 3 * f.index(), check::DEGENERATE));
        }
        self.check_links_across()?;
        self.check_links("outgoing", self.outgoing.as_slice())?;
        self.check_edge_records()?;
        let linked = Linked(self);
        if L::Opposite::CELLS > 0 {
            check::opposites(&linked, Self::LINKS).map_err(Self::in_its_cell)?;
            if L::Outgoing::CELLS > 0 {
                self.check_vertex_records()?;
                check::fans(&linked, "outgoing", |v| self.fan_starts(v))?;
            } else {
                self.compare_opposites()?;
            }
        }
        self.check_edge_list()?;
        self.check_curves()
    }
}

impl<L: Layout, S: Storage> FromColumns for Table<L, S> {
    type Over<T: Storage> = Table<L, T>;

    fn backend_name() -> Cow<'static, str> {
        Cow::Owned(dashed(L::NAME))
    }

    fn from_columns<T: Storage>(source: &impl Source<T>) -> Result<Table<L, T>, Invalid> {
        let () = Self::IS_SOUND;
        let (vertex_count, face_count) = (source.vertex_count(), source.face_count());
        pairing::check_counts(vertex_count, face_count, L::Links::MAX_HALF_EDGES)?;
        let (of_vertices, of_half_edges) = (Some(vertex_count), Some(3 * face_count));
        let table = Table {
            vertex_count,
            face_count,
            origin: Cells::build(|| source.column("origin", of_half_edges))?,
            target: Cells::build(|| source.column("target", of_half_edges))?,
            next: Cells::build(|| source.column("next", of_half_edges))?,
            prev: Cells::build(|| source.column("prev", of_half_edges))?,
            opposite: Cells::build(|| source.column(Self::LINKS, of_half_edges))?,
            outgoing: Cells::build(|| source.column("outgoing", of_vertices))?,
            edge_list: Cells::build(|| source.column("edge_list", None))?,
            edge_index: Cells::build(|| source.column("edge_index", of_half_edges))?,
            curve_list: Cells::build(|| source.column("curve_list", None))?,
            edge_records: Cells::build(|| source.column("edge_records", None))?,
            vertex_records: Cells::build(|| source.column("vertex_records", None))?,
        };
        if T::IS_OWNED {
            table.check_turns()?;
        }
        Ok(table)
    }
}

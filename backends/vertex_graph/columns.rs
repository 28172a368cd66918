//! The columns of [`VertexGraph`], and what is checked of them.
use super::{MAX_HALF_EDGES, VertexGraph};
use crate::check::{self, Checked};
use crate::columns::{Column, Columns, FromColumns, Invalid, Source};
use crate::storage::Storage;
use alloc::{borrow::Cow, vec, vec::Vec};
use onering_core::pairing;

impl<S: Storage> Columns for VertexGraph<S> {
    fn backend(&self) -> Cow<'static, str> {
        Self::backend_name()
    }

    fn counts(&self) -> (usize, usize) {
        (self.vertex_count(), 0)
    }

    fn columns(&self) -> Vec<Column<'_>> {
        vec![Column::new("offsets", &self.offsets), Column::new("neighbours", &self.neighbours)]
    }

    fn validate(&self) -> Checked {
        check::offsets("offsets", &self.offsets, self.neighbours.len())?;
        check::handles("neighbours", &self.neighbours, self.vertex_count())?;
        check::symmetric("neighbours", &self.offsets, &self.neighbours)
    }
}

impl<S: Storage> FromColumns for VertexGraph<S> {
    type Over<T: Storage> = VertexGraph<T>;

    fn backend_name() -> Cow<'static, str> {
        Cow::Borrowed("vertex-graph")
    }

    fn from_columns<T: Storage>(source: &impl Source<T>) -> Result<VertexGraph<T>, Invalid> {
        pairing::check_counts(source.vertex_count(), 0, MAX_HALF_EDGES)?;
        Ok(VertexGraph {
            offsets: source.column("offsets", Some(source.vertex_count() + 1))?,
            neighbours: source.column("neighbours", None)?,
        })
    }
}

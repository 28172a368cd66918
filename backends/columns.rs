//! Structures taken apart into named columns, and put together again over columns that lie elsewhere.
//!
//! [`Columns`] lists what a structure keeps; [`FromColumns`] makes it again from a [`Source`], owned or borrowed, without
//! looking at what is in the columns; [`Columns::validate`] does that. `onering::ring` (feature `ring`) makes a file of
//! them.
use crate::storage::{Element, Storage};
use alloc::{borrow::Cow, vec::Vec};
use core::fmt;
use onering_core::BuildError;

/// One array of a structure, as bytes in the order of this machine.
#[derive(Clone, Copy, Debug)]
pub struct Column<'a> {
    /// Its name: each is there once.
    pub name: &'static str,
    /// Bytes of each element.
    pub element_size: usize,
    /// All elements, one after the other, without gaps.
    pub bytes: &'a [u8],
}

impl<'a> Column<'a> {
    /// The column of these elements.
    pub fn new<T: Element>(name: &'static str, elements: &'a [T]) -> Self {
        Self { name, element_size: size_of::<T>(), bytes: bytemuck::cast_slice(elements) }
    }
}

/// A structure as columns.
pub trait Columns {
    /// The name of the structure, as in the registry: `che-l2`.
    fn backend(&self) -> Cow<'static, str>;

    /// Number of vertices, isolated ones included, and of faces; no faces for a structure that knows none.
    fn counts(&self) -> (usize, usize);

    /// Every array that the structure keeps, always in the same order.
    fn columns(&self) -> Vec<Column<'_>>;

    /// Checks all that queries rely on, for columns that may hold anything. A structure that passes answers as one
    /// that was built from its own faces does: no query panics for a handle in range or runs forever. What is looked at
    /// is listed in `onering::ring`, structure by structure.
    ///
    /// O(elements). Takes 4 bytes a vertex of scratch where the structure has neighbourhoods; one that has opposites and
    /// no start for a vertex (`CheL1`) pairs its half-edges again to compare, which takes as long as it took to build.
    ///
    /// # Errors
    /// The first thing found, with its column and element; [`BuildError::OutOfMemory`] for the scratch.
    fn validate(&self) -> Result<(), Invalid>;
}

/// A structure that can be made again from its columns.
pub trait FromColumns: Columns + Sized {
    /// The same structure over another storage.
    type Over<S: Storage>: FromColumns;

    /// The name of the structure, as in the registry: `che-l2`.
    fn backend_name() -> Cow<'static, str>;

    /// The structure of these columns. O(columns), as nothing but their lengths is looked at: unless the columns are
    /// known to be those of such a structure, [`validate`](Columns::validate) has to follow, or queries may
    /// panic or run forever.
    ///
    /// # Errors
    /// A column that is missing or of another length, and counts that the structure cannot hold.
    fn from_columns<S: Storage>(source: &impl Source<S>) -> Result<Self::Over<S>, Invalid>;
}

/// Where columns come from.
pub trait Source<S: Storage> {
    /// Number of vertices.
    fn vertex_count(&self) -> usize;

    /// Number of faces.
    fn face_count(&self) -> usize;

    /// The column of this name, which has to have `length` elements where that is given.
    ///
    /// # Errors
    /// [`Invalid::Missing`], and [`Invalid::Column`] where it has elements of another size or another number of them.
    fn column<T: Element>(&self, name: &'static str, length: Option<usize>) -> Result<S::Slice<T>, Invalid>;
}

/// Why columns are not those of a structure.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Invalid {
    /// A column is not there.
    Missing {
        /// Its name.
        column: &'static str,
    },
    /// A column as a whole is wrong.
    Column {
        /// Its name.
        column: &'static str,
        /// What is wrong with it.
        problem: &'static str,
    },
    /// An element of a column is wrong.
    Element {
        /// The name of the column.
        column: &'static str,
        /// The element, counted from 0.
        index: usize,
        /// What is wrong with it.
        problem: &'static str,
    },
    /// The structure cannot have so many elements, or memory ran out.
    Build(BuildError),
}

impl Invalid {
    pub(crate) fn element(column: &'static str, index: usize, problem: &'static str) -> Self {
        Self::Element { column, index, problem }
    }

    pub(crate) fn column(column: &'static str, problem: &'static str) -> Self {
        Self::Column { column, problem }
    }
}

impl From<BuildError> for Invalid {
    fn from(error: BuildError) -> Self {
        Self::Build(error)
    }
}

impl fmt::Display for Invalid {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Missing { column } => write!(f, "column `{column}` is missing"),
            Self::Column { column, problem } => write!(f, "column `{column}`: {problem}"),
            Self::Element { column, index, problem } => {
                write!(f, "column `{column}`, element {index}: {problem}")
            }
            Self::Build(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for Invalid {}

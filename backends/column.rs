//! What a layout does with one column: [`Stored`], [`Computed`] or [`Absent`].
use crate::storage::{Element, Storage};
use core::{fmt::Debug, marker::PhantomData};

mod sealed {
    pub trait Sealed {}
}

/// What a layout does with one column. Sealed: the three policies below are all there are. (`Clone`, because
/// that is what the derived `Clone` of `Table` asks of a policy.)
pub trait Policy: sealed::Sealed + Clone + 'static {
    /// Cells in memory for each element: 1 or 0.
    const CELLS: usize;
    /// The cells in memory: a slice, or nothing at all.
    type Cells<S: Storage, T: Element>: Cells<S, T>;
}

/// A column that can be read: [`Stored`] or [`Computed`].
#[diagnostic::on_unimplemented(
    message = "this layout does not know the column that this operation reads (it is `{Self}`)",
    note = "the table in `onering::layout` shows which layouts do"
)]
pub trait Answered: Policy {
    /// Cell `i`, or `compute()` where nothing is kept.
    fn get_or<S: Storage, T: Element>(cells: &Self::Cells<S, T>, i: usize, compute: impl FnOnce() -> T) -> T;
}

/// A column that is in memory: [`Stored`] only.
#[diagnostic::on_unimplemented(
    message = "this layout does not keep the column that this operation reads (it is `{Self}`)",
    note = "the table in `onering::layout` shows which layouts do"
)]
pub trait Kept: Answered {
    /// Cell `i`.
    fn get<S: Storage, T: Element>(cells: &Self::Cells<S, T>, i: usize) -> T;
}

/// Construction and size of a column.
pub trait Cells<S: Storage, T: Element>: Debug + Clone + Send + Sync {
    /// Fills the column; one without memory never runs `make`.
    ///
    /// # Errors
    /// Those of `make`.
    fn build<V: Into<S::Slice<T>>, E>(make: impl FnOnce() -> Result<V, E>) -> Result<Self, E>;

    /// The cells; none where nothing is kept.
    fn as_slice(&self) -> &[T];

    /// The cells to be kept elsewhere, where there is memory for any.
    fn into_slice(self) -> Option<S::Slice<T>>;
}

/// Kept in memory: one load.
#[derive(Clone, Copy, Debug)]
pub enum Stored {}

/// Worked out from other columns or from the index: no memory.
#[derive(Clone, Copy, Debug)]
pub enum Computed {}

/// Not known by this layout, so the trait that needs it is not implemented.
#[derive(Clone, Copy, Debug)]
pub enum Absent {}

impl sealed::Sealed for Stored {}
impl sealed::Sealed for Computed {}
impl sealed::Sealed for Absent {}

impl Policy for Stored {
    const CELLS: usize = 1;
    type Cells<S: Storage, T: Element> = InMemory<S, T>;
}

impl Policy for Computed {
    const CELLS: usize = 0;
    type Cells<S: Storage, T: Element> = Nowhere<T>;
}

impl Policy for Absent {
    const CELLS: usize = 0;
    type Cells<S: Storage, T: Element> = Nowhere<T>;
}

impl Answered for Stored {
    #[inline(always)]
    fn get_or<S: Storage, T: Element>(cells: &InMemory<S, T>, i: usize, _: impl FnOnce() -> T) -> T {
        cells.0[i]
    }
}

impl Answered for Computed {
    #[inline(always)]
    fn get_or<S: Storage, T: Element>(_: &Nowhere<T>, _: usize, compute: impl FnOnce() -> T) -> T {
        compute()
    }
}

impl Kept for Stored {
    #[inline(always)]
    fn get<S: Storage, T: Element>(cells: &InMemory<S, T>, i: usize) -> T {
        cells.0[i]
    }
}

/// Cells of a [`Stored`] column.
#[derive(Clone, Debug)]
pub struct InMemory<S: Storage, T: Element>(S::Slice<T>);

impl<S: Storage, T: Element> Cells<S, T> for InMemory<S, T> {
    fn build<V: Into<S::Slice<T>>, E>(make: impl FnOnce() -> Result<V, E>) -> Result<Self, E> {
        Ok(Self(make()?.into()))
    }

    fn as_slice(&self) -> &[T] {
        &self.0
    }

    fn into_slice(self) -> Option<S::Slice<T>> {
        Some(self.0)
    }
}

/// Cells of a column that takes no memory.
#[derive(Clone, Debug)]
pub struct Nowhere<T>(PhantomData<T>);

impl<S: Storage, T: Element> Cells<S, T> for Nowhere<T> {
    fn build<V: Into<S::Slice<T>>, E>(_: impl FnOnce() -> Result<V, E>) -> Result<Self, E> {
        Ok(Self(PhantomData))
    }

    fn as_slice(&self) -> &[T] {
        &[]
    }

    fn into_slice(self) -> Option<S::Slice<T>> {
        None
    }
}

const _: () = assert!(size_of::<Nowhere<u32>>() == 0);

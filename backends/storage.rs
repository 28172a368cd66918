//! Who owns the columns of a structure: itself ([`Owned`]), or something that it borrows them from ([`Borrowed`]).
use alloc::boxed::Box;
use bytemuck::Pod;
use core::{fmt::Debug, marker::PhantomData, ops::Deref};

mod sealed {
    pub trait Sealed {}
}

/// What a column can hold: plain words, of which every pattern of bits is a value. So bytes can be looked at as a
/// column before anything is known of them.
pub trait Element: Pod + Debug + Send + Sync {}

impl<T: Pod + Debug + Send + Sync> Element for T {}

/// Who owns the columns of a structure. Sealed: [`Owned`] and [`Borrowed`] are all there are.
///
/// Every accessor of every structure checks bounds, whoever owns the columns. Turns around a vertex of a
/// [`Table`](crate::Table) that owns its columns do not at each step: nobody else can write to them, and that their
/// links are in range is seen when it is made.
pub trait Storage: sealed::Sealed + Clone + Debug + Send + Sync {
    /// Whether nobody else can write to the columns.
    const IS_OWNED: bool;
    /// One column.
    type Slice<T: Element>: Deref<Target = [T]> + Clone + Debug + Send + Sync;
}

/// The structure has memory of its own: what building gives.
#[derive(Clone, Copy, Debug)]
pub enum Owned {}

/// The columns lie elsewhere, such as in a file that is mapped into memory.
#[derive(Clone, Copy, Debug)]
pub struct Borrowed<'a>(PhantomData<&'a ()>);

impl sealed::Sealed for Owned {}
impl sealed::Sealed for Borrowed<'_> {}

impl Storage for Owned {
    const IS_OWNED: bool = true;
    type Slice<T: Element> = Box<[T]>;
}

impl<'a> Storage for Borrowed<'a> {
    const IS_OWNED: bool = false;
    type Slice<T: Element> = &'a [T];
}

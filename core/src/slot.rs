//! A handle or nothing, in four bytes.
use crate::Handle;
use bytemuck::{Pod, Zeroable};
use core::{fmt, marker::PhantomData};

/// A handle or nothing: what a stored link holds. Nothing is `u32::MAX`.
///
/// A niche in the handle (`NonZero`) would make `Option<H>` as small, but took 1.3 to 1.8 times as long in
/// ring walks, for the subtraction at every step.
#[derive(Clone, Copy, PartialEq, Eq, Hash, Pod, Zeroable)]
#[repr(transparent)]
pub struct Slot<H>(u32, PhantomData<H>);

impl<H: Handle> Slot<H> {
    /// The empty slot.
    pub const NONE: Self = Slot(u32::MAX, PhantomData);

    /// A slot that holds `h`.
    #[inline(always)]
    pub fn some(h: H) -> Self {
        Slot(h.index() as u32, PhantomData)
    }

    /// The handle held, if any.
    #[inline(always)]
    pub fn get(self) -> Option<H> {
        if self.0 == u32::MAX { None } else { Some(H::new(self.0 as usize)) }
    }
}

impl<H: Handle> From<Option<H>> for Slot<H> {
    #[inline(always)]
    fn from(h: Option<H>) -> Self {
        h.map_or(Self::NONE, Self::some)
    }
}

impl<H: Handle> fmt::Debug for Slot<H> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.get() {
            Some(h) => h.fmt(f),
            None => f.write_str("-"),
        }
    }
}

const _: () = assert!(size_of::<Slot<crate::HalfEdgeId>>() == 4);

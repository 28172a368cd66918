//! The two codings of a link: [`Plain`] and [`Coded`].
use crate::storage::Element;
use bytemuck::{Pod, Zeroable};
use core::fmt;
use onering_core::{HalfEdgeId, Handle, Slot};

mod sealed {
    pub trait Sealed {}
}

/// How a four-byte cell says "this half-edge" and "none". Sealed: [`Plain`] and [`Coded`] are all there are. With a limit
/// above theirs, the number of half-edges could overflow, and what turns without checks of bounds rely on were not so.
///
/// ```compile_fail,E0277
/// enum Boundless {}
/// impl onering::link::Coding for Boundless {
///     const MAX_HALF_EDGES: usize = usize::MAX;
///     type Link = onering::Slot<onering::HalfEdgeId>;
/// }
/// ```
pub trait Coding: sealed::Sealed + 'static {
    /// The most half-edges that it can name.
    const MAX_HALF_EDGES: usize;
    /// One link.
    type Link: Link;
}

/// One link: a half-edge, none, or the number of something else. Sealed: that a link always says the same is what turns
/// without checks of bounds rely on.
pub trait Link: sealed::Sealed + Element + From<Slot<HalfEdgeId>> {
    /// The half-edge that it leads to, if it leads to one.
    fn half_edge(self) -> Option<HalfEdgeId>;

    /// The number that it stands for, if it stands for one: a curve or a place in the records.
    fn number(self) -> Option<usize>;

    /// A link that stands for `number`, where the coding has any and it is not too large.
    fn numbered(number: usize) -> Option<Self>;
}

/// A half-edge or none: up to 2^32 - 2 half-edges.
#[derive(Debug)]
pub enum Plain {}

/// A half-edge below 2^31, or a negative number as in Campagna et al. (1998): -1 for none, and -(k + 2) for
/// number k.
#[derive(Debug)]
pub enum Coded {}

impl sealed::Sealed for Plain {}
impl sealed::Sealed for Coded {}
impl sealed::Sealed for Slot<HalfEdgeId> {}
impl sealed::Sealed for CodedLink {}

impl Coding for Plain {
    const MAX_HALF_EDGES: usize = u32::MAX as usize - 1;
    type Link = Slot<HalfEdgeId>;
}

impl Coding for Coded {
    const MAX_HALF_EDGES: usize = i32::MAX as usize;
    type Link = CodedLink;
}

impl Link for Slot<HalfEdgeId> {
    #[inline(always)]
    fn half_edge(self) -> Option<HalfEdgeId> {
        self.get()
    }

    #[inline(always)]
    fn number(self) -> Option<usize> {
        None
    }

    fn numbered(_: usize) -> Option<Self> {
        None
    }
}

/// A link of [`Coded`].
#[derive(Clone, Copy, PartialEq, Eq, Pod, Zeroable)]
#[repr(transparent)]
pub struct CodedLink(i32);

impl From<Slot<HalfEdgeId>> for CodedLink {
    #[inline(always)]
    fn from(h: Slot<HalfEdgeId>) -> Self {
        Self(h.get().map_or(-1, |h| h.index() as i32))
    }
}

impl Link for CodedLink {
    #[inline(always)]
    fn half_edge(self) -> Option<HalfEdgeId> {
        if self.0 < 0 { None } else { Some(HalfEdgeId::new(self.0 as usize)) }
    }

    #[inline(always)]
    fn number(self) -> Option<usize> {
        if self.0 < -1 { Some((-2 - self.0) as usize) } else { None }
    }

    fn numbered(number: usize) -> Option<Self> {
        Some(Self(-2 - i32::try_from(number).ok().filter(|&k| k < i32::MAX)?))
    }
}

impl fmt::Debug for CodedLink {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.number() {
            Some(k) => write!(f, "#{k}"),
            None => Slot::from(self.half_edge()).fmt(f),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_coded_link_keeps_what_it_is_given() {
        let last = HalfEdgeId::new(i32::MAX as usize - 1);
        for h in [None, Some(HalfEdgeId::new(0)), Some(last)] {
            let link = CodedLink::from(Slot::from(h));
            assert_eq!((link.half_edge(), link.number()), (h, None));
        }
        for k in [0, 1, i32::MAX as usize - 1] {
            let link = CodedLink::numbered(k).unwrap();
            assert_eq!((link.half_edge(), link.number()), (None, Some(k)));
        }
        assert_eq!(CodedLink::numbered(i32::MAX as usize), None);
        assert_eq!(CodedLink::numbered(usize::MAX), None);
    }
}

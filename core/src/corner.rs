//! Index arithmetic of corner-numbered backends: face `f` has the half-edges `3f`, `3f + 1`, `3f + 2`.
//!
//! Only backends call this. The contract of [`Topology`](crate::Topology) says nothing about indices.
use crate::Handle;

/// `h + 1` inside its run of three.
#[inline(always)]
pub fn next<H: Handle>(h: H) -> H {
    let i = h.index();
    H::new(if i % 3 == 2 { i - 2 } else { i + 1 })
}

/// `h - 1` inside its run of three.
#[inline(always)]
pub fn prev<H: Handle>(h: H) -> H {
    let i = h.index();
    H::new(if i.is_multiple_of(3) { i + 2 } else { i - 1 })
}

/// The run of three that `h` is in.
#[inline(always)]
pub fn face<H: Handle, F: Handle>(h: H) -> F {
    F::new(h.index() / 3)
}

/// The first of the run of three of `f`.
#[inline(always)]
pub fn first<F: Handle, H: Handle>(f: F) -> H {
    H::new(3 * f.index())
}

/// The vertex that half-edge `h` of a face list starts at.
#[inline(always)]
pub fn origin(faces: &[[u32; 3]], h: usize) -> u32 {
    faces.as_flattened()[h]
}

/// The vertex that half-edge `h` of a face list ends at.
#[inline(always)]
pub fn target(faces: &[[u32; 3]], h: usize) -> u32 {
    faces.as_flattened()[if h % 3 == 2 { h - 2 } else { h + 1 }]
}

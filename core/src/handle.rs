//! Handles: typed indices of four bytes.
use bytemuck::{Pod, Zeroable};
use core::{fmt, hash::Hash, iter::FusedIterator, marker::PhantomData, ops::Range};

#[cfg(feature = "parallel")]
mod parallel;
#[cfg(feature = "parallel")]
pub use parallel::ParallelHandles;

/// A copyable name of one kind of mesh element: an index that cannot be mixed up with another kind's.
///
/// A handle is valid for the mesh that gave it. Asking another mesh panics where its index is out of range.
pub trait Handle: Copy + Eq + Ord + Hash + fmt::Debug + Send + Sync + 'static {
    /// The largest index that a handle can hold.
    const MAX_INDEX: usize;

    /// The handle with this index, which is at most [`Self::MAX_INDEX`]. A larger one panics in debug builds, and
    /// in release builds names another element: counts are checked once, when a mesh is built.
    fn new(index: usize) -> Self;

    /// The index that this handle stands for.
    fn index(self) -> usize;
}

macro_rules! handles {
    ($($(#[$doc:meta])* $name:ident $letter:literal;)+) => {$(
        $(#[$doc])*
        #[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Pod, Zeroable)]
        #[repr(transparent)]
        pub struct $name(u32);

        impl Handle for $name {
            const MAX_INDEX: usize = u32::MAX as usize - 1;

            #[inline(always)]
            fn new(index: usize) -> Self {
                debug_assert!(index <= Self::MAX_INDEX);
                Self(index as u32)
            }

            #[inline(always)]
            fn index(self) -> usize {
                self.0 as usize
            }
        }

        impl fmt::Debug for $name {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, concat!($letter, "{}"), self.0)
            }
        }
    )+};
}

handles! {
    /// A vertex.
    VertexId "v";
    /// A half-edge: one side of one triangle.
    HalfEdgeId "h";
    /// A triangle.
    FaceId "f";
    /// An undirected edge.
    EdgeId "e";
    /// A boundary curve.
    CurveId "b";
}

/// The handles with the indices below a count, in order: iterator of `vertices`, `faces`, `edges` and `curves`.
///
/// With the feature `parallel` it becomes an indexed parallel iterator of rayon by `into_par_iter`.
#[derive(Clone, Debug)]
pub struct Handles<H> {
    range: Range<usize>,
    kind: PhantomData<fn() -> H>,
}

impl<H: Handle> Handles<H> {
    /// The handles with the indices `0..count`.
    pub fn below(count: usize) -> Self {
        Self { range: 0..count, kind: PhantomData }
    }
}

impl<H: Handle> Iterator for Handles<H> {
    type Item = H;

    #[inline]
    fn next(&mut self) -> Option<H> {
        self.range.next().map(H::new)
    }

    #[inline]
    fn size_hint(&self) -> (usize, Option<usize>) {
        self.range.size_hint()
    }

    #[inline]
    fn nth(&mut self, n: usize) -> Option<H> {
        self.range.nth(n).map(H::new)
    }
}

impl<H: Handle> DoubleEndedIterator for Handles<H> {
    #[inline]
    fn next_back(&mut self) -> Option<H> {
        self.range.next_back().map(H::new)
    }
}

impl<H: Handle> ExactSizeIterator for Handles<H> {}
impl<H: Handle> FusedIterator for Handles<H> {}

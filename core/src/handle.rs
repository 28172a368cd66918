//! Handles: typed indices of four bytes.
use bytemuck::{Pod, Zeroable};
use core::{fmt, hash::Hash};

/// A copyable name of one kind of mesh element: an index that cannot be mixed up with another kind's.
///
/// A handle is valid for the mesh that gave it. Asking another mesh panics where its index is out of range.
pub trait Handle: Copy + Eq + Ord + Hash + fmt::Debug + Send + Sync + 'static {
    /// The largest index that a handle can hold.
    const MAX_INDEX: usize;

    /// The handle with this index. Panics above [`Self::MAX_INDEX`] in debug builds.
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

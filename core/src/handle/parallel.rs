//! [`Handles`] for all threads of rayon.
use super::{Handle, Handles};
use rayon::iter::{
    IndexedParallelIterator, IntoParallelIterator, ParallelIterator,
    plumbing::{Consumer, Producer, ProducerCallback, UnindexedConsumer, bridge},
};

/// The handles with the indices below a count, for all threads of rayon: what `into_par_iter` makes of [`Handles`].
///
/// ```
/// use onering_core::{FromFaces, Handle, Incidence, Map, Topology, VertexId};
/// use rayon::prelude::*;
/// # use onering::CheL2 as Mesh;
/// let mesh = Mesh::from_faces(4, &[[0, 1, 2], [2, 1, 3]])?;
/// let sum_around = |v| mesh.one_ring(v).map(Handle::index).sum();
/// let sums: Vec<usize> = mesh.vertices().into_par_iter().map(sum_around).collect();
/// assert_eq!(Map::<VertexId, _>::from(sums).as_slice(), [3, 5, 4, 3]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
#[derive(Clone, Debug)]
pub struct ParallelHandles<H>(Handles<H>);

impl<H: Handle> IntoParallelIterator for Handles<H> {
    type Item = H;
    type Iter = ParallelHandles<H>;

    fn into_par_iter(self) -> ParallelHandles<H> {
        ParallelHandles(self)
    }
}

impl<H: Handle> ParallelIterator for ParallelHandles<H> {
    type Item = H;

    fn drive_unindexed<C: UnindexedConsumer<H>>(self, consumer: C) -> C::Result {
        bridge(self, consumer)
    }

    fn opt_len(&self) -> Option<usize> {
        Some(self.len())
    }
}

impl<H: Handle> IndexedParallelIterator for ParallelHandles<H> {
    fn len(&self) -> usize {
        self.0.len()
    }

    fn drive<C: Consumer<H>>(self, consumer: C) -> C::Result {
        bridge(self, consumer)
    }

    fn with_producer<B: ProducerCallback<H>>(self, callback: B) -> B::Output {
        callback.callback(self)
    }
}

/// A piece is a range like the whole, so that its loop is that of one thread.
impl<H: Handle> Producer for ParallelHandles<H> {
    type Item = H;
    type IntoIter = Handles<H>;

    fn into_iter(self) -> Handles<H> {
        self.0
    }

    fn split_at(self, index: usize) -> (Self, Self) {
        let Handles { range, kind } = self.0;
        let middle = range.start + index;
        let half = |range| Self(Handles { range, kind });
        (half(range.start..middle), half(middle..range.end))
    }
}

//! The same work for several things, by all threads of rayon with the feature `parallel`, else one after the other.
use alloc::vec::Vec;

/// How many pieces to cut so many things into, of which a piece should have `least` to be worth a thread. Where that is
/// one, no thread is started.
pub(crate) fn pieces(count: usize, least: usize) -> usize {
    let most = (count / least).max(1);
    #[cfg(feature = "parallel")]
    if most > 1 {
        return most.min(rayon::current_num_threads());
    }
    most.min(1)
}

/// What `work` makes of each item, in their order.
pub(crate) fn map<T: Send, R: Send>(items: Vec<T>, work: impl Fn(T) -> R + Sync) -> Vec<R> {
    #[cfg(feature = "parallel")]
    if items.len() > 1 {
        use rayon::prelude::*;
        return items.into_par_iter().map(&work).collect();
    }
    items.into_iter().map(work).collect()
}

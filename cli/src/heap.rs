//! Counts the bytes on the heap, so that what a structure takes is measured and not only worked out.
//!
//! Two relaxed counters: no allocation waits for another. The timed kernels but for building hardly allocate.

use std::alloc::{GlobalAlloc, Layout, System};
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

static LIVE: AtomicUsize = AtomicUsize::new(0);
static PEAK: AtomicUsize = AtomicUsize::new(0);

/// The system's allocator, counted.
#[derive(Debug)]
pub(crate) struct Counting;

/// What the heap held over a stretch of work, beyond what it held before.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Growth {
    /// Bytes that are still there.
    pub(crate) kept: usize,
    /// The most that there were at once.
    pub(crate) peak: usize,
}

/// Runs `work` and tells how the heap grew. Only where no other thread allocates meanwhile.
pub(crate) fn growth<T>(work: impl FnOnce() -> T) -> (T, Growth) {
    let before = LIVE.load(Relaxed);
    PEAK.store(before, Relaxed);
    let result = work();
    let kept = LIVE.load(Relaxed).saturating_sub(before);
    (result, Growth { kept, peak: PEAK.load(Relaxed).saturating_sub(before) })
}

fn add(bytes: usize) {
    let live = LIVE.fetch_add(bytes, Relaxed) + bytes;
    if live > PEAK.load(Relaxed) {
        PEAK.fetch_max(live, Relaxed);
    }
}

// SAFETY: each method hands its arguments on to the system's as they came and its result back, so that the system's
// contract is kept exactly where the caller keeps ours. Counting neither allocates nor panics.
#[allow(unsafe_code, reason = "an allocator is an unsafe trait: there is no safe way to be one")]
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's promises are the same.
        let block = unsafe { System.alloc(layout) };
        if !block.is_null() {
            add(layout.size());
        }
        block
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's promises are the same.
        let block = unsafe { System.alloc_zeroed(layout) };
        if !block.is_null() {
            add(layout.size());
        }
        block
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: the block came from `System`, through one of the others, with this layout.
        unsafe { System.dealloc(block, layout) };
        LIVE.fetch_sub(layout.size(), Relaxed);
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: the block came from `System`, through one of the others, with this layout.
        let moved = unsafe { System.realloc(block, layout, size) };
        if !moved.is_null() {
            LIVE.fetch_sub(layout.size(), Relaxed);
            add(size);
        }
        moved
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_freed_counts_for_the_peak_alone() {
        // Other tests allocate meanwhile, so that only large blocks tell.
        let (kept, growth) = growth(|| {
            drop(vec![1_u8; 64 << 20]);
            vec![1_u8; 32 << 20]
        });
        assert_eq!(kept.len(), 32 << 20);
        assert!(growth.peak >= 60 << 20 && (28 << 20..48 << 20).contains(&growth.kept), "{growth:?}");
    }
}

//! Counts the bytes on the heap, so that what a structure takes is measured and not only worked out.
//!
//! Two relaxed counters: no allocation waits for another. The timed kernels but for building hardly allocate.

use onering::{BuildError, memory};
use std::alloc::{GlobalAlloc, Layout, System};
use std::hint::black_box;
use std::sync::atomic::{AtomicUsize, Ordering::Relaxed};

static HEAP: Counters = Counters::new();

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
    HEAP.growth(work)
}

/// Drops `value` and tells how many bytes of the heap that freed; as for [`growth`], no other thread allocates meanwhile.
pub(crate) fn freed<T>(value: T) -> usize {
    HEAP.freed(value)
}

/// An error where so many bytes more cannot be had. To be asked before what would end the process without them.
pub(crate) fn has_room(bytes: usize) -> Result<(), BuildError> {
    // What nobody looks at might not be allocated at all.
    memory::with_room::<u8>(bytes).map(|room| drop(black_box(room)))
}

/// Bytes that are held, and the most that were.
struct Counters {
    live: AtomicUsize,
    peak: AtomicUsize,
}

impl Counters {
    const fn new() -> Self {
        Self { live: AtomicUsize::new(0), peak: AtomicUsize::new(0) }
    }

    fn growth<T>(&self, work: impl FnOnce() -> T) -> (T, Growth) {
        let before = self.live.load(Relaxed);
        self.peak.store(before, Relaxed);
        let result = work();
        let kept = self.live.load(Relaxed).saturating_sub(before);
        (result, Growth { kept, peak: self.peak.load(Relaxed).saturating_sub(before) })
    }

    fn freed<T>(&self, value: T) -> usize {
        let before = self.live.load(Relaxed);
        drop(value);
        before.saturating_sub(self.live.load(Relaxed))
    }

    fn add(&self, bytes: usize) {
        let live = self.live.fetch_add(bytes, Relaxed) + bytes;
        if live > self.peak.load(Relaxed) {
            self.peak.fetch_max(live, Relaxed);
        }
    }

    fn subtract(&self, bytes: usize) {
        self.live.fetch_sub(bytes, Relaxed);
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
            HEAP.add(layout.size());
        }
        block
    }

    unsafe fn alloc_zeroed(&self, layout: Layout) -> *mut u8 {
        // SAFETY: the caller's promises are the same.
        let block = unsafe { System.alloc_zeroed(layout) };
        if !block.is_null() {
            HEAP.add(layout.size());
        }
        block
    }

    unsafe fn dealloc(&self, block: *mut u8, layout: Layout) {
        // SAFETY: the block came from `System`, through one of the others, with this layout.
        unsafe { System.dealloc(block, layout) };
        HEAP.subtract(layout.size());
    }

    unsafe fn realloc(&self, block: *mut u8, layout: Layout, size: usize) -> *mut u8 {
        // SAFETY: the block came from `System`, through one of the others, with this layout.
        let moved = unsafe { System.realloc(block, layout, size) };
        if !moved.is_null() {
            HEAP.subtract(layout.size());
            HEAP.add(size);
        }
        moved
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_was_freed_counts_for_the_peak_alone() {
        // Counters of its own: other tests allocate meanwhile.
        let heap = Counters::new();
        heap.add(5);
        let ((), growth) = heap.growth(|| {
            heap.add(64);
            heap.subtract(64);
            heap.add(32);
        });
        assert_eq!(growth, Growth { kept: 32, peak: 64 });
        let ((), growth) = heap.growth(|| heap.subtract(32));
        assert_eq!(growth, Growth { kept: 0, peak: 0 });
        struct Frees<'a>(&'a Counters);
        impl Drop for Frees<'_> {
            fn drop(&mut self) {
                self.0.subtract(3);
            }
        }
        assert_eq!(heap.freed(Frees(&heap)), 3);
    }
}

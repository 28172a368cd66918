//! Asks the system for huge pages where a table is large. Its memory then comes 2 MiB at a time instead of 4 KiB, which
//! takes a fraction of the time, and the processor finds its place in fewer steps.
use alloc::vec::Vec;

/// A table of fewer bytes is left alone. It is the limit of NumPy as well.
#[cfg(all(feature = "huge-pages", target_os = "linux"))]
const LEAST: usize = 4 << 20;

/// Where pages are larger the advice is refused, and nothing changes.
#[cfg(all(feature = "huge-pages", target_os = "linux"))]
const PAGE: usize = 4 << 10;

/// Before the table is written for the first time, or for the first time beyond what it had before.
#[cfg(all(feature = "huge-pages", target_os = "linux"))]
pub(super) fn advise<T>(table: &mut Vec<T>) {
    let bytes = table.capacity() * size_of::<T>();
    if bytes < LEAST {
        return;
    }
    // Out to whole pages: so all of a block that is mapped has the same advice, and can still grow by moving its pages.
    let start = table.as_mut_ptr().cast::<u8>();
    let before = start.addr() % PAGE;
    let length = (before + bytes).next_multiple_of(PAGE);
    #[expect(
        unsafe_code,
        reason = "this advice changes the contents of no page, whoever has it, only its size"
    )]
    // SAFETY: as the reason says. What the system answers does not matter: without huge pages all is as it was.
    unsafe {
        libc::madvise(start.wrapping_sub(before).cast(), length, libc::MADV_HUGEPAGE);
    }
}

/// Other systems are not asked.
#[cfg(not(all(feature = "huge-pages", target_os = "linux")))]
pub(super) fn advise<T>(_table: &mut Vec<T>) {}

#[cfg(all(test, feature = "huge-pages", target_os = "linux"))]
mod tests {
    use crate::memory::{filled, resize, zeroed};

    #[test]
    fn tables_hold_what_they_held() {
        let mut table = filled(3 << 20, 7_u32).unwrap();
        resize(&mut table, 40 << 20, 8).unwrap();
        assert!(
            table[..3 << 20].iter().all(|&cell| cell == 7) && table[3 << 20..].iter().all(|&cell| cell == 8)
        );
        resize(&mut table, 5 << 20, 0).unwrap();
        table.shrink_to_fit();
        assert!(table[3 << 20..].iter().all(|&cell| cell == 8));
        assert!(zeroed::<u64>(1 << 20).unwrap().iter().all(|&cell| cell == 0));
    }
}

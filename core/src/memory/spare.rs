//! [`Spare`]: tables to be used again.
use super::{reserve_exact, resize, with_room, zeroed};
use crate::BuildError;
use alloc::vec::Vec;
use bytemuck::Pod;

/// Tables to be used again, which a [`Builder`](crate::Builder) hands from mesh to mesh. The default is none, and that
/// stays so: whatever is built with it is built in fresh memory, and scratch is freed as soon as it is done with.
///
/// Cells are any of four bytes, whatever they were before. Others do not compile:
///
/// ```compile_fail,E0080
/// let _ = onering_core::memory::Spare::default().table::<u64>(1);
/// ```
#[derive(Debug, Default)]
pub struct Spare {
    keeps: bool,
    words: Vec<Vec<u32>>,
    /// Scratch of the pairing, of which there is only one at a time.
    filters: Vec<u64>,
}

impl Spare {
    /// None yet, but what is given to [`keep`](Self::keep) is kept.
    pub(crate) fn kept() -> Self {
        Self { keeps: true, ..Self::default() }
    }

    /// A table of `count` cells that hold anything: all are to be written.
    ///
    /// # Errors
    /// [`BuildError::OutOfMemory`].
    pub fn table<T: Pod>(&mut self, count: usize) -> Result<Vec<T>, BuildError> {
        const { assert!(is_word::<T>()) };
        let Some(mut words) = self.near(count) else { return zeroed(count) };
        resize(&mut words, count, 0)?;
        Ok(bytemuck::cast_vec(words))
    }

    /// An empty table with room for `count` cells.
    ///
    /// # Errors
    /// [`BuildError::OutOfMemory`].
    pub fn room<T: Pod>(&mut self, count: usize) -> Result<Vec<T>, BuildError> {
        const { assert!(is_word::<T>()) };
        let Some(mut words) = self.near(count) else { return with_room(count) };
        words.clear();
        reserve_exact(&mut words, count)?;
        Ok(bytemuck::cast_vec(words))
    }

    /// Takes a table that is no longer needed.
    pub fn keep<T: Pod>(&mut self, table: Vec<T>) {
        const { assert!(is_word::<T>()) };
        if self.keeps && table.capacity() > 0 {
            self.words.push(bytemuck::cast_vec(table));
        }
    }

    /// So many zeros.
    pub(crate) fn filters(&mut self, count: usize) -> Result<Vec<u64>, BuildError> {
        let mut filters = core::mem::take(&mut self.filters);
        if filters.capacity() == 0 {
            return zeroed(count);
        }
        filters.clear();
        resize(&mut filters, count, 0)?;
        Ok(filters)
    }

    pub(crate) fn keep_filters(&mut self, filters: Vec<u64>) {
        if self.keeps {
            self.filters = filters;
        }
    }

    /// The table of nearest size. None of more than twice the size or less than half of it: the mesh would keep its
    /// exact size alone, and a small mesh between large ones would lose their memory.
    fn near(&mut self, count: usize) -> Option<Vec<u32>> {
        let is_near = |size: usize| size / 2 <= count && count / 2 <= size;
        let sizes = self.words.iter().map(Vec::capacity).enumerate();
        let (i, _) =
            sizes.filter(|&(_, size)| is_near(size)).min_by_key(|&(_, size)| size.abs_diff(count))?;
        Some(self.words.swap_remove(i))
    }
}

/// Whether a table of words can hold it.
const fn is_word<T>() -> bool {
    size_of::<T>() == size_of::<u32>() && align_of::<T>() == align_of::<u32>()
}

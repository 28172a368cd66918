//! Growing vectors without aborting where memory ends.

use crate::Error;

/// Pushes, or says that memory ran out.
#[inline(always)]
pub(crate) fn push<T>(list: &mut Vec<T>, item: T) -> Result<(), Error> {
    if list.len() == list.capacity() {
        grow(list)?;
    }
    list.push(item);
    Ok(())
}

// Out of line: `push` sits in the innermost loop, this runs a few dozen times a file.
#[cold]
fn grow<T>(list: &mut Vec<T>) -> Result<(), Error> {
    reserve(list, 1)
}

/// Room for `more` items, or an error that says how much was asked for.
pub(crate) fn reserve<T>(list: &mut Vec<T>, more: usize) -> Result<(), Error> {
    let bytes = list.len().saturating_add(more).saturating_mul(size_of::<T>());
    list.try_reserve(more).map_err(|_| Error::OutOfMemory { path: None, bytes })
}

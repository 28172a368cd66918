//! Tables whose memory is asked for first: a huge count is an error, not an abort.
use crate::BuildError;
use alloc::{borrow::Cow, vec::Vec};

mod huge_pages;
mod spare;
pub use spare::Spare;

/// An empty table with room for exactly `count` values.
///
/// # Errors
/// [`BuildError::OutOfMemory`], as for all functions here.
pub fn with_room<T>(count: usize) -> Result<Vec<T>, BuildError> {
    let mut table = Vec::new();
    reserve_exact(&mut table, count)?;
    Ok(table)
}

/// A table of `count` times `value`.
#[expect(clippy::missing_errors_doc, reason = "said once, at `with_room`")]
pub fn filled<T: Clone>(count: usize, value: T) -> Result<Vec<T>, BuildError> {
    let mut table = with_room(count)?;
    table.resize(count, value);
    Ok(table)
}

/// A table of zeros, which the system may not have to touch before it is used.
#[expect(clippy::missing_errors_doc, reason = "said once, at `with_room`")]
pub fn zeroed<T: bytemuck::Zeroable>(count: usize) -> Result<Vec<T>, BuildError> {
    let failed = |()| BuildError::OutOfMemory { bytes: count.saturating_mul(size_of::<T>()) };
    let mut table = bytemuck::allocation::try_zeroed_vec(count).map_err(failed)?;
    huge_pages::advise(&mut table);
    Ok(table)
}

/// Makes a table longer, by `value`, or shorter.
#[expect(clippy::missing_errors_doc, reason = "said once, at `with_room`")]
pub fn resize<T: Clone>(table: &mut Vec<T>, count: usize, value: T) -> Result<(), BuildError> {
    reserve_exact(table, count)?;
    table.resize(count, value);
    Ok(())
}

/// Room for `count` values in all.
fn reserve_exact<T>(table: &mut Vec<T>, count: usize) -> Result<(), BuildError> {
    let failed = |_| BuildError::OutOfMemory { bytes: count.saturating_mul(size_of::<T>()) };
    let had = table.capacity();
    table.try_reserve_exact(count.saturating_sub(table.len())).map_err(failed)?;
    if table.capacity() > had {
        huge_pages::advise(table);
    }
    Ok(())
}

/// A table of the values of an iterator that knows its length.
#[expect(clippy::missing_errors_doc, reason = "said once, at `with_room`")]
pub fn collected<T>(values: impl ExactSizeIterator<Item = T>) -> Result<Vec<T>, BuildError> {
    let mut table = with_room(values.len())?;
    table.extend(values);
    Ok(table)
}

/// The values as a table of one's own: copied only where they are borrowed.
#[expect(clippy::missing_errors_doc, reason = "said once, at `with_room`")]
pub fn owned<T: Copy>(values: Cow<'_, [T]>) -> Result<Vec<T>, BuildError> {
    match values {
        Cow::Owned(table) => Ok(table),
        Cow::Borrowed(values) => collected(values.iter().copied()),
    }
}

/// Room for `more` values behind those of a table that grows.
#[expect(clippy::missing_errors_doc, reason = "said once, at `with_room`")]
#[inline]
pub fn reserve<T>(table: &mut Vec<T>, more: usize) -> Result<(), BuildError> {
    let bytes = table.len().saturating_add(more).saturating_mul(size_of::<T>());
    table.try_reserve(more).map_err(|_| BuildError::OutOfMemory { bytes })
}

/// Adds `value` to a table that grows.
#[expect(clippy::missing_errors_doc, reason = "said once, at `with_room`")]
#[inline]
pub fn push<T>(table: &mut Vec<T>, value: T) -> Result<(), BuildError> {
    if table.len() == table.capacity() {
        let bytes = table.len().saturating_mul(2 * size_of::<T>());
        table.try_reserve(1).map_err(|_| BuildError::OutOfMemory { bytes })?;
    }
    table.push(value);
    Ok(())
}

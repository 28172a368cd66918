//! Lists one behind the other, copied by all threads.

use std::mem::MaybeUninit;

use rayon::prelude::*;

use crate::Error;
use crate::memory::reserve;

/// Puts the parts behind `all`. Whoever writes to fresh memory waits for the system to provide it, which takes longer
/// than the copy: the threads share that.
#[expect(unsafe_code, reason = "only raw room can be filled by several threads without writing it twice")]
pub(super) fn append<T: Copy + Send + Sync>(all: &mut Vec<T>, parts: &[&[T]]) -> Result<(), Error> {
    let more = parts.iter().map(|part| part.len()).sum();
    reserve(all, more)?;
    let mut room = &mut all.spare_capacity_mut()[..more];
    let mut pieces: Vec<(&mut [MaybeUninit<T>], &[T])> = Vec::with_capacity(parts.len());
    for part in parts {
        let (piece, behind) = room.split_at_mut(part.len());
        pieces.push((piece, part));
        room = behind;
    }
    pieces.into_par_iter().for_each(|(piece, part)| {
        piece.write_copy_of_slice(part);
    });
    // SAFETY: the pieces are all of the first `more` elements of the room, since the lengths of the parts add up to
    // `more`; each was written as a whole, or the copy would have panicked.
    unsafe { all.set_len(all.len() + more) };
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_stand_behind_each_other() {
        let mut all = vec![1];
        append(&mut all, &[&[2, 3], &[], &[4]]).unwrap();
        append(&mut all, &[]).unwrap();
        append(&mut all, &[&[5][..]]).unwrap();
        assert_eq!(all, [1, 2, 3, 4, 5]);
    }
}

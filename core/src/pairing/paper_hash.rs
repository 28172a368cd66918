//! The hash table of Biscaro et al. (2016), Eq. (7). Neighbouring edges collide: kept to compare with.
use super::{Paired, Pairing, joiner::Joiner};
use crate::{BuildError, HalfEdgeId, Slot, corner, memory};
use alloc::vec::Vec;

const END: u32 = u32::MAX;

pub(super) fn pair(faces: &[[u32; 3]], table: Vec<Slot<HalfEdgeId>>) -> Result<Paired, BuildError> {
    let mut joiner = Joiner::new(faces, table);
    let size = 3 * faces.len();
    let mut heads = memory::filled(size, END)?;
    let mut links = memory::filled(size, END)?;
    for h in 0..size {
        let (a, b) = (corner::origin(faces, h), corner::target(faces, h));
        let (low, high) = (a.min(b), a.max(b));
        let head = &mut heads[((10 * u64::from(low) + u64::from(high)) % size as u64) as usize];
        let mut at = *head;
        while at != END {
            let (c, d) = (corner::origin(faces, at as usize), corner::target(faces, at as usize));
            if (low, high) == (c.min(d), c.max(d)) {
                break;
            }
            at = links[at as usize];
        }
        if at == END {
            links[h] = *head;
            *head = h as u32;
        } else {
            joiner.join(at as usize, h)?;
        }
    }
    joiner.finish(Pairing::PaperHash)
}

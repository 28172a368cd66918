//! A counting sort of half-edges by the lower end of their edge, then a sort of each bucket by the higher end.
//! Where there are far more vertices than half-edges, one sort by both ends, without a table over the vertices.
use super::{Paired, joiner::Joiner};
use crate::{BuildError, memory};

/// So many vertices for each half-edge are sparse: four bytes each are then more than the entries take.
pub(super) const SPARSE: usize = 4;

pub(super) fn pair(vertex_count: usize, faces: &[[u32; 3]]) -> Result<Paired, BuildError> {
    if vertex_count > SPARSE * 3 * faces.len() {
        return pair_sparse(faces);
    }
    let mut joiner = Joiner::new(faces)?;
    let mut ends = memory::filled(vertex_count + 1, 0u32)?;
    for f in faces {
        for (low, _) in edges(f) {
            ends[low as usize] += 1;
        }
    }
    let mut sum = 0;
    for end in &mut ends {
        (*end, sum) = (sum, sum + *end);
    }
    // (higher end, half-edge); `ends` moves from the start of each bucket to its end.
    let mut entries = memory::filled(3 * faces.len(), (0u32, 0u32))?;
    for (f, face) in faces.iter().enumerate() {
        for (k, (low, high)) in edges(face).into_iter().enumerate() {
            let end = &mut ends[low as usize];
            entries[*end as usize] = (high, (3 * f + k) as u32);
            *end += 1;
        }
    }
    let mut start = 0;
    for &end in &ends[..vertex_count] {
        let bucket = &mut entries[start as usize..end as usize];
        bucket.sort_unstable();
        for edge in bucket.chunk_by(|a, b| a.0 == b.0) {
            for &(_, h) in &edge[1..] {
                joiner.join(edge[0].1 as usize, h as usize)?;
            }
        }
        start = end;
    }
    drop(entries); // the records may need the memory
    joiner.finish()
}

fn pair_sparse(faces: &[[u32; 3]]) -> Result<Paired, BuildError> {
    let mut joiner = Joiner::new(faces)?;
    let mut entries = memory::with_room(3 * faces.len())?;
    for (f, face) in faces.iter().enumerate() {
        entries.extend(edges(face).into_iter().enumerate().map(|(k, edge)| (edge, 3 * f + k)));
    }
    entries.sort_unstable();
    for edge in entries.chunk_by(|a, b| a.0 == b.0) {
        for &(_, h) in &edge[1..] {
            joiner.join(edge[0].1, h)?;
        }
    }
    drop(entries); // the records may need the memory
    joiner.finish()
}

/// The lower and higher end of each side of a face.
#[inline]
fn edges(&[a, b, c]: &[u32; 3]) -> [(u32, u32); 3] {
    [(a, b), (b, c), (c, a)].map(|(a, b)| (a.min(b), a.max(b)))
}

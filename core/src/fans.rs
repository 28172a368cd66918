//! Where to start around each vertex, and the vertices whose faces form several fans.
use crate::{BuildError, HalfEdgeId, Handle, Slot, VertexId, corner, memory};
use alloc::vec::Vec;

/// For each vertex the start of its first fan, and the vertices that have more.
#[derive(Clone, Debug)]
pub struct Fans {
    /// For each vertex: its lowest half-edge that nothing lies clockwise of, or where every fan is closed, its
    /// lowest half-edge.
    pub outgoing: Vec<Slot<HalfEdgeId>>,
    /// The start of every fan of each vertex that has several, by vertex; the first is its `outgoing`.
    pub several: Vec<(VertexId, Vec<HalfEdgeId>)>,
}

/// The fans of corner-numbered `faces` with these opposites. O(faces); four bytes a vertex, and one for each
/// half-edge where some vertex has several fans.
///
/// # Errors
/// [`BuildError::OutOfMemory`].
pub fn fans(
    vertex_count: usize,
    faces: &[[u32; 3]],
    opposite: &[Slot<HalfEdgeId>],
) -> Result<Fans, BuildError> {
    let mut outgoing = memory::filled(vertex_count, Slot::NONE)?;
    for (h, &v) in faces.as_flattened().iter().enumerate() {
        let first: &mut Slot<HalfEdgeId> = &mut outgoing[v as usize];
        let is_better = match first.get() {
            None => true,
            Some(g) => opposite[h].get().is_none() && opposite[g.index()].get().is_some(),
        };
        if is_better {
            *first = Slot::some(HalfEdgeId::new(h));
        }
    }
    let seen: usize = outgoing.iter().filter_map(|s| s.get()).map(|h| turn(opposite, h).count()).sum();
    let several = if seen == 3 * faces.len() { Vec::new() } else { several(faces, opposite, &outgoing)? };
    Ok(Fans { outgoing, several })
}

impl Fans {
    /// The starts, for a backend that holds one fan a vertex.
    ///
    /// # Errors
    /// [`BuildError::SeveralFans`] for the lowest vertex that has more.
    pub fn refuse_several(self) -> Result<Vec<Slot<HalfEdgeId>>, BuildError> {
        match self.several.first() {
            Some((v, fans)) => Err(BuildError::SeveralFans { vertex: v.index(), fans: fans.len() }),
            None => Ok(self.outgoing),
        }
    }
}

/// The half-edges out of one vertex from `start`, counter-clockwise.
fn turn(opposite: &[Slot<HalfEdgeId>], start: HalfEdgeId) -> impl Iterator<Item = HalfEdgeId> {
    let step = move |&h: &HalfEdgeId| opposite[corner::prev(h).index()].get().filter(|&g| g != start);
    core::iter::successors(Some(start), step)
}

/// What the turns from `outgoing` did not see begins further fans.
fn several(
    faces: &[[u32; 3]],
    opposite: &[Slot<HalfEdgeId>],
    outgoing: &[Slot<HalfEdgeId>],
) -> Result<Vec<(VertexId, Vec<HalfEdgeId>)>, BuildError> {
    let mut seen = memory::filled(3 * faces.len(), false)?;
    for start in outgoing.iter().filter_map(|s| s.get()) {
        turn(opposite, start).for_each(|h| seen[h.index()] = true);
    }
    let mut further = Vec::new();
    // Open fans first: a closed one may start anywhere, an open one only at its clockwise end.
    for open in [true, false] {
        for h in 0..3 * faces.len() {
            if !seen[h] && (!open || opposite[h].get().is_none()) {
                let start = HalfEdgeId::new(h);
                turn(opposite, start).for_each(|h| seen[h.index()] = true);
                further.push((corner::origin(faces, h), !open, start));
            }
        }
    }
    further.sort_unstable();
    let with_first = |of: &[(u32, bool, HalfEdgeId)]| {
        let v = VertexId::new(of[0].0 as usize);
        let first = outgoing[v.index()].get();
        (v, first.into_iter().chain(of.iter().map(|&(_, _, start)| start)).collect())
    };
    Ok(further.chunk_by(|a, b| a.0 == b.0).map(with_first).collect())
}

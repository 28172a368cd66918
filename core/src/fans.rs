//! Where to start around each vertex, and the vertices whose faces form several fans.
use crate::{Adjacency, BuildError, Handle, Map, Slot, Topology, memory, ring::Fan, workers};
use alloc::vec::Vec;
use core::ops::Range;

/// For each vertex the start of its first fan, and the vertices that have more.
#[derive(Clone, Debug)]
pub struct Fans<M: Topology> {
    /// For each vertex: its least half-edge that nothing lies clockwise of, or where every fan is closed, its
    /// least half-edge.
    pub outgoing: Map<M::Vertex, Slot<M::HalfEdge>>,
    /// The start of every fan of each vertex that has several, by vertex; the first is its `outgoing`.
    pub several: Vec<(M::Vertex, Vec<M::HalfEdge>)>,
}

/// The fans of `mesh`, by one thread. O(faces), and O(n log n) in the number n of further fans; four bytes a vertex, and
/// one for each half-edge where some vertex has several fans.
///
/// # Errors
/// [`BuildError::OutOfMemory`].
pub fn fans<M: Adjacency>(mesh: &M) -> Result<Fans<M>, BuildError> {
    Starts::of_faces(mesh, 0..mesh.face_count(), Vec::new())?.settle(mesh)
}

/// The same into a table that there is: it becomes [`Fans::outgoing`], of whatever length it was and whatever it held.
/// With the feature `parallel`, by several threads, of which each but the first takes four bytes a vertex more.
///
/// # Errors
/// As for [`fans`].
pub fn fans_into<M: Adjacency + Sync>(
    mesh: &M,
    table: Vec<Slot<M::HalfEdge>>,
) -> Result<Fans<M>, BuildError> {
    let (count, mut table) = (mesh.face_count(), Some(table));
    let pieces = workers::pieces(count, PIECE).min(MOST);
    let piece = |k| (k * count / pieces..(k + 1) * count / pieces, table.take().unwrap_or_default());
    let pieces: Vec<_> = (0..pieces).map(piece).collect();
    let found = workers::map(pieces, |(faces, table)| Starts::of_faces(mesh, faces, table));
    let mut found = found.into_iter();
    let mut starts = found.next().unwrap_or_else(|| Starts::of_faces(mesh, 0..0, Vec::new()))?;
    for others in found {
        starts.join(mesh, &others?);
    }
    starts.settle(mesh)
}

/// Faces that are looked at together.
const BLOCK: usize = 128;

/// Faces that are worth a thread.
const PIECE: usize = 1 << 16;

/// The most threads: their tables take no more than the chain did before.
const MOST: usize = 4;

/// The best start of each vertex in some of the faces.
struct Starts<M: Topology> {
    outgoing: Map<M::Vertex, Slot<M::HalfEdge>>,
    /// Whether no other start can be that of a further fan.
    is_clear: bool,
}

impl<M: Adjacency> Starts<M> {
    fn of_faces(
        mesh: &M,
        faces: Range<usize>,
        mut table: Vec<Slot<M::HalfEdge>>,
    ) -> Result<Self, BuildError> {
        table.clear();
        memory::resize(&mut table, mesh.vertex_count(), Slot::NONE)?;
        let (mut outgoing, mut is_clear) = (Map::from(table), true);
        let mut found = [M::HalfEdge::new(0); 3 * BLOCK];
        for begin in faces.clone().step_by(BLOCK) {
            let count = candidates(mesh, begin..faces.end.min(begin + BLOCK), &mut found);
            for &h in &found[..count] {
                meet(mesh, &mut outgoing[mesh.origin(h)], h, &mut is_clear);
            }
        }
        Ok(Self { outgoing, is_clear })
    }

    /// Of these faces and others together.
    fn join(&mut self, mesh: &M, others: &Self)
    where
        M: Sync,
    {
        let size = self.outgoing.len().div_ceil(MOST).max(PIECE);
        let (mine, theirs) = (self.outgoing.as_mut_slice(), others.outgoing.as_slice());
        let pieces: Vec<_> = mine.chunks_mut(size).zip(theirs.chunks(size)).collect();
        let are_clear = workers::map(pieces, |(mine, theirs)| {
            let mut is_clear = true;
            for (first, other) in mine.iter_mut().zip(theirs) {
                other.get().into_iter().for_each(|h| meet(mesh, first, h, &mut is_clear));
            }
            is_clear
        });
        self.is_clear &= others.is_clear && are_clear.into_iter().all(|is_clear| is_clear);
    }

    /// Where some start may be that of a further fan, all fans are walked.
    fn settle(self, mesh: &M) -> Result<Fans<M>, BuildError> {
        let outgoing = self.outgoing;
        let is_single = self.is_clear || {
            let seen: usize = outgoing.iter().map(|(_, first)| Fan::new(mesh, first.get()).count()).sum();
            seen == mesh.half_edge_count()
        };
        let several = if is_single { Vec::new() } else { several(mesh, &outgoing)? };
        Ok(Fans { outgoing, several })
    }
}

/// Finds the half-edges of some faces that come before both their neighbours, and gives their number. A fan's start does;
/// so does many another, but most see a better one near by.
///
/// No branch depends on the mesh: the vertices of those that are found then wait for memory together.
fn candidates<M: Adjacency>(mesh: &M, faces: Range<usize>, found: &mut [M::HalfEdge; 3 * BLOCK]) -> usize {
    let is_before = |h, g: Option<M::HalfEdge>| g.is_none_or(|g| h < g);
    let mut count = 0;
    for f in faces.map(M::Face::new) {
        let half_edges = mesh.face_half_edges(f);
        let across = half_edges.map(|h| mesh.opposite(h));
        for k in 0..3 {
            let (h, ccw) = (half_edges[k], across[(k + 2) % 3]);
            found[count] = h;
            count += usize::from(across[k].is_none() | is_before(h, ccw));
        }
    }
    // What lies clockwise takes longer to tell, so only where that was so.
    let mut left = 0;
    for i in 0..count {
        let h = found[i];
        found[left] = h;
        left += usize::from(is_before(h, mesh.rotate_cw(h)));
    }
    left
}

/// Keeps the better start of a vertex. All starts but the best are the worse one of two once, in whatever order they come.
#[inline(always)]
fn meet<M: Adjacency>(mesh: &M, first: &mut Slot<M::HalfEdge>, h: M::HalfEdge, is_clear: &mut bool) {
    let Some(g) = first.get() else {
        *first = Slot::some(h);
        return;
    };
    let is_open = |h| mesh.opposite(h).is_none();
    let is_better = if h < g { is_open(h) || !is_open(g) } else { is_open(h) && !is_open(g) };
    let worse = if is_better { g } else { h };
    if is_better {
        *first = Slot::some(h);
    }
    *is_clear = *is_clear && sees_better(mesh, worse);
}

/// Whether some half-edge not far from `h` in its fan is a better start of it: lesser, or, as `h` does not begin an open
/// fan, the end of one.
fn sees_better<M: Adjacency>(mesh: &M, h: M::HalfEdge) -> bool {
    const NEAR: usize = 16;
    let sees_better = |turn: fn(&M, M::HalfEdge) -> Option<M::HalfEdge>| {
        let mut at = h;
        for _ in 0..NEAR {
            match turn(mesh, at) {
                Some(g) if g > h => at = g,
                g => return g != Some(h),
            }
        }
        false
    };
    mesh.opposite(h).is_some() && (sees_better(M::rotate_ccw) || sees_better(M::rotate_cw))
}

impl<M: Topology> Fans<M> {
    /// The starts, for a structure that holds one fan a vertex.
    ///
    /// # Errors
    /// [`BuildError::SeveralFans`] for the lowest vertex that has more.
    pub fn refuse_several(self) -> Result<Map<M::Vertex, Slot<M::HalfEdge>>, BuildError> {
        match self.several.first() {
            Some((v, fans)) => Err(BuildError::SeveralFans { vertex: v.index() as u32, fans: fans.len() }),
            None => Ok(self.outgoing),
        }
    }
}

type Several<M> = Vec<(<M as Topology>::Vertex, Vec<<M as Topology>::HalfEdge>)>;

/// What the turns from `outgoing` did not see begins further fans.
fn several<M: Adjacency>(
    mesh: &M,
    outgoing: &Map<M::Vertex, Slot<M::HalfEdge>>,
) -> Result<Several<M>, BuildError> {
    let mut seen: Map<M::HalfEdge, bool> = memory::filled(mesh.half_edge_bound(), false)?.into();
    for (_, first) in outgoing.iter() {
        Fan::new(mesh, first.get()).for_each(|h| seen[h] = true);
    }
    let mut further = Vec::new();
    // Open fans first: a closed one may start anywhere, an open one only at its clockwise end.
    for open in [true, false] {
        for h in mesh.half_edges() {
            if !seen[h] && (!open || mesh.opposite(h).is_none()) {
                Fan::new(mesh, Some(h)).for_each(|h| seen[h] = true);
                memory::push(&mut further, (mesh.origin(h), !open, h))?;
            }
        }
    }
    further.sort_unstable();
    let mut several = Vec::new();
    for of in further.chunk_by(|a, b| a.0 == b.0) {
        let v = of[0].0;
        let mut starts = memory::with_room(1 + of.len())?;
        starts.extend(outgoing[v].get());
        starts.extend(of.iter().map(|&(_, _, start)| start));
        memory::push(&mut several, (v, starts))?;
    }
    Ok(several)
}

//! Where to start around each vertex, and the vertices whose faces form several fans.
use crate::{Adjacency, BuildError, Handle, Map, Slot, Topology, memory, ring::Fan};
use alloc::vec::Vec;

/// For each vertex the start of its first fan, and the vertices that have more.
#[derive(Clone, Debug)]
pub struct Fans<M: Topology> {
    /// For each vertex: its least half-edge that nothing lies clockwise of, or where every fan is closed, its
    /// least half-edge.
    pub outgoing: Map<M::Vertex, Slot<M::HalfEdge>>,
    /// The start of every fan of each vertex that has several, by vertex; the first is its `outgoing`.
    pub several: Vec<(M::Vertex, Vec<M::HalfEdge>)>,
}

/// The fans of `mesh`. O(faces), and O(n log n) in the number n of further fans; four bytes a vertex, and one for
/// each half-edge where some vertex has several fans.
///
/// # Errors
/// [`BuildError::OutOfMemory`].
pub fn fans<M: Adjacency>(mesh: &M) -> Result<Fans<M>, BuildError> {
    fans_into(mesh, Vec::new())
}

/// The same into a table that there is: it becomes [`Fans::outgoing`], of whatever length it was and whatever it held.
///
/// # Errors
/// As for [`fans`].
pub fn fans_into<M: Adjacency>(mesh: &M, mut table: Vec<Slot<M::HalfEdge>>) -> Result<Fans<M>, BuildError> {
    table.clear();
    memory::resize(&mut table, mesh.vertex_count(), Slot::NONE)?;
    let mut outgoing: Map<M::Vertex, Slot<M::HalfEdge>> = table.into();
    // A fan's start comes before both its neighbours. So does many another half-edge, but most see a better one near by.
    let mut is_clear = true;
    for h in mesh.half_edges() {
        let is_open = mesh.opposite(h).is_none();
        let is_lesser = |g: Option<M::HalfEdge>| g.is_none_or(|g| h < g);
        if !(is_open || is_lesser(mesh.rotate_cw(h)) && is_lesser(mesh.rotate_ccw(h))) {
            continue;
        }
        let first = &mut outgoing[mesh.origin(h)];
        let further = match first.get() {
            None => {
                *first = Slot::some(h);
                continue;
            }
            Some(g) if is_open && mesh.opposite(g).is_some() => {
                *first = Slot::some(h);
                g
            }
            Some(_) => h,
        };
        is_clear = is_clear && sees_better(mesh, further);
    }
    let is_single = is_clear || {
        let seen: usize = outgoing.iter().map(|(_, first)| Fan::new(mesh, first.get()).count()).sum();
        seen == mesh.half_edge_count()
    };
    let several = if is_single { Vec::new() } else { several(mesh, &outgoing)? };
    Ok(Fans { outgoing, several })
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

//! What the structures have in common when their columns are validated.
use crate::columns::Invalid;
use crate::storage::Element;
use alloc::vec::Vec;
use onering_core::{Adjacency, BuildError, Handle, Slot, VertexId, memory};

pub(crate) type Checked = Result<(), Invalid>;

/// Whether every handle of a column is below `bound`.
pub(crate) fn handles<H: Handle + Element>(column: &'static str, cells: &[H], bound: usize) -> Checked {
    // One comparison for all: the loop runs without a branch until something is wrong.
    let largest = bytemuck::cast_slice::<H, u32>(cells).iter().copied().max();
    if largest.is_none_or(|largest| (largest as usize) < bound) {
        return Ok(());
    }
    // As a word: the handle itself may be one that cannot be.
    let words: &[u32] = bytemuck::cast_slice(cells);
    let index = words.iter().position(|&word| word as usize >= bound).unwrap_or(0);
    Err(Invalid::element(column, index, OUT_OF_RANGE))
}

/// Whether every slot of a column is empty or holds a handle below `bound`.
pub(crate) fn slots<H: Handle>(column: &'static str, cells: &[Slot<H>], bound: usize) -> Checked
where
    Slot<H>: Element,
{
    let past = |slot: &&Slot<H>| slot.get().is_some_and(|h| h.index() >= bound);
    match cells.iter().position(|slot| past(&slot)) {
        Some(index) => Err(Invalid::element(column, index, OUT_OF_RANGE)),
        None => Ok(()),
    }
}

pub(crate) const OUT_OF_RANGE: &str = "names an element that does not exist";
pub(crate) const DEGENERATE: &str = "the face has one vertex more than once";

/// Whether the three are different.
#[inline(always)]
pub(crate) fn is_proper<V: PartialEq>([a, b, c]: [V; 3]) -> bool {
    (a != b) & (b != c) & (c != a)
}

/// Whether opposites come in pairs that run along the same edge in opposite directions. All are in range.
pub(crate) fn opposites<M: Adjacency>(mesh: &M, column: &'static str) -> Checked {
    for h in mesh.half_edges() {
        let Some(o) = mesh.opposite(h) else { continue };
        // That `o` ends where `h` starts is seen when it is the turn of `o`.
        if mesh.opposite(o) != Some(h) || mesh.origin(o) != mesh.target(h) {
            return Err(Invalid::element(column, h.index(), "is not the opposite of its opposite"));
        }
    }
    Ok(())
}

/// Whether the fans that begin with `starts` are all fans of all vertices, as [`Incidence`](onering_core::Incidence)
/// says: each of its own vertex, open ones from their clockwise end, those before closed ones, none twice; and
/// whether no two edges join the same two vertices, so that a half-edge without an opposite has none
/// to be paired with. Opposites are in order, as [`opposites`] looks at them.
///
/// Every half-edge is walked over once, so that a fan cannot have been left out. Opposites being pairs, a turn either
/// comes round or ends.
pub(crate) fn fans<M, I>(mesh: &M, column: &'static str, starts: impl Fn(M::Vertex) -> I) -> Checked
where
    M: Adjacency,
    I: Iterator<Item = M::HalfEdge>,
{
    let mut once = Once::new(mesh.vertex_count())?;
    let mut walked = 0;
    for v in mesh.vertices() {
        let fail = |problem| Err(Invalid::element(column, v.index(), problem));
        let has_several = starts(v).nth(1).is_some();
        let mut previous = None;
        let mut is_new = true;
        for start in starts(v) {
            let is_closed = mesh.opposite(start).is_some();
            if mesh.origin(start) != v {
                return fail("names a half-edge of another vertex");
            }
            if previous >= Some((is_closed, start)) {
                return fail("fans are not in order, or one is there twice");
            }
            previous = Some((is_closed, start));
            if !has_several && !is_closed {
                is_new &= once.is_new(v, mesh.target(start));
            }
            let mut h = start;
            loop {
                walked += 1;
                let p = mesh.prev(h);
                if has_several {
                    is_new &= !is_least(mesh, h) || once.is_new(v, mesh.target(h));
                    is_new &= !is_least(mesh, p) || once.is_new(v, mesh.origin(p));
                } else {
                    is_new &= once.is_new(v, mesh.origin(p));
                }
                match mesh.opposite(p) {
                    None if is_closed => return fail("a fan does not start at its clockwise end"),
                    Some(o) if has_several && is_closed && o < start => {
                        return fail("a closed fan does not start at its least half-edge");
                    }
                    Some(o) if o != start => h = o,
                    _ => break,
                }
            }
        }
        if !is_new {
            return fail("two edges lead to the same neighbour");
        }
    }
    if walked == mesh.half_edge_count() { Ok(()) } else { Err(Invalid::column(column, "a fan is left out")) }
}

fn is_least<M: Adjacency>(mesh: &M, h: M::HalfEdge) -> bool {
    mesh.edge_fan(h).nth(1).is_none_or(|least_other| h < least_other)
}

/// Tells a neighbour that was met before from a new one, by the vertex that it was last met from. 4 bytes a vertex.
pub(crate) struct Once(Vec<u32>);

impl Once {
    pub(crate) fn new(vertex_count: usize) -> Result<Self, BuildError> {
        memory::filled(vertex_count, u32::MAX).map(Self)
    }

    #[inline(always)]
    pub(crate) fn is_new<V: Handle>(&mut self, v: V, w: V) -> bool {
        let v = v.index() as u32;
        core::mem::replace(&mut self.0[w.index()], v) != v
    }
}

/// The starts of lists one after the other, and the end of the last: from 0, never falling, to `end`.
pub(crate) fn offsets(column: &'static str, offsets: &[u32], end: usize) -> Checked {
    if offsets.first() != Some(&0) {
        return Err(Invalid::element(column, 0, "the first list does not start at 0"));
    }
    if let Some(index) = offsets.windows(2).position(|pair| pair[0] > pair[1]) {
        return Err(Invalid::element(column, index + 1, "a list ends before it starts"));
    }
    if offsets.last().is_none_or(|&last| last as usize != end) {
        return Err(Invalid::element(
            column,
            offsets.len() - 1,
            "the lists do not end where the column does",
        ));
    }
    Ok(())
}

/// The lists that [`offsets`] are in order for: ascending, and each vertex in the list of each of its neighbours, but
/// not in its own.
pub(crate) fn symmetric(column: &'static str, offsets: &[u32], neighbours: &[VertexId]) -> Checked {
    // Lists are ascending and so are vertices: each list is met from its neighbours in its own order.
    let mut met = memory::collected(offsets.iter().copied())?;
    for (v, ends) in offsets.windows(2).enumerate() {
        let (start, end) = (ends[0] as usize, ends[1] as usize);
        for i in start..end {
            let w = neighbours[i].index();
            let fail = |problem| Err(Invalid::element(column, i, problem));
            if i > start && neighbours[i - 1].index() >= w {
                return fail("the list is not ascending");
            }
            let at = met[w] as usize;
            if w == v || at >= offsets[w + 1] as usize || neighbours[at].index() != v {
                return fail("is not the neighbour of its neighbour");
            }
            met[w] += 1;
        }
    }
    Ok(())
}

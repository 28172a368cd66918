//! Extrema, where vertices of one value that are connected are one.
use crate::{Incidence, Map};
use alloc::vec::Vec;

/// The least vertex of each plateau that no neighbour is beyond, ascending: with `is_beyond(v, u)` where `u` is
/// lower than `v`, these are the minima.
pub(super) fn extrema<M: Incidence + ?Sized>(
    mesh: &M,
    is_beyond: impl Fn(M::Vertex, M::Vertex) -> bool,
) -> Vec<M::Vertex> {
    let mut extrema = Vec::new();
    let mut reached = Vec::new();
    // Made only when it is known that there is a plateau.
    let mut seen: Map<M::Vertex, Seen> = Map::default();
    for v in mesh.vertices() {
        match compare(mesh, v, &is_beyond) {
            Around::Within => extrema.push(v),
            Around::Level => {
                if seen.is_empty() {
                    seen = Map::filled(mesh.vertex_count(), Seen::Never);
                }
                if seen[v] == Seen::Never {
                    reached.clear();
                    reached.push(v);
                    if flood(mesh, &mut reached, &is_beyond, &mut seen) {
                        extrema.extend(reached.iter().copied().min());
                    }
                }
            }
            Around::Beyond | Around::Nothing => {}
        }
    }
    // A plateau is met at its first vertex that nothing is beyond, which need not be its least.
    extrema.sort_unstable();
    extrema
}

/// How the neighbours of a vertex compare with it.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Around {
    /// There are none.
    Nothing,
    /// It is beyond all of them.
    Within,
    /// None is beyond it, and some are level with it.
    Level,
    /// One is beyond it.
    Beyond,
}

fn compare<M: Incidence + ?Sized>(
    mesh: &M,
    v: M::Vertex,
    is_beyond: &impl Fn(M::Vertex, M::Vertex) -> bool,
) -> Around {
    let mut around = Around::Nothing;
    for u in mesh.neighbours(v) {
        if is_beyond(v, u) {
            return Around::Beyond;
        }
        if !is_beyond(u, v) {
            around = Around::Level;
        } else if around == Around::Nothing {
            around = Around::Within;
        }
    }
    around
}

/// What floods have made of a vertex.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Seen {
    Never,
    /// Reached by the flood that is under way, or by one that found an extremum.
    Reached,
    /// On a plateau that is known to be no extremum.
    NoExtremum,
}

/// Whether the plateau of the only vertex in `reached` is an extremum, and then `reached` is all of it.
///
/// A flood ends at the first neighbour beyond, and at the first vertex of an earlier flood that ended so: a
/// plateau is flooded once, in as many pieces as it takes, and what is not reached then is settled by its
/// neighbours.
fn flood<M: Incidence + ?Sized>(
    mesh: &M,
    reached: &mut Vec<M::Vertex>,
    is_beyond: &impl Fn(M::Vertex, M::Vertex) -> bool,
    seen: &mut Map<M::Vertex, Seen>,
) -> bool {
    seen[reached[0]] = Seen::Reached;
    let mut next = 0;
    while let Some(&v) = reached.get(next) {
        next += 1;
        for u in mesh.neighbours(v) {
            let is_level = || !is_beyond(u, v);
            if is_beyond(v, u) || seen[u] == Seen::NoExtremum && is_level() {
                reached.iter().for_each(|&v| seen[v] = Seen::NoExtremum);
                return false;
            }
            if seen[u] == Seen::Never && is_level() {
                seen[u] = Seen::Reached;
                reached.push(u);
            }
        }
    }
    true
}

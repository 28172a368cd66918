//! Extrema, where vertices of one value that are connected are one.
use crate::{Incidence, Map};
use alloc::{vec, vec::Vec};

/// The least vertex of each plateau that no neighbour is beyond, ascending: with `is_beyond(v, u)` where `u` is lower than
/// `v`, these are the minima.
pub(super) fn extrema<M: Incidence + ?Sized>(
    mesh: &M,
    is_beyond: impl Fn(M::Vertex, M::Vertex) -> bool,
) -> Vec<M::Vertex> {
    let mut extrema = Vec::new();
    // Made only when it is known that there is a plateau.
    let mut seen: Map<M::Vertex, bool> = Map::default();
    for v in mesh.vertices() {
        match compare(mesh, v, &is_beyond) {
            Around::Within => extrema.push(v),
            Around::Level => {
                if seen.is_empty() {
                    seen = Map::filled(mesh.vertex_count(), false);
                }
                if !seen[v] {
                    extrema.extend(flood(mesh, v, &is_beyond, &mut seen));
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

/// The least vertex of the plateau of `v`, where no neighbour is beyond it. Marks all of the plateau.
fn flood<M: Incidence + ?Sized>(
    mesh: &M,
    v: M::Vertex,
    is_beyond: &impl Fn(M::Vertex, M::Vertex) -> bool,
    seen: &mut Map<M::Vertex, bool>,
) -> Option<M::Vertex> {
    let (mut least, mut is_extremum) = (v, true);
    seen[v] = true;
    let mut reached = vec![v];
    while let Some(v) = reached.pop() {
        least = least.min(v);
        for u in mesh.neighbours(v) {
            if is_beyond(v, u) {
                is_extremum = false;
            } else if !is_beyond(u, v) && !seen[u] {
                seen[u] = true;
                reached.push(u);
            }
        }
    }
    is_extremum.then_some(least)
}

//! Laws of [`Neighbours`].
use super::iteration::all;
use crate::{
    Handle,
    conformance::{
        Case,
        slow::{FaceList, Slow},
    },
    neighbours::Neighbours,
};
use alloc::{collections::BTreeSet, format, vec::Vec};

/// Laws of [`Neighbours`], which hold for a graph that knows of no faces: the neighbours of a vertex are the other
/// ends of its edges, each once.
pub fn graph<G: Neighbours>(case: &Case, graph: &G) {
    let slow = Slow::of(&FaceList { vertices: case.vertices, faces: &case.faces });
    assert_eq!(graph.node_count(), case.vertices, "{}: node_count", case.name);
    for v in 0..case.vertices {
        let at = format!("{}: v{v}", case.name);
        let found = all(&at, || graph.neighbours(G::Node::new(v)));
        same_neighbours(&at, &slow.neighbours(v), found);
    }
}

pub(super) fn same_neighbours<V: Handle>(at: &str, expected: &BTreeSet<usize>, found: Vec<V>) {
    assert_eq!(found.len(), expected.len(), "{at}: neighbours has each once");
    let found: BTreeSet<usize> = found.into_iter().map(Handle::index).collect();
    assert_eq!(found, *expected, "{at}: neighbours");
}

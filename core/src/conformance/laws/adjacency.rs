//! Laws of [`Adjacency`].
use super::iteration::all;
use crate::{
    Adjacency,
    conformance::{Case, slow::Slow},
};
use alloc::format;

/// Laws of [`Adjacency`]: what lies across an edge is what a search finds, and there are as many edges as
/// counted.
pub fn adjacency<T: Adjacency>(case: &Case, mesh: &T) {
    let slow = Slow::of(mesh);
    assert_eq!(slow.edges().len(), case.edges, "{}: edges", case.name);
    for i in 0..slow.sides.len() {
        across(case, mesh, &slow, i);
        turns(case, mesh, slow.sides[i].name);
    }
}

fn across<T: Adjacency>(case: &Case, mesh: &T, slow: &Slow<T::HalfEdge>, i: usize) {
    let h = slow.sides[i].name;
    let at = format!("{}: {h:?}", case.name);
    let opposite = slow.opposite(i).map(|o| slow.sides[o].name);
    assert_eq!(mesh.opposite(h), opposite, "{at}: opposite");
    assert_eq!(mesh.is_boundary(h), slow.is_boundary(i), "{at}: is_boundary");
    let fan = all(&at, || mesh.edge_fan(h));
    assert_eq!(fan[0], h, "{at}: edge_fan starts with itself");
    assert!(fan[1..].is_sorted(), "{at}: then the others in ascending order");
    assert_eq!(fan.len(), slow.sides[i].along.len(), "{at}: edge_fan has each half-edge once");
    let along = slow.names(slow.sides[i].along.iter().copied());
    assert_eq!(fan.into_iter().collect::<alloc::collections::BTreeSet<_>>(), along, "{at}: edge_fan");
}

fn turns<T: Adjacency>(case: &Case, mesh: &T, h: T::HalfEdge) {
    let at = format!("{}: {h:?}", case.name);
    let (ccw, cw) = (mesh.rotate_ccw(h), mesh.rotate_cw(h));
    assert_eq!(ccw, mesh.opposite(mesh.prev(h)), "{at}: rotate_ccw");
    assert_eq!(cw, mesh.opposite(h).map(|o| mesh.next(o)), "{at}: rotate_cw");
    assert_eq!(mesh.turn(h), (mesh.origin(mesh.prev(h)), ccw), "{at}: turn");
    for g in ccw.into_iter().chain(cw) {
        assert_eq!(mesh.origin(g), mesh.origin(h), "{at}: a turn stays at the vertex");
    }
    assert_eq!(ccw.and_then(|g| mesh.rotate_cw(g)), ccw.and(Some(h)), "{at}: rotate_cw undoes rotate_ccw");
    assert_eq!(cw.and_then(|g| mesh.rotate_ccw(g)), cw.and(Some(h)), "{at}: rotate_ccw undoes rotate_cw");
}

//! Laws of [`Boundaries`].
use super::iteration::all;
use crate::{
    Boundaries, Handle, Map,
    conformance::{Case, slow::Slow},
};
use alloc::{format, vec::Vec};

/// Laws of [`Boundaries`]: there are as many curves as counted, every boundary half-edge is on one of them, each
/// followed by the next around its target.
pub fn boundaries<T: Boundaries>(case: &Case, mesh: &T) {
    let (name, slow) = (case.name, Slow::of(mesh));
    assert_eq!(mesh.curve_count(), case.curves.unwrap_or(slow.curve_count()), "{name}: curve_count");
    let indices: Vec<_> = all(name, || mesh.curves()).into_iter().map(Handle::index).collect();
    assert_eq!(indices, Vec::from_iter(0..mesh.curve_count()), "{name}: curves");
    let mut times = Map::filled(mesh.half_edge_bound(), 0);
    for c in mesh.curves() {
        for h in curve(case, mesh, &slow, c) {
            times[h] += 1;
            assert_eq!(mesh.curve_of(h), Some(c), "{name}: curve of {h:?}");
        }
    }
    for (i, side) in slow.sides.iter().enumerate() {
        let h = side.name;
        assert_eq!(times[h], usize::from(slow.is_boundary(i)), "{name}: {h:?} is on one curve or inside");
        assert_eq!(mesh.curve_of(h).is_some(), slow.is_boundary(i), "{name}: curve_of {h:?}");
    }
}

fn curve<T: Boundaries>(case: &Case, mesh: &T, slow: &Slow<T::HalfEdge>, c: T::Curve) -> Vec<T::HalfEdge> {
    let at = format!("{}: {c:?}", case.name);
    let along = all(&at, || mesh.curve(c));
    assert_eq!(along.first(), Some(&mesh.curve_start(c)), "{at}: curve_start");
    let next = |h: T::HalfEdge| {
        let i = slow.sides.iter().position(|side| side.name == h);
        slow.next_along(i?).map(|g| slow.sides[g].name)
    };
    for pair in along.windows(2) {
        assert_eq!(next(pair[0]), Some(pair[1]), "{at}: each is followed by the next");
        assert_eq!(mesh.target(pair[0]), mesh.origin(pair[1]), "{at}: consecutive half-edges share a vertex");
    }
    let end = next(along[along.len() - 1]);
    assert!(end.is_none_or(|h| h == along[0]), "{at}: it comes round, or ends where nothing follows");
    along
}

//! Laws of [`Topology`].
use super::iteration::all;
use crate::{Handle, Map, Topology, conformance::Case};
use alloc::{format, vec::Vec};

/// Laws of [`Topology`]: counts and faces are those of the case, three half-edges go round each face, and every
/// half-edge is listed once and below the bound.
pub fn topology<T: Topology>(case: &Case, mesh: &T) {
    let name = case.name;
    assert_eq!(mesh.vertex_count(), case.vertices, "{name}: vertex_count");
    assert_eq!(mesh.face_count(), case.faces.len(), "{name}: face_count");
    assert_eq!(mesh.to_faces(), case.faces, "{name}: to_faces");
    let indices: Vec<_> = all(name, || mesh.vertices()).into_iter().map(Handle::index).collect();
    assert_eq!(indices, Vec::from_iter(0..case.vertices), "{name}: vertices");
    let indices: Vec<_> = all(name, || mesh.faces()).into_iter().map(Handle::index).collect();
    assert_eq!(indices, Vec::from_iter(0..case.faces.len()), "{name}: faces");
    for f in mesh.faces() {
        face(case, mesh, f);
    }
    half_edges(case, mesh);
}

fn face<T: Topology>(case: &Case, mesh: &T, f: T::Face) {
    let at = format!("{}: {f:?}", case.name);
    let sides @ [a, b, c] = mesh.face_half_edges(f);
    assert_eq!(mesh.first(f), a, "{at}: first");
    assert_eq!(sides.map(|h| mesh.next(h)), [b, c, a], "{at}: next");
    assert_eq!(sides.map(|h| mesh.prev(h)), [c, a, b], "{at}: prev");
    assert_eq!(sides.map(|h| mesh.face(h)), [f; 3], "{at}: face");
    let [u, v, w] = mesh.face_vertices(f);
    assert_eq!([u, v, w].map(|v| v.index() as u32), case.faces[f.index()], "{at}: face_vertices");
    assert_eq!(sides.map(|h| mesh.origin(h)), [u, v, w], "{at}: origin");
    assert_eq!(sides.map(|h| mesh.target(h)), [v, w, u], "{at}: target");
}

fn half_edges<T: Topology>(case: &Case, mesh: &T) {
    let name = case.name;
    let listed = all(name, || mesh.half_edges());
    assert_eq!(mesh.half_edge_count(), 3 * case.faces.len(), "{name}: half_edge_count");
    assert_eq!(listed.len(), mesh.half_edge_count(), "{name}: half_edges lists three for each face");
    let mut times = Map::filled(mesh.half_edge_bound(), 0);
    for &h in &listed {
        times[h] += 1;
        assert!(mesh.face_half_edges(mesh.face(h)).contains(&h), "{name}: {h:?} is a side of its face");
    }
    for h in mesh.faces().flat_map(|f| mesh.face_half_edges(f)) {
        assert_eq!(times[h], 1, "{name}: half_edges lists {h:?} once");
    }
}

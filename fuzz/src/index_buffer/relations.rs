//! The nine relations, and the dual graph: each result comes once, and what is symmetric is so.
use onering::dual::Dual;
use onering::neighbours::Neighbours;
use onering::relations::*;
use onering::*;
use std::collections::BTreeSet;
use std::fmt::Debug;

/// The results, which are distinct.
fn distinct<T: Ord + Copy + Debug>(results: impl Iterator<Item = T>) -> BTreeSet<T> {
    let results: Vec<T> = results.collect();
    let set: BTreeSet<T> = results.iter().copied().collect();
    assert_eq!(set.len(), results.len(), "{results:?}");
    set
}

pub(super) fn adjacency<M: Adjacency>(mesh: &M) {
    for h in mesh.half_edges() {
        let name = edge(mesh, h);
        assert!(name <= h && edge(mesh, name) == name);
        let along = distinct(edge_faces(mesh, h));
        assert!(along.contains(&mesh.face(h)) && along == distinct(edge_faces(mesh, name)));
    }
    let across: Vec<_> = mesh.faces().map(|f| distinct(face_faces(mesh, f))).collect();
    let dual = Dual::new(mesh);
    for f in mesh.faces() {
        let mine = &across[f.index()];
        assert!(!mine.contains(&f) && mine.iter().all(|g| across[g.index()].contains(&f)));
        assert_eq!(distinct(dual.neighbours(f)), *mine);
        assert_eq!(distinct(face_edges(mesh, f).into_iter()).len(), 3);
    }
}

pub(super) fn incidence<M: Incidence>(mesh: &M) {
    let around: Vec<_> = mesh.vertices().map(|v| distinct(vertex_vertices(mesh, v))).collect();
    for v in mesh.vertices() {
        let mine = &around[v.index()];
        assert!(!mine.contains(&v) && mine.iter().all(|u| around[u.index()].contains(&v)));
        let edges = distinct(vertex_edges(mesh, v));
        assert_eq!(edges.len(), mine.len());
        assert!(edges.iter().all(|&e| edge(mesh, e) == e && edge_vertices(mesh, e).contains(&v)));
        let faces = distinct(vertex_faces(mesh, v));
        assert!(faces.iter().all(|&f| face_vertices(mesh, f).contains(&v)));
        assert_eq!(faces.len(), mesh.star(v).count());
    }
    for h in edges::each(mesh) {
        let beside = distinct(edge_edges(mesh, h));
        let ends = edge_vertices(mesh, h).map(|v| around[v.index()].len());
        assert!(beside.len() == ends[0] + ends[1] - 2 && !beside.contains(&h));
    }
}

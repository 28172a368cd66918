//! For each trait, the relations over it. A check has the name that the registry has.
use super::oracle::{Oracle, undirected};
use onering::neighbours::Neighbours;
use onering::relations::*;
use onering::*;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Debug;

/// The same results, each once; but of degenerate faces, where `may_repeat`, once or more.
fn same<T: Ord + Debug>(
    found: impl Iterator<Item = T>,
    expected: &BTreeSet<T>,
    may_repeat: bool,
    of: &(&str, impl Debug),
) {
    let found: Vec<T> = found.collect();
    let count = found.len();
    let found: BTreeSet<T> = found.into_iter().collect();
    assert!(may_repeat || found.len() == count, "{of:?}: something comes twice");
    assert_eq!(&found, expected, "{of:?}");
}

fn number<M: Topology>(mesh: &M, h: M::HalfEdge) -> [u32; 2] {
    undirected([mesh.origin(h), mesh.target(h)].map(|v| v.index() as u32))
}

pub fn topology<M: Topology>(oracle: &Oracle, mesh: &M) {
    for (f, face) in mesh.faces().zip(&oracle.faces) {
        let corners = face_vertices(mesh, f).map(|v| v.index() as u32);
        let turned = |k: usize| [face[k], face[(k + 1) % 3], face[(k + 2) % 3]];
        assert!((0..3).any(|k| turned(k) == corners), "{} {f:?}: {corners:?}", oracle.name);
    }
    for h in mesh.half_edges() {
        let ends = edge_vertices(mesh, h);
        assert_eq!(ends, [mesh.origin(h), mesh.target(h)], "{}", oracle.name);
        let ends = undirected(ends.map(|v| v.index() as u32));
        assert!(oracle.edges.contains(&ends), "{} {h:?}", oracle.name);
    }
    // Whatever a backend lacks is searched for; of degenerate faces too.
    incidence(oracle, &Searched::new(mesh));
}

pub fn adjacency<M: Adjacency>(oracle: &Oracle, mesh: &M) {
    let may_repeat = oracle.is_degenerate;
    let mut least = BTreeMap::new();
    for h in mesh.half_edges() {
        least.entry(number(mesh, h)).or_insert(h);
    }
    for h in mesh.half_edges() {
        let (e, of) = (number(mesh, h), (oracle.name.as_str(), h));
        assert_eq!(edge(mesh, h), least[&e], "{of:?}");
        same(edge_faces(mesh, h).map(Handle::index), &oracle.edge_faces(e), may_repeat, &of);
        assert_eq!(edge_faces(mesh, h).next(), Some(mesh.face(h)), "{of:?}");
    }
    for f in mesh.faces() {
        let of = (oracle.name.as_str(), f);
        let sides = face_edges(mesh, f);
        assert!(sides.iter().all(|&h| edge(mesh, h) == h), "{of:?}");
        assert_eq!(sides.map(|h| number(mesh, h)), mesh.face_half_edges(f).map(|h| number(mesh, h)));
        same(sides.into_iter().map(|h| number(mesh, h)), &oracle.face_edges(f.index()), may_repeat, &of);
        same(face_faces(mesh, f).map(Handle::index), &oracle.face_faces(f.index()), may_repeat, &of);
    }
}

pub fn incidence<M: Incidence>(oracle: &Oracle, mesh: &M) {
    adjacency(oracle, mesh);
    graph(oracle, mesh);
    for v in mesh.vertices() {
        let (i, of) = (v.index() as u32, (oracle.name.as_str(), v));
        assert!(vertex_edges(mesh, v).all(|h| edge(mesh, h) == h), "{of:?}");
        same(vertex_edges(mesh, v).map(|h| number(mesh, h)), &oracle.vertex_edges(i), false, &of);
        let faces = vertex_faces(mesh, v).map(Handle::index);
        same(faces, &oracle.vertex_faces(i), oracle.is_degenerate, &of);
    }
    for h in mesh.half_edges() {
        let of = (oracle.name.as_str(), h);
        assert!(edge_edges(mesh, h).all(|h| edge(mesh, h) == h), "{of:?}");
        let edges = edge_edges(mesh, h).map(|h| number(mesh, h));
        same(edges, &oracle.edge_edges(number(mesh, h)), false, &of);
    }
}

pub fn graph<M: Neighbours>(oracle: &Oracle, mesh: &M) {
    for v in (0..mesh.node_count()).map(M::Node::new) {
        let around = vertex_vertices(mesh, v).map(|u| u.index() as u32);
        same(around, &oracle.vertex_vertices(v.index() as u32), false, &(oracle.name.as_str(), v));
    }
}

/// Two half-edges have one number if and only if they have one name.
pub fn edge_map<M: EdgeMap>(oracle: &Oracle, mesh: &M) {
    let numbers: BTreeSet<_> = mesh.half_edges().map(|h| (mesh.edge(h), edge(mesh, h))).collect();
    let each = |count: usize, what| assert_eq!(count, oracle.edges.len(), "{} {what}", oracle.name);
    each(numbers.len(), "couples");
    each(numbers.iter().map(|&(e, _)| e).collect::<BTreeSet<_>>().len(), "numbers");
    each(numbers.iter().map(|&(_, h)| h).collect::<BTreeSet<_>>().len(), "names");
}

/// Names of boundary curves add no relation: their half-edges are those whose edge has one face.
pub fn boundaries<M: Boundaries>(oracle: &Oracle, mesh: &M) {
    for h in mesh.curves().flat_map(|c| mesh.curve(c)) {
        assert_eq!(edge_faces(mesh, h).count(), 1, "{} {h:?}", oracle.name);
    }
}

//! Orders of vertices and faces, parts of meshes, and distances.
use super::List;
use onering::distance::{Dijkstra, straight};
use onering::neighbours::Neighbours;
use onering::reorder::*;
use onering::*;

fn is_permutation<H: Handle>(order: &[H], count: usize) {
    let mut order: Vec<usize> = order.iter().map(|h| h.index()).collect();
    order.sort_unstable();
    assert!(order.into_iter().eq(0..count));
}

pub(super) fn topology<M: Topology>(mesh: &M, list: &List) {
    let positions: Map<M::Vertex, _> = list.positions.iter().copied().collect();
    for order in [hilbert(&positions), morton(&positions)] {
        match order {
            Ok(order) => reorders(mesh, &order),
            Err(NotFinite { vertex }) => assert!(list.positions[vertex].iter().any(|x| !x.is_finite())),
        }
    }
    let chosen: Vec<_> = mesh.faces().filter(|f| f.index() % 3 != 1).rev_if(list.vertices.is_multiple_of(2));
    let part = submesh::submesh(mesh, chosen.iter().copied());
    assert_eq!(part.vertex_count, part.vertex_source.len());
    assert!(part.vertex_source.is_sorted_by(|a, b| a < b));
    let mut is_named = vec![false; part.vertex_count];
    for ((face, &source), &f) in part.faces.iter().zip(&part.face_source).zip(&chosen) {
        assert_eq!(source as usize, f.index());
        let back = face.map(|v| part.vertex_source[v as usize]);
        assert_eq!(back, mesh.face_vertices(f).map(|v| v.index() as u32));
        face.iter().for_each(|&v| is_named[v as usize] = true);
    }
    assert!(part.faces.len() == chosen.len() && is_named.into_iter().all(|named| named));
}

/// A list, or the same from its end.
trait RevIf: Iterator + Sized {
    fn rev_if(self, is_reversed: bool) -> Vec<Self::Item> {
        let mut items: Vec<_> = self.collect();
        if is_reversed {
            items.reverse();
        }
        items
    }
}

impl<I: Iterator> RevIf for I {}

fn reorders<M: Topology>(mesh: &M, order: &[M::Vertex]) {
    is_permutation(order, mesh.vertex_count());
    let new = reorder(mesh, order);
    assert!(new.vertex_source.iter().enumerate().all(|(i, &v)| new.vertex_target[v as usize] as usize == i));
    let faces: Vec<M::Face> = new.face_source.iter().map(|&f| M::Face::new(f as usize)).collect();
    is_permutation(&faces, mesh.face_count());
    for (face, &f) in new.faces.iter().zip(&faces) {
        assert_eq!(
            face.map(|v| new.vertex_source[v as usize]),
            mesh.face_vertices(f).map(|v| v.index() as u32)
        );
    }
    assert!(new.faces.is_sorted_by_key(|face| face.iter().min().copied()));
}

pub(super) fn graph<G: Neighbours>(graph: &G, list: &List) {
    let count = graph.node_count();
    for order in [breadth_first(graph), cuthill_mckee(graph), reverse_cuthill_mckee(graph)] {
        is_permutation(&order, count);
    }
    if count == 0 {
        return;
    }
    let first = G::Node::new(0);
    let mut dijkstra = Dijkstra::new();
    dijkstra.search(graph, [first], |_, _| 1.0).expect("lengths of one");
    let ring = k_ring::k_ring(graph, first, usize::MAX);
    for k in 1..=ring.levels() {
        assert!(ring.level(k).iter().all(|&v| dijkstra.distance(v) == k as f64));
    }
    let reached = (0..count).filter(|&v| dijkstra.distance(G::Node::new(v)) < f64::INFINITY).count();
    assert_eq!(reached, ring.count(usize::MAX) + 1);
    let positions: Map<G::Node, _> = list.positions.iter().copied().collect();
    let length = straight(&positions);
    if dijkstra.search(graph, [first], &length).is_err() {
        assert!(list.positions.as_flattened().iter().any(|x| !x.is_finite()));
        return;
    }
    for v in (0..count).map(G::Node::new) {
        for u in graph.neighbours(v).filter(|_| dijkstra.distance(v) < f64::INFINITY) {
            assert!(dijkstra.distance(u) <= dijkstra.distance(v) + length(v, u));
        }
        let path = dijkstra.path(v);
        assert_eq!(path.is_some(), dijkstra.distance(v) < f64::INFINITY);
        assert!(
            path.is_none_or(|path| path.vertices[0] == first && *path.vertices.last().expect("its end") == v)
        );
    }
}

//! Every algorithm, for each trait: it ends, and agrees with `Defects`, which comes to its figures in another way.
//! A function has the name that the registry has.
use super::{List, fields, orders, placed, relations};
use onering::neighbours::Neighbours;
use onering::*;
use std::collections::HashSet;

pub(super) fn topology<M: Topology>(mesh: &M, list: &List, defects: &Defects) {
    orders::topology(mesh, list);
    placed::topology(mesh, list);
    let parts = components::components_by_vertex(mesh);
    assert_eq!(parts.sizes().iter().sum::<usize>(), mesh.face_count());
    if defects.degenerate_faces == 0 {
        assert_eq!(parts.count(), defects.components_by_vertex);
        assert_eq!(umbrella::used_vertex_count(mesh), mesh.vertex_count() - defects.isolated_vertices);
    }
}

pub(super) fn adjacency<M: Adjacency>(mesh: &M, list: &List, defects: &Defects) {
    relations::adjacency(mesh);
    fields::adjacency(mesh, list);
    placed::adjacency(mesh, list, defects);
    assert_eq!(edges::edge_count(mesh), defects.edges);
    assert_eq!(boundary::edge_count(mesh), defects.boundary_edges);
    assert_eq!(boundary::loops(mesh), defects.boundary_loops);
    assert_eq!(components::components(mesh).count(), defects.components);
    assert_eq!(euler::euler_characteristic(mesh) as i64, defects.euler);
    assert_eq!(euler::is_closed(mesh), defects.closed);
    assert_eq!(euler::genus(mesh), defects.genus);
    assert_eq!(umbrella::is_manifold(mesh), defects.manifold);
    assert_eq!(orientation::is_oriented(mesh), defects.inconsistent_edges == 0);
    assert_eq!(orientation::is_orientable(mesh), defects.orientable);
    assert_eq!(orientation::turned(mesh).is_some(), defects.orientable);
    edges_are_named(mesh);
    curves_cover_the_boundary(mesh);
}

fn edges_are_named<M: Adjacency>(mesh: &M) {
    let named = edges::edge_map(mesh);
    assert!(named.iter().map(|(_, h)| h).eq(edges::each(mesh)));
    for h in mesh.half_edges() {
        let fan: Vec<_> = mesh.edge_fan(h).take(mesh.half_edge_count() + 1).collect();
        assert_eq!(Some(&named.half_edge(named.edge(h))), fan.iter().min());
        assert_eq!(star::edge_link(mesh, h).count(), fan.len());
        assert_eq!(mesh.is_boundary(h), fan.len() == 1);
    }
}

fn curves_cover_the_boundary<M: Adjacency>(mesh: &M) {
    let bound = mesh.half_edge_count() + 1;
    let steps = boundary::curves(mesh).into_iter().flat_map(|h| boundary::Curve::new(mesh, h).take(bound));
    let covered: Vec<_> = steps.collect();
    assert_eq!(covered.iter().collect::<HashSet<_>>().len(), covered.len(), "each once");
    assert_eq!(covered.len(), boundary::edge_count(mesh));
}

pub(super) fn incidence<M: Incidence>(mesh: &M, list: &List, defects: &Defects) {
    relations::incidence(mesh);
    fields::incidence(mesh, list, defects);
    placed::incidence(mesh, list);
    let bound = mesh.half_edge_count() + 1;
    let mut faces = 0;
    for v in mesh.vertices() {
        let star = mesh.star(v).take(bound).count();
        assert_eq!(star::link(mesh, v).take(bound).count(), star);
        let link: HashSet<_> = star::link_vertices(mesh, v).take(bound).collect();
        assert!(mesh.one_ring(v).take(bound).all(|u| link.contains(&u)));
        let fans = mesh.fans(v).take(bound).count();
        assert!(fans <= star && (fans == 0) == mesh.outgoing(v).is_none());
        faces += star;
    }
    assert_eq!(faces, mesh.half_edge_count(), "each half-edge leaves one vertex");
    graph(mesh, list, defects);
}

pub(super) fn graph<G: Neighbours>(graph: &G, list: &List, defects: &Defects) {
    orders::graph(graph, list);
    if defects.degenerate_faces == 0 {
        assert_eq!(degrees::degrees(graph), defects.degrees);
    }
    let mut ring = k_ring::KRing::new();
    for v in (0..graph.node_count().min(4)).map(G::Node::new) {
        ring.search(graph, v, usize::MAX);
        let reached: HashSet<_> = ring.within(usize::MAX).iter().collect();
        assert!(reached.len() == ring.count(usize::MAX) && !reached.contains(&v), "each once");
        let of_levels: usize = (1..=ring.levels()).map(|k| ring.level(k).len()).sum();
        assert_eq!(of_levels, reached.len());
        assert!(ring.level(1).len() == graph.neighbours(v).count());
    }
}

pub(super) fn edge_map<M: EdgeMap>(mesh: &M, _: &List, defects: &Defects) {
    assert_eq!(mesh.edge_count(), defects.edges);
    for e in mesh.edges() {
        let h = mesh.half_edge(e);
        assert!(mesh.edge_fan(h).all(|g| mesh.edge(g) == e));
        let ends = mesh.edge_vertices(e);
        assert!(ends == [mesh.origin(h), mesh.target(h)] || ends == [mesh.target(h), mesh.origin(h)]);
    }
}

pub(super) fn boundaries<M: Boundaries>(mesh: &M, _: &List, defects: &Defects) {
    assert_eq!(Some(mesh.curve_count()), defects.boundary_loops);
    let mut covered = 0;
    for c in mesh.curves() {
        let curve: Vec<_> = mesh.curve(c).take(mesh.half_edge_count() + 1).collect();
        assert_eq!(curve.first(), Some(&mesh.curve_start(c)));
        assert!(curve.iter().all(|&h| mesh.curve_of(h) == Some(c) && mesh.is_boundary(h)));
        covered += curve.len();
    }
    assert_eq!(covered, defects.boundary_edges);
}

/// What every algorithm promises where faces may be degenerate: it ends, and no more is said of its answer.
pub(super) fn of_any_faces<M: Incidence>(mesh: &M, list: &List) {
    orders::topology(mesh, list);
    orders::graph(mesh, list);
    placed::topology(mesh, list);
    fields::of_any_faces(mesh, list);
    placed::of_any_faces(mesh, list);
}

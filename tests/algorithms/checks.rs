//! For each trait, the algorithms over it against slow search. A check has the name that the registry has.
use super::figures::Figures;
use super::samples::held;
use super::slow::{Slow, class_count, sides, undirected};
use onering::neighbours::Neighbours;
use onering::*;
use std::collections::{BTreeMap, BTreeSet};

fn ends<M: Topology>(mesh: &M, h: M::HalfEdge) -> [u32; 2] {
    [mesh.origin(h).index() as u32, mesh.target(h).index() as u32]
}

pub fn topology<M: Topology + FromFaces>() {
    for (sample, mesh) in held::<M>() {
        let slow = Slow::new(sample.vertex_count, &sample.faces);
        let parts = components::components_by_vertex(&mesh);
        let of: Vec<usize> = mesh.faces().map(|f| parts.of(f)).collect();
        assert_eq!(of, slow.components_by_vertex(), "{}", sample.name);
        assert_eq!(umbrella::used_vertex_count(&mesh), slow.star.len(), "{}", sample.name);
    }
}

pub fn adjacency<M: Adjacency + FromFaces>() {
    for (sample, mesh) in held::<M>() {
        let slow = Slow::new(sample.vertex_count, &sample.faces);
        let figures = Figures::of(&mesh);
        assert_eq!(figures, slow.figures(), "{}", sample.name);
        let known = (figures.euler, figures.components, figures.boundary_loops, figures.genus);
        assert_eq!(sample.known.unwrap_or(known), known, "{}", sample.name);

        let parts = components::components(&mesh);
        let of: Vec<usize> = mesh.faces().map(|f| parts.of(f)).collect();
        assert_eq!(of, slow.components(), "{}", sample.name);
        assert_eq!(parts.sizes().len(), class_count(&of), "{}", sample.name);
        assert_eq!(parts.sizes().iter().sum::<usize>(), mesh.face_count(), "{}", sample.name);
        edges_are_named(&mesh, &slow, &sample.name);
        edge_links(&mesh, &slow, &sample.name);
        curves_cover_the_boundary(&mesh, &slow, &sample.name);
        turning_orients(&mesh, &slow, &sample.name);
    }
}

fn edges_are_named<M: Adjacency>(mesh: &M, slow: &Slow, name: &str) {
    let edges = edges::edge_map(mesh);
    let firsts: Vec<_> = edges::each(mesh).collect();
    assert!(firsts.is_sorted(), "{name}");
    assert_eq!(edges.iter().map(|(_, h)| h).collect::<Vec<_>>(), firsts, "{name}");
    let mut along = BTreeMap::<_, Vec<_>>::new();
    mesh.half_edges().for_each(|h| along.entry(undirected(ends(mesh, h))).or_default().push(h));
    assert_eq!(edges.edge_count(), slow.edges.len(), "{name}");
    for half_edges in along.values() {
        let e = edges.edge(half_edges[0]);
        assert!(half_edges.iter().all(|&h| edges.edge(h) == e), "{name}");
        assert_eq!(Some(&edges.half_edge(e)), half_edges.iter().min(), "{name}");
    }
}

fn edge_links<M: Adjacency>(mesh: &M, slow: &Slow, name: &str) {
    for h in mesh.half_edges() {
        let edge = ends(mesh, h);
        let mut link: Vec<u32> = star::edge_link(mesh, h).map(|v| v.index() as u32).collect();
        let mut apexes: Vec<u32> = Vec::new();
        for &(f, _) in &slow.edges[&undirected(edge)] {
            apexes.extend(slow.faces[f].iter().filter(|v| !edge.contains(v)));
        }
        link.sort_unstable();
        apexes.sort_unstable();
        assert_eq!(link, apexes, "{name}");
    }
}

fn curves_cover_the_boundary<M: Adjacency>(mesh: &M, slow: &Slow, name: &str) {
    let starts = boundary::curves(mesh);
    assert!(starts.is_sorted(), "{name}");
    let mut covered = Vec::new();
    let mut closed = 0;
    for &start in &starts {
        let curve: Vec<_> = boundary::Curve::new(mesh, start).collect();
        assert!(curve.windows(2).all(|w| mesh.target(w[0]) == mesh.origin(w[1])), "{name}");
        let last = *curve.last().unwrap();
        let is_closed = boundary::next_along(mesh, last) == Some(start);
        assert!(!is_closed || curve.iter().min() == Some(&start), "{name}");
        closed += usize::from(is_closed);
        covered.extend(curve.into_iter().map(|h| undirected(ends(mesh, h))));
    }
    covered.sort_unstable();
    let boundary = slow.edges.iter().filter(|(_, along)| along.len() == 1).map(|(&edge, _)| edge);
    assert!(covered.into_iter().eq(boundary), "{name}");
    // Nothing stops a turn here, so that curves are the loops.
    if slow.is_oriented() && slow.edges.values().all(|along| along.len() <= 2) {
        assert_eq!((closed, Some(closed)), (starts.len(), slow.boundary_loops()), "{name}");
    }
}

fn turning_orients<M: Adjacency>(mesh: &M, slow: &Slow, name: &str) {
    let Some(turned) = orientation::turned(mesh) else {
        return assert!(!slow.is_orientable(), "{name}");
    };
    let mut faces = slow.faces.clone();
    turned.iter().filter(|&(_, &turned)| turned).for_each(|(f, _)| faces[f.index()].swap(1, 2));
    assert!(Slow::new(slow.vertex_count, &faces).is_oriented(), "{name}");
}

pub fn incidence<M: Incidence + FromFaces>() {
    for (sample, mesh) in held::<M>() {
        let slow = Slow::new(sample.vertex_count, &sample.faces);
        for v in mesh.vertices() {
            let name = format!("{} {v:?}", sample.name);
            let i = v.index() as u32;
            let mut star: Vec<usize> = mesh.star(v).map(|h| mesh.face(h).index()).collect();
            star.sort_unstable();
            assert_eq!(&star, slow.star.get(&i).unwrap_or(&Vec::new()), "{name}");

            let mut link: Vec<_> = star::link(&mesh, v).map(|h| ends(&mesh, h)).collect();
            assert!(!sample.is_clean || link.windows(2).all(|w| w[0][1] == w[1][0]), "{name}");
            link.sort_unstable();
            assert_eq!(link, slow.link(i), "{name}");

            let of_link: Vec<u32> = star::link_vertices(&mesh, v).map(|u| u.index() as u32).collect();
            assert_eq!(of_link.len(), slow.neighbours(i).len(), "{name}");
            assert_eq!(of_link.into_iter().collect::<BTreeSet<_>>(), slow.neighbours(i), "{name}");
            if sample.is_clean {
                let ring: Vec<u32> = mesh.one_ring(v).map(|u| u.index() as u32).collect();
                ring_is_in_order(&ring, i, &slow, &name);
            }
        }
    }
    graph::<M>();
}

/// Each two that follow one another are in a face with `v`, counter-clockwise.
fn ring_is_in_order(ring: &[u32], v: u32, slow: &Slow, name: &str) {
    assert_eq!(ring.iter().copied().collect::<BTreeSet<_>>(), slow.neighbours(v), "{name}");
    assert_eq!(ring.len(), slow.neighbours(v).len(), "{name}");
    for w in ring.windows(2) {
        assert!(slow.link(v).contains(&[w[0], w[1]]), "{name}");
    }
}

pub fn graph<M: Neighbours + FromFaces>() {
    let mut ring = k_ring::KRing::new();
    for (sample, mesh) in held::<M>() {
        let slow = Slow::new(sample.vertex_count, &sample.faces);
        let mut counts = BTreeMap::<usize, usize>::new();
        for v in (0..mesh.node_count()).map(M::Node::new) {
            let name = format!("{} {v:?}", sample.name);
            let i = v.index() as u32;
            let distance = slow.distances(i);
            ring.search(&mesh, v, 4);
            for (k, cells) in (1..).zip(slow.rings_of_cells(i, 4)) {
                let within: BTreeSet<u32> = ring.within(k).iter().map(|u| u.index() as u32).collect();
                assert_eq!(within, cells, "{name}, ring {k}");
                assert_eq!(ring.count(k), cells.len(), "{name}, ring {k}");
                let level: BTreeSet<u32> = ring.level(k).iter().map(|u| u.index() as u32).collect();
                let at_distance = distance.iter().filter(|&(_, &d)| d == k).map(|(&u, _)| u);
                assert_eq!(level, at_distance.collect(), "{name}, level {k}");
            }
            assert_eq!(ring.level(0), [v], "{name}");
            let whole = k_ring::k_ring(&mesh, v, usize::MAX);
            assert_eq!(whole.count(usize::MAX) + 1, distance.len(), "{name}");
            assert_eq!(whole.levels(), distance.into_values().max().unwrap_or(0), "{name}");
            *counts.entry(slow.neighbours(i).len()).or_default() += 1;
        }
        let degrees = degrees::degrees(&mesh);
        let all: BTreeMap<_, _> = (0..99).map(|d| (d, degrees.count(d))).filter(|&(_, n)| n > 0).collect();
        assert_eq!(all, counts, "{}", sample.name);
        assert_eq!(degrees.buckets().iter().sum::<usize>(), slow.star.len(), "{}", sample.name);
        let mean = 2.0 * slow.edges.len() as f64 / slow.star.len() as f64;
        assert!(degrees.mean().is_none_or(|m| (m - mean).abs() < 1e-9), "{}", sample.name);
    }
}

pub fn edge_map<M: EdgeMap + FromFaces>() {
    for (sample, mesh) in held::<M>() {
        let slow = Slow::new(sample.vertex_count, &sample.faces);
        assert_eq!(mesh.edge_count(), slow.edges.len(), "{}", sample.name);
        let named: BTreeSet<_> = mesh.edges().map(|e| undirected(mesh.edge_vertices(e).map(index))).collect();
        assert!(named.iter().eq(slow.edges.keys()), "{}", sample.name);
        for h in mesh.half_edges() {
            let along = mesh.edge_vertices(mesh.edge(h)).map(index);
            assert_eq!(undirected(along), undirected(ends(&mesh, h)), "{}", sample.name);
        }
    }
}

fn index<V: Handle>(v: V) -> u32 {
    v.index() as u32
}

pub fn boundaries<M: Boundaries + FromFaces>() {
    for (sample, mesh) in held::<M>() {
        let slow = Slow::new(sample.vertex_count, &sample.faces);
        assert_eq!(Some(mesh.curve_count()), slow.boundary_loops(), "{}", sample.name);
        let sides_alone = slow.faces.iter().flat_map(|&f| sides(f));
        let mut boundary: BTreeSet<_> =
            sides_alone.filter(|&side| slow.edges[&undirected(side)].len() == 1).collect();
        for c in mesh.curves() {
            let curve: Vec<_> = mesh.curve(c).collect();
            for (&h, &g) in curve.iter().zip(curve.iter().cycle().skip(1)) {
                assert_eq!(mesh.curve_of(h), Some(c), "{}", sample.name);
                assert_eq!(mesh.target(h), mesh.origin(g), "{}", sample.name);
                assert!(boundary.remove(&ends(&mesh, h)), "{}", sample.name);
            }
        }
        assert!(boundary.is_empty(), "{}", sample.name);
    }
}

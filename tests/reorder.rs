//! Reordering: nothing but numbers and order changes, and neighbours come close together.
#![allow(unreachable_pub, reason = "a test has no outside")]
#[path = "common/random.rs"]
mod random;
#[path = "algorithms/samples.rs"]
#[allow(dead_code, reason = "each test uses a part of it")]
mod samples;
#[path = "common/shapes.rs"]
mod shapes;

use onering::dual::Dual;
use onering::neighbours::Neighbours;
use onering::reorder::*;
use onering::*;
use proptest::prelude::*;
use std::collections::BTreeMap;

fn shuffled<T>(mut things: Vec<T>, seed: u64) -> Vec<T> {
    let mut random = shapes::Random(seed);
    (1..things.len()).rev().for_each(|i| things.swap(i, random.below(i + 1)));
    things
}

fn is_permutation(of: impl Iterator<Item = usize>, count: usize) -> bool {
    let mut all: Vec<usize> = of.collect();
    all.sort_unstable();
    all.into_iter().eq(0..count)
}

/// The same faces, corner by corner, under both maps.
fn same_mesh(new: &Reordering, vertex_count: usize, faces: &[[u32; 3]], name: &str) {
    assert!(is_permutation(new.vertex_source.iter().map(|&v| v as usize), vertex_count), "{name}");
    assert!(is_permutation(new.face_source.iter().map(|&f| f as usize), faces.len()), "{name}");
    for (v, &source) in new.vertex_source.iter().enumerate() {
        assert_eq!(new.vertex_target[source as usize] as usize, v, "{name}");
    }
    for (face, &source) in new.faces.iter().zip(&new.face_source) {
        assert_eq!(face.map(|v| new.vertex_source[v as usize]), faces[source as usize], "{name}");
    }
}

fn topology<M: Topology + FromFaces>() {
    for (sample, mesh) in samples::held::<M>() {
        let order = shuffled(mesh.vertices().collect(), 5);
        let new = reorder(&mesh, &order);
        same_mesh(&new, sample.vertex_count, &sample.faces, &sample.name);
        assert!(new.vertex_source.iter().map(|&v| v as usize).eq(order.iter().map(|v| v.index())));
        // By their least vertices, and else as they were.
        let key = |i: usize| (new.faces[i].into_iter().min(), new.face_source[i]);
        assert!((0..new.faces.len()).is_sorted_by_key(key), "{}", sample.name);
        let faces = shuffled(mesh.faces().collect(), 6);
        let new = reorder_both(&mesh, &order, &faces);
        same_mesh(&new, sample.vertex_count, &sample.faces, &sample.name);
        assert!(new.face_source.iter().map(|&f| f as usize).eq(faces.iter().map(|f| f.index())));
    }
}

fn adjacency<M: Adjacency + FromFaces>() {
    for (sample, mesh) in samples::held::<M>() {
        breadth_first_is_by_distance(&Dual::new(&mesh), &sample.name);
    }
}

fn incidence<M: Incidence + FromFaces>() {
    graph::<M>();
}

fn edge_map<M: EdgeMap + FromFaces>() {}

fn boundaries<M: Boundaries + FromFaces>() {}

fn graph<M: Neighbours + FromFaces>() {
    for (sample, mesh) in samples::held::<M>() {
        breadth_first_is_by_distance(&mesh, &sample.name);
        let order = cuthill_mckee(&mesh);
        assert!(is_permutation(order.iter().map(|v| v.index()), sample.vertex_count), "{}", sample.name);
        next_to_an_earlier_one(&mesh, &order, &sample.name);
        let mut reverse = reverse_cuthill_mckee(&mesh);
        reverse.reverse();
        assert_eq!(reverse, order, "{}", sample.name);
    }
    bandwidth_of_a_strip::<M>();
}

/// Component after component, each from its least vertex and by the distance from it.
fn breadth_first_is_by_distance<G: Neighbours>(graph: &G, name: &str) {
    let order = breadth_first(graph);
    assert!(is_permutation(order.iter().map(|v| v.index()), graph.node_count()), "{name}");
    let mut rest = &order[..];
    while let Some(&first) = rest.first() {
        assert_eq!(Some(&first), rest.iter().min(), "{name}");
        let ring = k_ring::k_ring(graph, first, usize::MAX);
        for level in 0..=ring.levels() {
            let (now, later) = rest.split_at(ring.level(level).len());
            let [mut found, mut expected] = [now, ring.level(level)].map(<[_]>::to_vec);
            found.sort_unstable();
            expected.sort_unstable();
            assert_eq!(found, expected, "{name}, level {level}");
            rest = later;
        }
    }
}

/// Each vertex but the first of a component has an earlier neighbour, and the first such never goes back.
fn next_to_an_earlier_one<G: Neighbours>(graph: &G, order: &[G::Node], name: &str) {
    let place: BTreeMap<_, _> = order.iter().zip(0..).map(|(&v, i)| (v, i)).collect();
    let mut last = 0;
    for (i, &v) in order.iter().enumerate() {
        let parent = graph.neighbours(v).map(|u| place[&u]).filter(|&j| j < i).min().unwrap_or(i);
        assert!(parent >= last, "{name}: {v:?} is reached from {parent}, after {last}");
        last = parent;
    }
}

/// A strip of 4 by 200 squares in any order: each number differs by some six from those of its neighbours.
fn bandwidth_of_a_strip<M: Neighbours + FromFaces>() {
    let (n, faces) = shapes::grid(200, 4, [false, false], false);
    let number = shuffled((0..n as u32).collect(), 8);
    let faces: Vec<_> = faces.into_iter().map(|f| f.map(|v| number[v as usize])).collect();
    let mesh = M::from_faces(n, &faces).unwrap();
    let bandwidth = |order: &[M::Node]| {
        let place: BTreeMap<_, usize> = order.iter().zip(0..).map(|(&v, i)| (v, i)).collect();
        let apart = |v: M::Node| mesh.neighbours(v).map(|u| place[&u].abs_diff(place[&v])).max().unwrap();
        order.iter().map(|&v| apart(v)).max().unwrap()
    };
    let before: Vec<_> = (0..n).map(M::Node::new).collect();
    assert!(bandwidth(&before) > 500);
    let after = bandwidth(&cuthill_mckee(&mesh));
    assert!(after <= 10, "{after}");
}

macro_rules! each_trait {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {$(
        mod $name {
            $(#[test]
            fn $has() {
                super::$has::<$mesh>();
            })*
        }
    )+};
}
onering::with_backends!(each_trait);

type Curve = fn(&Map<VertexId, [f32; 3]>) -> Result<Vec<VertexId>, NotFinite>;

const CURVES: [Curve; 2] = [hilbert, morton];

/// The mean difference of the numbers of neighbours falls to that of a good order.
#[test]
fn curves_keep_neighbours_together() {
    let (n, faces) = shapes::grid(128, 128, [true, true], false);
    let number = shuffled((0..n as u32).collect(), 8);
    let faces: Vec<_> = faces.into_iter().map(|f| f.map(|v| number[v as usize])).collect();
    let mut positions = vec![[0.0; 3]; n];
    for (i, &v) in number.iter().enumerate() {
        let [u, w] = [i / 128, i % 128].map(|k| std::f32::consts::TAU * k as f32 / 128.0);
        positions[v as usize] = [(3.0 + w.cos()) * u.cos(), (3.0 + w.cos()) * u.sin(), w.sin()];
    }
    let mesh = SharedVertex::from_faces(n, &faces).unwrap();
    let apart = |faces: &[[u32; 3]]| {
        let sum: u64 = faces.iter().map(|[a, b, c]| u64::from(a.abs_diff(*b) + b.abs_diff(*c))).sum();
        sum as f64 / (2 * faces.len()) as f64
    };
    assert!(apart(&faces) > 5000.0);
    for curve in CURVES {
        let new = reorder(&mesh, &curve(&positions.clone().into()).unwrap());
        same_mesh(&new, n, &faces, "torus");
        // 287 along Hilbert's curve and 205 along Morton's.
        assert!(apart(&new.faces) < 320.0, "{}", apart(&new.faces));
    }
}

#[test]
fn positions_without_a_box() {
    for curve in CURVES {
        let numbers = |positions: &[[f32; 3]]| -> Vec<usize> {
            curve(&positions.to_vec().into()).unwrap().into_iter().map(|v| v.index()).collect()
        };
        assert!(numbers(&[]).is_empty());
        assert_eq!(numbers(&[[2.5; 3]; 4]), [0, 1, 2, 3]);
        let most = f32::MAX;
        assert_eq!(numbers(&[[most; 3], [-most; 3], [0.0, 0.0, -most]]).len(), 3);
        assert_eq!(numbers(&[[1e-45, 0.0, 0.0], [0.0, 0.0, 0.0]]), [1, 0]);
        let error = curve(&vec![[0.0; 3], [0.0, f32::NAN, 0.0]].into()).unwrap_err();
        assert_eq!(error.vertex, 1);
    }
}

#[test]
#[should_panic(expected = "twice")]
fn an_order_has_each_vertex_once() {
    let mesh = SharedVertex::from_faces(3, &[[0, 1, 2]]).unwrap();
    reorder(&mesh, &[0, 1, 1].map(VertexId::new));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_list((vertices, faces) in random::lists(), seed in any::<u64>()) {
        if let Ok(mesh) = SharedVertex::from_faces(vertices, &faces) {
            let mut random = shapes::Random(seed);
            let positions = (0..vertices).map(|_| [(); 3].map(|()| random.below(9) as f32)).collect();
            for curve in CURVES {
                same_mesh(&reorder(&mesh, &curve(&positions).unwrap()), vertices, &faces, "any");
            }
            let graph = VertexGraph::from_faces(vertices, &faces).unwrap();
            same_mesh(&reorder(&mesh, &reverse_cuthill_mckee(&graph)), vertices, &faces, "any");
        }
    }
}

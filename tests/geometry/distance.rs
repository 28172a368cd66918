//! Shortest paths, against the relaxing of all edges until nothing changes (Bellman and Ford).
use super::samples::{held, near};
use super::solids;
use onering::distance::{BadLength, Dijkstra, distances, shortest_path, straight};
use onering::neighbours::Neighbours;
use onering::{FromFaces, Handle, Map};

/// By all edges of all faces, again and again.
pub fn slow(
    count: usize,
    faces: &[[u32; 3]],
    sources: &[usize],
    length: impl Fn(usize, usize) -> f64,
) -> Vec<f64> {
    let mut distance = vec![f64::INFINITY; count];
    sources.iter().for_each(|&v| distance[v] = 0.0);
    let sides = || faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a], [b, a], [c, b], [a, c]]);
    for _ in 0..count {
        for [a, b] in sides().map(|side| side.map(|v| v as usize)) {
            distance[b] = distance[b].min(distance[a] + length(a, b));
        }
    }
    distance
}

/// A path leads from a source to the vertex along edges, and is as long as it says.
pub fn is_sound<G: Neighbours>(
    graph: &G,
    search: &Dijkstra<G::Node>,
    v: G::Node,
    sources: &[usize],
    length: impl Fn(G::Node, G::Node) -> f64,
) -> bool {
    let Some(path) = search.path(v) else { return search.distance(v) == f64::INFINITY };
    let steps = path.vertices.windows(2);
    let total: f64 = steps.clone().map(|w| length(w[0], w[1])).sum();
    sources.contains(&path.vertices[0].index())
        && path.vertices.last() == Some(&v)
        && steps.clone().all(|w| graph.neighbours(w[0]).any(|u| u == w[1]))
        && near(total, path.length, 1e-9 * (1.0 + total))
        && path.length == search.distance(v)
}

pub fn by_relaxing_all<M: Neighbours + FromFaces>() {
    // One scratch for all meshes.
    let mut search = Dijkstra::new();
    for sample in held::<M>() {
        let (graph, count) = (&sample.mesh, sample.mesh.node_count());
        let positions: Map<M::Node, _> = sample.positions.clone().into();
        let length = straight(&positions);
        let by_index = |a: usize, b: usize| length(M::Node::new(a), M::Node::new(b));
        for sources in [vec![], vec![0], vec![count / 2, count.saturating_sub(1), count / 2]] {
            let sources: Vec<usize> = sources.into_iter().filter(|&v| v < count).collect();
            let expected = slow(count, &sample.faces, &sources, by_index);
            let from = || sources.iter().map(|&v| M::Node::new(v));
            let found = distances(graph, from(), &length).unwrap();
            search.search(graph, from(), &length).unwrap();
            for (v, &distance) in &found {
                let expected = expected[v.index()];
                assert!(distance == expected || near(distance, expected, 1e-12), "{} {v:?}", sample.name);
                assert_eq!(search.distance(v), distance, "{} {v:?}", sample.name);
                assert!(is_sound(graph, &search, v, &sources, &length), "{} {v:?}", sample.name);
            }
        }
    }
}

/// A diagonal for each step in both directions, then straight on.
pub fn on_a_plane<M: Neighbours + FromFaces>() {
    let plane = solids::plane(9, 6);
    let (mesh, positions) = (plane.build::<M>(), plane.positions());
    let field = distances(&mesh, [M::Node::new(0)], straight(&positions)).unwrap();
    for (v, &distance) in &field {
        let (i, j) = ((v.index() / 7) as f64, (v.index() % 7) as f64);
        let expected = i.min(j) * 2_f64.sqrt() + (i - j).abs();
        assert!(near(distance, expected, 1e-12), "{v:?}");
    }
    let path =
        shortest_path(&mesh, M::Node::new(0), M::Node::new(16), straight(&positions)).unwrap().unwrap();
    assert_eq!(path.vertices, [0, 8, 16].map(M::Node::new));
    // Uphill costs, downhill is free: lengths need not be the same both ways.
    let uphill = |u: M::Node, v: M::Node| (v.index() as f64 - u.index() as f64).max(0.0);
    let [a, b] = [3, 46].map(M::Node::new);
    assert_eq!(shortest_path(&mesh, b, a, uphill).unwrap().unwrap().length, 0.0);
    assert_eq!(shortest_path(&mesh, a, b, uphill).unwrap().unwrap().length, 43.0);
}

pub fn early_end<M: Neighbours + FromFaces>() {
    let plane = solids::plane(30, 30);
    let (mesh, positions) = (plane.build::<M>(), plane.positions());
    let (from, to) = (M::Node::new(0), M::Node::new(64));
    let mut asked = 0;
    let counted = |u, v| {
        asked += 1;
        straight(&positions)(u, v)
    };
    let path = shortest_path(&mesh, from, to, counted).unwrap().unwrap();
    assert!(near(path.length, 2.0 * 2_f64.sqrt(), 1e-12) && asked < 200, "{asked}");
    assert_eq!(shortest_path(&mesh, to, to, |_, _| f64::NAN).unwrap().unwrap().vertices, [to]);
    // Within a radius: vertices come in the order of their distance.
    let (mut search, mut last) = (Dijkstra::new(), 0.0);
    let reached = |_, distance| {
        assert!(last <= distance);
        last = distance;
        distance > 3.0
    };
    search.search_until(&mesh, [from], straight(&positions), reached).unwrap();
    let beyond = (0..mesh.node_count()).map(M::Node::new).filter(|&v| search.distance(v) > 5.0);
    assert!(beyond.clone().count() > 900 && beyond.clone().all(|v| search.path(v).is_none()));
}

pub fn bad_lengths<M: Neighbours + FromFaces>() {
    let mesh = M::from_faces(4, &[[0, 1, 2], [2, 1, 3]]).unwrap();
    let from = [M::Node::new(0)];
    for bad in [-1.0, f64::NAN, f64::NEG_INFINITY] {
        let length = |u: M::Node, v: M::Node| if u.index() + v.index() == 4 { bad } else { 1.0 };
        let error = distances(&mesh, from, length).unwrap_err();
        assert_eq!((error.from, error.to, error.length.to_bits()), (1, 3, bad.to_bits()));
    }
    let text = BadLength { from: 1, to: 3, length: -1.0 }.to_string();
    assert_eq!(text, "the edge from vertex 1 to 3 has the length -1");
    // An infinite one is no way.
    let wall = |u: M::Node, v: M::Node| if u.index().max(v.index()) == 3 { f64::INFINITY } else { 1.0 };
    assert_eq!(distances(&mesh, from, wall).unwrap().as_slice(), [0.0, 1.0, 1.0, f64::INFINITY]);
    assert_eq!(shortest_path(&mesh, from[0], M::Node::new(3), wall), Ok(None));
}

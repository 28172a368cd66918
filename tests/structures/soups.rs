//! Random triangle soups, with expectations from a slow search.
use crate::meshes::*;
use onering::*;
use std::collections::{BTreeMap, BTreeSet};

const VERTICES: usize = 7;

/// Up to `most` faces over seven vertices, some degenerate.
fn soup(state: &mut u64, most: usize) -> Faces {
    let mut below = |n: usize| {
        *state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (*state >> 33) as usize % n
    };
    let count = 1 + below(most);
    let mut faces: Faces = Vec::new();
    while faces.len() < count {
        let f = [below(VERTICES), below(VERTICES), below(VERTICES)].map(|v| v as u32);
        let is_degenerate = f[0] == f[1] || f[1] == f[2] || f[2] == f[0];
        if !is_degenerate || below(20) == 0 {
            faces.push(f);
        }
    }
    faces
}

/// What a slow search says of a soup.
struct Slow {
    degenerate: bool,
    /// Edge -> (half-edge by corner, whether it runs upwards).
    edges: BTreeMap<[u32; 2], Vec<(usize, bool)>>,
}

impl Slow {
    fn new(faces: &[[u32; 3]]) -> Self {
        let mut edges = BTreeMap::<_, Vec<_>>::new();
        for (f, face) in faces.iter().enumerate() {
            for k in 0..3 {
                let (a, b) = (face[k], face[(k + 1) % 3]);
                edges.entry([a.min(b), a.max(b)]).or_default().push((3 * f + k, a < b));
            }
        }
        let degenerate = edges.keys().any(|&[a, b]| a == b);
        edges.retain(|&[a, b], _| a != b);
        Self { degenerate, edges }
    }

    fn most_faces_on_an_edge(&self) -> usize {
        self.edges.values().map(Vec::len).max().unwrap_or(0)
    }

    fn is_oriented(&self) -> bool {
        self.edges.values().all(|sides| sides.len() < 2 || sides[0].1 != sides[1].1)
    }

    fn neighbours(&self, v: usize) -> Vec<usize> {
        let other = |&[a, b]: &[u32; 2]| {
            let [a, b] = [a as usize, b as usize];
            if a == v { Some(b) } else { (b == v).then_some(a) }
        };
        let all: BTreeSet<usize> = self.edges.keys().filter_map(other).collect();
        all.into_iter().collect()
    }

    /// Faces of `v` in runs that are joined by edges at `v`, whatever their orientation.
    fn fans(&self, faces: &[[u32; 3]], v: usize) -> Vec<BTreeSet<usize>> {
        let of_v = faces.iter().enumerate().filter(|(_, face)| face.contains(&(v as u32)));
        let mut fans: Vec<BTreeSet<usize>> = of_v.map(|(f, _)| BTreeSet::from([f])).collect();
        for (_, sides) in self.edges.iter().filter(|(edge, _)| edge.contains(&(v as u32))) {
            let joined: BTreeSet<usize> = sides.iter().map(|(h, _)| h / 3).collect();
            let (touched, mut rest): (Vec<_>, Vec<_>) =
                fans.into_iter().partition(|fan| !fan.is_disjoint(&joined));
            rest.push(touched.into_iter().flatten().collect());
            fans = rest;
        }
        fans
    }
}

/// What holds for a vertex of any backend that took the soup, by the wider notion of a fan where faces disagree.
fn check_vertex<M: Incidence>(mesh: &M, faces: &[[u32; 3]], slow: &Slow, i: usize) {
    let v = M::Vertex::new(i);
    assert_eq!(sorted(mesh.neighbours(v)), slow.neighbours(i), "{faces:?} v{i}");
    let of_v = (0..faces.len()).filter(|&f| faces[f].contains(&(i as u32)));
    assert_eq!(sorted(mesh.star(v).map(|h| mesh.face(h))), of_v.collect::<Vec<_>>(), "{faces:?} v{i}");
    assert!(mesh.star(v).all(|h| mesh.origin(h) == v), "{faces:?} v{i}");
    assert_eq!(mesh.outgoing(v), mesh.fans(v).next(), "{faces:?} v{i}");
}

fn check_fans<M: Incidence>(mesh: &M, faces: &[[u32; 3]], slow: &Slow, i: usize) {
    let v = M::Vertex::new(i);
    let fans = slow.fans(faces, i);
    assert_eq!(mesh.fans(v).count(), fans.len(), "{faces:?} v{i}");
    let Some(first) = mesh.outgoing(v).map(|h| mesh.face(h).index()) else { return };
    let size = fans.iter().find(|fan| fan.contains(&first)).unwrap().len();
    let ring = indices(mesh.one_ring(v));
    assert!(ring.len() == size || ring.len() == size + 1, "{faces:?} v{i}");
    // Faces in the order of the star lie between neighbours in the order of the ring.
    for (k, h) in mesh.star(v).take(size).enumerate() {
        let face = mesh.face_vertices(mesh.face(h)).map(Handle::index);
        let (a, b) = if ring.len() > size { (k, k + 1) } else { ((k + size - 1) % size, k) };
        assert!(face.contains(&ring[a]) && face.contains(&ring[b]), "{faces:?} v{i}");
        if slow.is_oriented() {
            assert_eq!([mesh.target(h).index(), mesh.origin(mesh.prev(h)).index()], [ring[a], ring[b]]);
        }
    }
    let is_open = fans.iter().any(|fan| {
        let on_fan = |sides: &&Vec<(usize, bool)>| sides.iter().any(|(h, _)| fan.contains(&(h / 3)));
        let at_v = slow.edges.iter().filter(|(edge, _)| edge.contains(&(i as u32)));
        at_v.map(|(_, sides)| sides).filter(on_fan).any(|sides| sides.len() == 1)
    });
    assert_eq!(ring.len() > size, is_open, "open fans come first: {faces:?} v{i}");
}

fn check_edges<M: Adjacency>(mesh: &M, faces: &[[u32; 3]], slow: &Slow) {
    for h in mesh.half_edges() {
        let (a, b) = (mesh.origin(h).index() as u32, mesh.target(h).index() as u32);
        let sides = &slow.edges[&[a.min(b), a.max(b)]];
        let one_each = sides.len() == 2 && sides[0].1 != sides[1].1;
        assert_eq!(
            (mesh.opposite(h).is_some(), mesh.is_boundary(h)),
            (one_each, sides.len() == 1),
            "{faces:?}"
        );
        let fan = sorted(mesh.edge_fan(h).map(|h| mesh.face(h)));
        assert_eq!(fan, sides.iter().map(|(h, _)| h / 3).collect::<Vec<_>>(), "{faces:?}");
        if let Some(o) = mesh.opposite(h) {
            assert_eq!((mesh.origin(o), mesh.target(o)), (mesh.target(h), mesh.origin(h)));
            assert_ne!(mesh.face(o), mesh.face(h));
        }
    }
}

fn check<M: FromFaces + Incidence>(faces: &[[u32; 3]], slow: &Slow, is_held: bool, goes_by_fans: bool) {
    let mesh = M::from_faces(VERTICES, faces);
    assert_eq!(mesh.is_ok(), is_held, "{faces:?}");
    let Ok(mesh) = mesh else { return };
    assert_eq!(mesh.to_faces(), faces);
    check_edges(&mesh, faces, slow);
    for i in 0..VERTICES {
        check_vertex(&mesh, faces, slow, i);
        if goes_by_fans {
            check_fans(&mesh, faces, slow, i);
        }
    }
}

fn check_graph(faces: &[[u32; 3]], slow: &Slow) {
    let graph = VertexGraph::from_faces(VERTICES, faces).unwrap();
    for i in 0..VERTICES {
        assert_eq!(indices(graph.neighbours(v(i))), slow.neighbours(i), "{faces:?}");
    }
    let joined = |a: usize, b: usize| slow.edges.contains_key(&[a as u32, b as u32]);
    let mut cycles = Vec::new();
    for a in 0..VERTICES {
        for b in (a + 1..VERTICES).filter(|&b| joined(a, b)) {
            cycles.extend((b + 1..VERTICES).filter(|&c| joined(a, c) && joined(b, c)).map(|c| [a, b, c]));
        }
    }
    assert_eq!(graph.faces().map(|f| f.map(Handle::index)).collect::<Vec<_>>(), cycles, "{faces:?}");
    for a in 0..VERTICES {
        let through = cycles.iter().filter(|f| f.contains(&a)).count();
        assert_eq!(graph.vertex_faces(v(a)).count(), through, "{faces:?}");
    }
    for &[a, b, c] in &cycles {
        let shared = |f: &&[usize; 3]| f.iter().filter(|&x| [a, b, c].contains(x)).count() == 2;
        let adjacent = graph.adjacent_faces([v(a), v(b), v(c)]).count();
        assert_eq!(adjacent, cycles.iter().filter(shared).count(), "{faces:?}");
    }
}

#[test]
fn soups_are_held_or_refused_as_a_slow_search_says() {
    let mut state = 7;
    let mut held = [0; 3];
    for round in 0..20_000 {
        let faces = soup(&mut state, 1 + round % 14);
        let slow = Slow::new(&faces);
        let graph = !slow.degenerate;
        let mates = graph && slow.most_faces_on_an_edge() <= 2;
        let manifold = mates && slow.is_oriented() && (0..VERTICES).all(|i| slow.fans(&faces, i).len() <= 1);
        for (count, is_held) in held.iter_mut().zip([graph, mates, manifold]) {
            *count += usize::from(is_held);
        }
        check_graph(&faces, &slow);
        check::<AdjacencyGraph>(&faces, &slow, graph, mates && slow.is_oriented());
        check::<MateFace>(&faces, &slow, mates, true);
        check::<HalfEdgeMesh>(&faces, &slow, manifold, true);
        check::<WingedEdge>(&faces, &slow, manifold, true);
    }
    assert!(held.iter().all(|&count| count > 1000), "{held:?}");
}

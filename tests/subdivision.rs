//! Subdivision against the rules written once more over the bare face list, and what is known of smooth surfaces.
#![allow(unreachable_pub, reason = "a test has no outside")]
#[path = "algorithms/samples.rs"]
#[allow(dead_code, reason = "each test uses a part of it")]
mod samples;
#[path = "common/shapes.rs"]
mod shapes;

use onering::subdivision::{Subdivided, SubdivisionError, loop_subdivision, midpoint};
use onering::vector::{self, Vector, length, minus, plus, times};
use onering::*;
use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::PI;

type Positions = Map<VertexId, [f32; 3]>;

fn scattered(count: usize) -> Vec<[f32; 3]> {
    let mut random = shapes::Random(7);
    (0..count).map(|_| [(); 3].map(|()| random.below(2001) as f32 / 100.0 - 10.0)).collect()
}

fn undirected([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]].map(undirected)
}

fn close(a: [f32; 3], b: Vector, what: &str) {
    let apart = length(minus(vector::of(a), b));
    assert!(apart < 1e-5 * (1.0 + length(b)), "{what}: {a:?}, not {b:?}");
}

/// Loop's rules, by search over a face list.
struct Slow<'a> {
    faces: &'a [[u32; 3]],
    positions: &'a [[f32; 3]],
    /// Edge -> far vertices of its faces.
    edges: BTreeMap<[u32; 2], Vec<u32>>,
}

impl<'a> Slow<'a> {
    fn new(faces: &'a [[u32; 3]], positions: &'a [[f32; 3]]) -> Self {
        let mut edges = BTreeMap::<_, Vec<u32>>::new();
        for face in faces {
            for (i, side) in sides(*face).into_iter().enumerate() {
                edges.entry(side).or_default().push(face[(i + 2) % 3]);
            }
        }
        Self { faces, positions, edges }
    }

    fn at(&self, v: u32) -> Vector {
        vector::of(self.positions[v as usize])
    }

    fn edge_point(&self, edge: [u32; 2]) -> Vector {
        let ends = plus(self.at(edge[0]), self.at(edge[1]));
        match self.edges[&edge][..] {
            [c, d] => plus(times(3.0 / 8.0, ends), times(1.0 / 8.0, plus(self.at(c), self.at(d)))),
            _ => times(0.5, ends),
        }
    }

    /// How many groups the faces of a vertex form, where those that share an edge there are together.
    fn umbrellas(&self, v: u32) -> usize {
        let star: Vec<_> = self.faces.iter().filter(|face| face.contains(&v)).collect();
        let mut group: Vec<usize> = (0..star.len()).collect();
        for _ in 0..star.len() {
            for (i, j) in (0..star.len()).flat_map(|i| (0..star.len()).map(move |j| (i, j))) {
                if star[i].iter().filter(|u| star[j].contains(u)).count() > 1 {
                    let least = group[i].min(group[j]);
                    (group[i], group[j]) = (least, least);
                }
            }
        }
        group.into_iter().collect::<BTreeSet<_>>().len()
    }

    fn vertex_point(&self, v: u32) -> Vector {
        let around: Vec<_> = self.edges.iter().filter(|(edge, _)| edge.contains(&v)).collect();
        let far = |edge: &[u32; 2]| self.at(edge[0] + edge[1] - v);
        let creases: Vec<_> = around.iter().filter(|(_, far)| far.len() != 2).collect();
        match (self.umbrellas(v), &creases[..]) {
            (1, []) => {
                let n = around.len() as f64;
                let w = (5.0 / 8.0 - (3.0 / 8.0 + (2.0 * PI / n).cos() / 4.0).powi(2)) / n;
                let sum = around.iter().map(|(edge, _)| far(edge)).fold([0.0; 3], plus);
                plus(times(1.0 - n * w, self.at(v)), times(w, sum))
            }
            (1, [a, b]) => plus(times(0.75, self.at(v)), times(0.125, plus(far(a.0), far(b.0)))),
            _ => self.at(v),
        }
    }
}

fn check<M: Adjacency<Vertex = VertexId> + FromFaces>() {
    for (sample, mesh) in samples::held::<M>() {
        let (n, name) = (sample.vertex_count, &sample.name);
        let positions = scattered(n);
        let slow = Slow::new(&sample.faces, &positions);
        let map = positions.clone().into();
        let [smooth, flat] = [loop_subdivision(&mesh, &map).unwrap(), midpoint(&mesh, &map).unwrap()];
        assert_eq!(smooth.faces, flat.faces, "{name}");
        assert_eq!(smooth.vertex_count, n + slow.edges.len(), "{name}");
        assert_eq!(smooth.positions.len(), smooth.vertex_count, "{name}");
        let mut number = BTreeMap::new();
        for (i, &ends) in smooth.edge_vertices.iter().enumerate() {
            let edge = undirected(ends);
            number.insert(edge, (n + i) as u32);
            close(smooth.positions[n + i], slow.edge_point(edge), name);
            close(flat.positions[n + i], times(0.5, plus(slow.at(edge[0]), slow.at(edge[1]))), name);
        }
        assert_eq!(number.len(), slow.edges.len(), "{name}");
        for v in 0..n {
            close(smooth.positions[v], slow.vertex_point(v as u32), &format!("{name}, vertex {v}"));
            assert_eq!(flat.positions[v], positions[v], "{name}");
        }
        for (f, &[a, b, c]) in sample.faces.iter().enumerate() {
            let [ab, bc, ca] = sides([a, b, c]).map(|edge| number[&edge]);
            let four = [[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]];
            assert_eq!(smooth.faces[4 * f..4 * f + 4], four, "{name}");
            assert!((4 * f..4 * f + 4).all(|part| smooth.face_source(part) == f), "{name}");
        }
        assert_eq!(smooth.faces.len(), 4 * sample.faces.len(), "{name}");
        topology_is_kept(&mesh, &smooth, sample.is_clean, name);
    }
}

/// The same Euler characteristic, twice the boundary edges; and still what every backend takes. Where faces have the
/// same vertices, edges between their new ones fall together, as said.
fn topology_is_kept<M: Adjacency + FromFaces>(mesh: &M, finer: &Subdivided, is_clean: bool, name: &str) {
    let vertices = |f: M::Face| BTreeSet::from(mesh.face_vertices(f));
    if mesh.faces().map(vertices).collect::<BTreeSet<_>>().len() < mesh.face_count() {
        return;
    }
    let fine = match M::from_faces(finer.vertex_count, &finer.faces) {
        Ok(fine) => fine,
        Err(error) => return assert!(!is_clean, "{name}: {error}"),
    };
    assert_eq!(euler::euler_characteristic(&fine), euler::euler_characteristic(mesh), "{name}");
    assert_eq!(boundary::edge_count(&fine), 2 * boundary::edge_count(mesh), "{name}");
}

macro_rules! with_adjacency {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {$(
        $(with_adjacency!(@$has $name $mesh);)*
    )+};
    (@adjacency $name:ident $mesh:ty) => {
        #[test]
        fn $name() {
            check::<$mesh>();
        }
    };
    (@$other:ident $name:ident $mesh:ty) => {};
}
onering::with_backends!(with_adjacency);

const ICOSAHEDRON: [[u32; 3]; 20] = [
    [0, 11, 5],
    [0, 5, 1],
    [0, 1, 7],
    [0, 7, 10],
    [0, 10, 11],
    [1, 5, 9],
    [5, 11, 4],
    [11, 10, 2],
    [10, 7, 6],
    [7, 1, 8],
    [3, 9, 4],
    [3, 4, 2],
    [3, 2, 6],
    [3, 6, 8],
    [3, 8, 9],
    [4, 9, 5],
    [2, 4, 11],
    [6, 2, 10],
    [8, 6, 7],
    [9, 8, 1],
];

fn icosahedron() -> (CheL1, Positions) {
    let t = (1.0 + 5_f32.sqrt()) / 2.0;
    let positions = [
        [-1.0, t, 0.0],
        [1.0, t, 0.0],
        [-1.0, -t, 0.0],
        [1.0, -t, 0.0],
        [0.0, -1.0, t],
        [0.0, 1.0, t],
        [0.0, -1.0, -t],
        [0.0, 1.0, -t],
        [t, 0.0, -1.0],
        [t, 0.0, 1.0],
        [-t, 0.0, -1.0],
        [-t, 0.0, 1.0],
    ];
    (CheL1::from_faces(12, &ICOSAHEDRON).unwrap(), positions.to_vec().into())
}

/// By the limit mask of Loop's scheme, a vertex of n neighbours ends at (1 - n g) v + g (sum), g = 1 / (n + 3 / (8 w)).
#[test]
fn an_icosahedron_comes_close_to_its_limit() {
    let (mut mesh, mut positions) = icosahedron();
    let w = (5.0 / 8.0 - (3.0 / 8.0 + (2.0 * PI / 5.0).cos() / 4.0_f64).powi(2)) / 5.0;
    let g = 1.0 / (5.0 + 3.0 / (8.0 * w));
    // The sum of the five neighbours of a vertex v of an icosahedron is sqrt(5) v.
    let limit = 1.0 - 5.0 * g + g * 5_f64.sqrt();
    let before = positions.clone();
    let mut spread = f64::INFINITY;
    for _ in 0..6 {
        let finer = loop_subdivision(&mesh, &positions).unwrap();
        mesh = CheL1::from_faces(finer.vertex_count, &finer.faces).unwrap();
        positions = finer.positions.into();
        spread = f64::abs(
            length(vector::of(positions[VertexId::new(0)])) / length(vector::of(before[VertexId::new(0)]))
                - limit,
        );
    }
    assert!(spread < 1e-3 * limit, "{spread}");
    let radii = positions.iter().map(|(_, &p)| length(vector::of(p)));
    let (least, most) = radii.fold((f64::INFINITY, 0.0), |(a, b), r| (r.min(a), r.max(b)));
    assert!(most / least < 1.05, "{least} to {most}");
    assert_eq!((mesh.face_count(), boundary::edge_count(&mesh)), (20 << 12, 0));
}

#[test]
fn moving_the_mesh_moves_the_result() {
    let (mesh, positions) = icosahedron();
    let affine = |p: [f32; 3]| {
        let [x, y, z] = vector::of(p);
        vector::rounded([2.0 * x - y + 3.0, 0.5 * z + x - 1.0, 3.0 * y + z + x])
    };
    let moved: Positions = positions.iter().map(|(_, &p)| affine(p)).collect();
    let [before, after] = [&positions, &moved].map(|p| loop_subdivision(&mesh, p).unwrap().positions);
    for (p, q) in before.into_iter().zip(after) {
        close(q, vector::of(affine(p)), "affine");
    }
    let all_here: Positions = vec![[3.0, -2.0, 0.25]; 12].into();
    let finer = loop_subdivision(&mesh, &all_here).unwrap();
    finer.positions.into_iter().for_each(|p| close(p, [3.0, -2.0, 0.25], "weights add up to 1"));
}

#[test]
fn a_plane_stays_a_plane_and_a_straight_border_straight() {
    let (n, faces) = shapes::grid(5, 4, [false, false], false);
    let positions: Positions = (0..n).map(|v| [(v / 5) as f32, (v % 5) as f32, 2.0]).collect();
    let finer = loop_subdivision(&DirectedEdgesSmall::from_faces(n, &faces).unwrap(), &positions).unwrap();
    for [x, y, z] in finer.positions {
        assert!(z == 2.0 && (0.0..=5.0).contains(&x) && (0.0..=4.0).contains(&y), "{x} {y} {z}");
    }
}

/// Six neighbours: 10/16 and 1/16; edges: 3/8 and 1/8; border: 3/4 and 1/8.
#[test]
fn weights_of_a_regular_vertex() {
    let mesh = CheL1::from_faces(7, &shapes::wheel(6)).unwrap();
    let height = |at: usize| -> Vec<f32> {
        let positions: Positions = (0..7).map(|v| [0.0, 0.0, if v == at { 16.0 } else { 0.0 }]).collect();
        loop_subdivision(&mesh, &positions).unwrap().positions.into_iter().map(|p| p[2]).collect()
    };
    let (centre, rim) = (height(0), height(1));
    assert_eq!(centre[..7], [10.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0]);
    assert_eq!(rim[..7], [1.0, 12.0, 2.0, 0.0, 0.0, 0.0, 2.0]);
    let mut edges = [&centre[7..], &rim[7..]].map(<[f32]>::to_vec);
    edges.iter_mut().for_each(|heights| heights.sort_by(f32::total_cmp));
    assert_eq!(edges[0], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 6.0, 6.0, 6.0, 6.0, 6.0, 6.0]);
    assert_eq!(edges[1], [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 2.0, 2.0, 6.0, 8.0, 8.0]);
}

#[test]
fn values_are_carried() {
    let mesh = CheL1::from_faces(4, &[[0, 1, 2], [2, 1, 3]]).unwrap();
    let finer = midpoint(&mesh, &vec![[0.0; 3]; 4].into()).unwrap();
    let values = finer.carry_vertices(&[0, 10, 20, 30], |a, b| (a + b) / 2);
    assert_eq!(values, [0, 10, 20, 30, 5, 15, 10, 20, 25]);
    assert_eq!(finer.carry_faces(&['a', 'b']), ['a', 'a', 'a', 'a', 'b', 'b', 'b', 'b']);
}

/// One face, and as many vertices as it says.
#[derive(Clone)]
struct Huge;

impl Topology for Huge {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    fn vertex_count(&self) -> usize {
        u32::MAX as usize - 1
    }

    fn face_count(&self) -> usize {
        1
    }

    fn origin(&self, h: HalfEdgeId) -> VertexId {
        VertexId::new(h.index())
    }
}

impl Adjacency for Huge {
    fn opposite(&self, _: HalfEdgeId) -> Option<HalfEdgeId> {
        None
    }
}

#[test]
fn what_cannot_be_divided_is_an_error() {
    let none = Positions::default();
    let too_many = [midpoint(&Huge, &none), loop_subdivision(&Huge, &none)];
    for result in too_many {
        let error = result.unwrap_err();
        assert!(matches!(error, SubdivisionError::Limit(BuildError::TooManyVertices { .. })), "{error}");
    }
    let triangle = CheL1::from_faces(3, &[[0, 1, 2]]).unwrap();
    let bad: Positions = vec![[0.0; 3], [0.0, f32::NAN, 0.0], [f32::INFINITY; 3]].into();
    for result in [midpoint(&triangle, &bad), loop_subdivision(&triangle, &bad)] {
        let SubdivisionError::NotFinite(NotFinite { vertex: 1, .. }) = result.unwrap_err() else { panic!() };
    }
}

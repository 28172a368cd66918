//! Minima, maxima and saddles against slow search and the Euler characteristic, on every backend that knows
//! neighbourhoods.
use onering::critical::{self, Kind};
use onering::*;
use std::collections::{BTreeMap, BTreeSet};

#[path = "common/real.rs"]
#[allow(dead_code, reason = "the figures are for the tests of the algorithms")]
mod real;
#[path = "algorithms/samples.rs"]
#[allow(unreachable_pub, dead_code, reason = "shared with the tests of the algorithms")]
mod samples;
#[path = "common/shapes.rs"]
mod shapes;

/// The neighbours of each vertex that has some, and its link, from the faces alone.
struct Slow {
    neighbours: BTreeMap<u32, BTreeSet<u32>>,
    link: BTreeMap<u32, Vec<[u32; 2]>>,
}

impl Slow {
    fn new(faces: &[[u32; 3]]) -> Self {
        let mut slow = Self { neighbours: BTreeMap::new(), link: BTreeMap::new() };
        for &[a, b, c] in faces {
            for [v, x, y] in [[a, b, c], [b, c, a], [c, a, b]] {
                slow.neighbours.entry(v).or_default().extend([x, y]);
                slow.link.entry(v).or_default().push([x, y]);
            }
        }
        slow
    }

    fn plateau(&self, v: u32, values: &[f32]) -> BTreeSet<u32> {
        let mut plateau = BTreeSet::from([v]);
        loop {
            let around = plateau.iter().flat_map(|u| &self.neighbours[u]).copied();
            let level = around.filter(|&u| values[u as usize] == values[v as usize]);
            let larger: BTreeSet<u32> = level.chain(plateau.iter().copied()).collect();
            if larger.len() == plateau.len() {
                return plateau;
            }
            plateau = larger;
        }
    }

    fn minima(&self, values: &[f32]) -> Vec<u32> {
        let is_least = |&v: &u32| {
            let plateau = self.plateau(v, values);
            let mut around = plateau.iter().flat_map(|u| &self.neighbours[u]);
            plateau.first() == Some(&v) && around.all(|&u| values[u as usize] >= values[v as usize])
        };
        self.neighbours.keys().copied().filter(is_least).collect()
    }

    /// The pieces of the link of `v` below it.
    fn lower_pieces(&self, v: u32, values: &[f32]) -> usize {
        let is_lower = |u: u32| (values[u as usize], u) < (values[v as usize], v);
        let mut pieces: BTreeMap<u32, u32> =
            self.neighbours[&v].iter().filter(|&&u| is_lower(u)).map(|&u| (u, u)).collect();
        for _ in 0..pieces.len() {
            for &[x, y] in self.link[&v].iter().filter(|edge| edge.iter().all(|&u| is_lower(u))) {
                let least = pieces[&x].min(pieces[&y]);
                pieces.extend([(x, least), (y, least)]);
            }
        }
        pieces.values().collect::<BTreeSet<_>>().len()
    }

    /// On a manifold: some neighbour has one face with `v` only.
    fn is_on_boundary(&self, v: u32) -> bool {
        self.neighbours[&v].len() > self.link[&v].len()
    }
}

fn indices<V: Handle>(vertices: Vec<V>) -> Vec<u32> {
    vertices.into_iter().map(|v| v.index() as u32).collect()
}

fn incidence<M: Incidence + FromFaces>() {
    let mut random = shapes::Random(3);
    for (sample, mesh) in samples::held::<M>() {
        let slow = Slow::new(&sample.faces);
        for range in [1, 2, 4, 1000] {
            let values: Vec<f32> =
                (0..sample.vertex_count).map(|_| random.below(range) as f32 - 2.0).collect();
            let name = format!("{} of {range} values", sample.name);
            plateaus(&mesh, &slow, &values, &name);
            kinds(&mesh, &slow, &values, sample.is_clean, &name);
        }
        let mut order: Vec<f32> = (0..sample.vertex_count).map(|v| v as f32).collect();
        (1..order.len()).rev().for_each(|i| order.swap(i, random.below(i + 1)));
        both_readings_agree(&mesh, &order, &sample.name);
        kinds(&mesh, &slow, &order, sample.is_clean, &sample.name);
    }
    tips_are_as_defined::<M>(&mut random);
}

fn plateaus<M: Incidence>(mesh: &M, slow: &Slow, values: &[f32], name: &str) {
    let field = Map::from(values.to_vec());
    assert_eq!(indices(critical::local_minima(mesh, &field).unwrap()), slow.minima(values), "{name}");
    let negative: Vec<f32> = values.iter().map(|z| -z).collect();
    assert_eq!(indices(critical::local_maxima(mesh, &field).unwrap()), slow.minima(&negative), "{name}");
}

fn kinds<M: Incidence>(mesh: &M, slow: &Slow, values: &[f32], is_clean: bool, name: &str) {
    let field = Map::from(values.to_vec());
    let kinds = critical::classify(mesh, &field).unwrap();
    let used: Vec<M::Vertex> = mesh.vertices().filter(|&v| kinds[v] != Kind::Isolated).collect();
    assert!(used.iter().map(|v| v.index() as u32).eq(slow.neighbours.keys().copied()), "{name}");
    let sum: isize = used.iter().map(|&v| critical::index(mesh, &field, v)).sum();
    assert_eq!(sum, euler::euler_characteristic(mesh), "{name}");
    if !is_clean {
        return;
    }
    let mut alternating = 0;
    for &v in &used {
        let u = v.index() as u32;
        let pieces = slow.lower_pieces(u, values);
        alternating += match kinds[v] {
            Kind::Minimum => 1,
            Kind::Maximum => isize::from(!slow.is_on_boundary(u)),
            Kind::Saddle { multiplicity } => -(multiplicity as isize),
            Kind::Regular | Kind::Isolated => 0,
        };
        let saddle = if let Kind::Saddle { multiplicity } = kinds[v] { multiplicity } else { 0 };
        assert_eq!(saddle, pieces.saturating_sub(1), "{name} {v:?}");
        assert_eq!(kinds[v] == Kind::Minimum, pieces == 0, "{name} {v:?}");
    }
    assert_eq!(alternating, euler::euler_characteristic(mesh), "{name}");
    let saddles = critical::saddles(mesh, &field).unwrap();
    assert!(saddles.iter().all(|&(v, multiplicity)| kinds[v] == Kind::Saddle { multiplicity }), "{name}");
    let count = used.iter().filter(|&&v| matches!(kinds[v], Kind::Saddle { .. })).count();
    assert_eq!(saddles.len(), count, "{name}");
}

fn both_readings_agree<M: Incidence>(mesh: &M, values: &[f32], name: &str) {
    let field = Map::from(values.to_vec());
    let kinds = critical::classify(mesh, &field).unwrap();
    let of = |kind| mesh.vertices().filter(|&v| kinds[v] == kind).collect::<Vec<_>>();
    assert_eq!(critical::local_minima(mesh, &field).unwrap(), of(Kind::Minimum), "{name}");
    assert_eq!(critical::local_maxima(mesh, &field).unwrap(), of(Kind::Maximum), "{name}");
}

fn tips_are_as_defined<M: Incidence + FromFaces>(random: &mut shapes::Random) {
    for (sample, mesh) in samples::held::<M>() {
        let mut number = || random.below(5) as f32;
        let positions: Vec<[f32; 3]> = (0..sample.vertex_count).map(|_| [(); 3].map(|()| number())).collect();
        let slow = Slow::new(&sample.faces);
        let at = |v: u32| positions[v as usize].map(f64::from);
        // The z of the normals: of each face, its area as seen from above.
        let facing = |v: u32| -> f64 {
            let of = |&[a, b, c]: &[u32; 3]| {
                let [a, b, c] = [a, b, c].map(at);
                (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
            };
            sample.faces.iter().filter(|f| f.contains(&v)).map(of).sum()
        };
        let is_tip = |&v: &u32| slow.neighbours[&v].iter().all(|&u| at(u)[2] >= at(v)[2]) && facing(v) < 0.0;
        let expected: Vec<u32> = slow.neighbours.keys().copied().filter(is_tip).collect();
        let tips = critical::stalactite_tips(&mesh, &Map::from(positions.clone())).unwrap();
        assert_eq!(indices(tips), expected, "{}", sample.name);
    }
}

macro_rules! test_of {
    (incidence $name:ident $mesh:ty) => {
        #[test]
        fn $name() {
            incidence::<$mesh>();
        }
    };
    ($other:ident $name:ident $mesh:ty) => {};
}

macro_rules! each {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {
        $($(test_of! { $has $name $mesh })*)+
    };
}
onering::with_backends!(each);

#[test]
fn an_upright_torus() {
    let (n, m) = (24, 16);
    let (vertex_count, faces) = shapes::grid(n, m, [true, true], false);
    let mesh = CheL2::from_faces(vertex_count, &faces).unwrap();
    let turn = |i: u32, of: u32| std::f64::consts::TAU * (f64::from(i) + 0.1) / f64::from(of);
    let height = |v: u32| ((3.0 + turn(v % m, m).cos()) * turn(v / m, n).sin()) as f32;
    let kinds = critical::classify(&mesh, &(0..vertex_count as u32).map(height).collect()).unwrap();
    let count = |kind| kinds.as_slice().iter().filter(|&&k| k == kind).count();
    let saddle = Kind::Saddle { multiplicity: 1 };
    assert_eq!([Kind::Minimum, saddle, Kind::Maximum].map(count), [1, 2, 1]);
}

#[test]
fn a_monkey_saddle() {
    let faces = shapes::wheel(6);
    let mesh = CheL2::from_faces(7, &faces).unwrap();
    let field = Map::from(vec![0.0, 1.0, -1.0, 1.0, -1.0, 1.0, -1.0]);
    assert_eq!(critical::saddles(&mesh, &field).unwrap(), [(VertexId::new(0), 2)]);
}

#[test]
fn one_large_plateau_is_one() {
    let (vertex_count, faces) = shapes::grid(200, 200, [true, true], false);
    let mesh = CheL2::from_faces(vertex_count, &faces).unwrap();
    let mut field = Map::filled(vertex_count, 1.0);
    assert_eq!(critical::local_minima(&mesh, &field).unwrap(), [VertexId::new(0)]);
    assert_eq!(critical::local_maxima(&mesh, &field).unwrap(), [VertexId::new(0)]);
    field[VertexId::new(777)] = 0.0;
    assert_eq!(critical::local_minima(&mesh, &field).unwrap(), [VertexId::new(777)]);
    assert_eq!(critical::local_maxima(&mesh, &field).unwrap(), [VertexId::new(0)]);
}

#[test]
fn values_are_finite_or_named() {
    let mesh = CheL2::from_faces(4, &[[0, 1, 2], [2, 1, 3]]).unwrap();
    let field = Map::from(vec![0.0, f32::INFINITY, 1.0, 2.0]);
    assert_eq!(critical::local_minima(&mesh, &field).unwrap_err().vertex, 1);
    assert_eq!(critical::local_maxima(&mesh, &field).unwrap_err().vertex, 1);
    assert_eq!(critical::classify(&mesh, &field).unwrap_err().vertex, 1);
    assert_eq!(critical::saddles(&mesh, &field).unwrap_err().vertex, 1);
    let positions = Map::from(vec![[0.0; 3], [0.0; 3], [0.0, f32::NAN, 0.0], [0.0; 3]]);
    assert_eq!(critical::stalactite_tips(&mesh, &positions).unwrap_err().vertex, 2);
}

#[test]
fn real_meshes() {
    for real in real::MESHES.iter() {
        let Ok(mesh) = DirectedEdgesSmall::from_faces(real.mesh.positions.len(), &real.mesh.faces) else {
            continue;
        };
        let height: Map<_, f32> = real.mesh.positions.iter().map(|p| p[2]).collect();
        let mut lowest = vec![f32::INFINITY; height.len()];
        for &[a, b, c] in &real.mesh.faces {
            for [v, u] in
                [[a, b], [b, a], [b, c], [c, b], [c, a], [a, c]].map(|ends| ends.map(|v| v as usize))
            {
                lowest[v] = lowest[v].min(height.as_slice()[u]);
            }
        }
        let used = mesh.vertices().filter(|v| lowest[v.index()] < f32::INFINITY);
        let sum: isize = used.map(|v| critical::index(&mesh, &height, v)).sum();
        assert_eq!(sum, euler::euler_characteristic(&mesh), "{}", real.name);
        let minima = critical::local_minima(&mesh, &height).unwrap();
        let is_strict = |v: &VertexId| lowest[v.index()] > height[*v] && lowest[v.index()] < f32::INFINITY;
        for v in mesh.vertices().filter(is_strict) {
            assert!(minima.binary_search(&v).is_ok(), "{} {v:?}", real.name);
        }
        assert!(minima.iter().all(|v| lowest[v.index()] >= height[*v]), "{}", real.name);
    }
}

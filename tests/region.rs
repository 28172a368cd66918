//! Regions against slow growth on every backend, and stalactites whose faces, area and box are known.
use onering::region::{self, StalactiteOptions};
use onering::*;
use std::cell::Cell;
use std::collections::BTreeSet;

#[path = "algorithms/samples.rs"]
#[allow(unreachable_pub, dead_code, reason = "shared with the tests of the algorithms")]
mod samples;
#[path = "common/shapes.rs"]
mod shapes;

/// Grows face by face until nothing changes. `admits` is asked for a face of the region and the other one.
fn slow_growth(
    faces: &[[u32; 3]],
    seeds: &BTreeSet<usize>,
    admits: impl Fn(usize, usize) -> bool,
) -> BTreeSet<usize> {
    let share_an_edge = |f: usize, g: usize| faces[f].iter().filter(|v| faces[g].contains(v)).count() >= 2;
    let mut region = seeds.clone();
    loop {
        let is_next =
            |g: &usize| !region.contains(g) && region.iter().any(|&f| share_an_edge(f, *g) && admits(f, *g));
        let next: Vec<usize> = (0..faces.len()).filter(is_next).collect();
        if next.is_empty() {
            return region;
        }
        region.extend(next);
    }
}

fn adjacency<M: Adjacency + FromFaces>() {
    for (sample, mesh) in samples::held::<M>() {
        for seed in mesh.faces() {
            let admits = |f: usize, g: usize| !(3 * f + g).is_multiple_of(4);
            let region = region::grow(&mesh, [seed, seed], |h, g| {
                let [f, g] = [h, g].map(|h| mesh.face(h).index());
                assert_ne!(f, g, "{}", sample.name);
                admits(f, g)
            });
            let slow = slow_growth(&sample.faces, &BTreeSet::from([seed.index()]), admits);
            let found: BTreeSet<usize> = region.faces().iter().map(|f| f.index()).collect();
            assert_eq!(found.len(), region.faces().len(), "{}", sample.name);
            assert_eq!(found, slow, "{}", sample.name);
            let vertices: BTreeSet<u32> = slow.iter().flat_map(|&f| sample.faces[f]).collect();
            assert!(region.vertices().iter().map(|v| v.index() as u32).eq(vertices), "{}", sample.name);
        }
    }
}

/// A mesh, as corners and faces.
type Roof = (Vec<[f32; 3]>, Vec<[u32; 3]>);

/// A stalactite around `x`, seen from below, of rings at these (radius, height) from the tip up.
fn stalactite(x: f64, sectors: u32, profile: &[[f64; 2]]) -> Roof {
    let at = |&[radius, z]: &[f64; 2], s: u32| {
        let angle = std::f64::consts::TAU * f64::from(s) / f64::from(sectors);
        [x + radius * angle.cos(), radius * angle.sin(), z].map(|x| x as f32)
    };
    let rings = profile[1..].iter().flat_map(|ring| (0..sectors).map(move |s| at(ring, s)));
    let corners = std::iter::once(at(&profile[0], 0)).chain(rings).collect();
    let v = |ring: u32, s: u32| 1 + (ring - 1) * sectors + s % sectors;
    let tip = (0..sectors).map(|s| [0, v(1, s + 1), v(1, s)]);
    let quad = |r, s| [[v(r, s), v(r + 1, s + 1), v(r + 1, s)], [v(r, s), v(r, s + 1), v(r + 1, s + 1)]];
    let quads = (1..profile.len() as u32 - 1).flat_map(|r| (0..sectors).flat_map(move |s| quad(r, s)));
    (corners, tip.chain(quads).collect())
}

fn joined(parts: impl IntoIterator<Item = Roof>) -> Roof {
    let mut all = (Vec::new(), Vec::new());
    for (corners, faces) in parts {
        let before = all.0.len() as u32;
        all.0.extend(corners);
        all.1.extend(faces.into_iter().map(|f: [u32; 3]| f.map(|v| v + before)));
    }
    all
}

fn built<M: Topology + FromFaces>((corners, faces): &Roof) -> (M, Map<M::Vertex, [f32; 3]>) {
    (M::from_faces(corners.len(), faces).unwrap(), Map::from(corners.clone()))
}

/// Three stalactites, each with a roof around it that rises a little: a sharp one, one of a single ring, and
/// one with a blunt tip.
fn incidence<M: Incidence + FromFaces>() {
    let n = 16;
    let sharp = [[0.0, -8.0], [1.0, -4.0], [2.0, 0.0], [3.0, 0.1], [4.0, 0.3]];
    let single = [[0.0, -3.0], [1.0, 0.0], [2.0, 0.1], [3.0, 0.3]];
    let blunt = [[0.0, -6.0], [0.5, -5.9], [1.0, -5.8], [1.5, -3.0], [2.0, 0.0], [3.0, 0.1], [4.0, 0.2]];
    let roof =
        joined([stalactite(0.0, n, &sharp), stalactite(10.0, n, &single), stalactite(20.0, n, &blunt)]);
    let (mesh, positions) = built::<M>(&roof);
    let tips = critical::stalactite_tips(&mesh, &positions).unwrap();
    assert_eq!(tips.len(), 3);

    let sector = std::f64::consts::PI / f64::from(n);
    // The side of a frustum of a pyramid of n sides.
    let side = |[a, z]: [f64; 2], [b, w]: [f64; 2]| {
        f64::from(n) * sector.sin() * (a + b) * ((b - a) * sector.cos()).hypot(w - z)
    };
    let known = [(0, 0.0, &sharp[..3]), (1, 10.0, &single[..2]), (2, 20.0, &blunt[..5])];
    for (i, x, profile) in known {
        let found = region::stalactite(&mesh, &positions, tips[i], &StalactiteOptions::default()).unwrap();
        assert_eq!(found.faces().len(), n as usize * (2 * profile.len() - 3));
        assert_eq!(found.vertices().len(), n as usize * (profile.len() - 1) + 1);
        let area: f64 = profile.windows(2).map(|w| side(w[0], w[1])).sum();
        assert!((found.area(&mesh, &positions) - area).abs() < 1e-5 * area);
        let (radius, tip) = (profile[profile.len() - 1][0], profile[0][1]);
        let expected = [[x - radius, -radius, tip], [x + radius, radius, 0.0]];
        let found_box = found.bounding_box(&positions).map(|p| p.map(f64::from));
        let close = |p: [f64; 3], q: [f64; 3]| p.iter().zip(q).all(|(a, b)| (a - b).abs() < 1e-5);
        assert!(close(found_box[0], expected[0]) && close(found_box[1], expected[1]), "{found_box:?}");
        // Any vertex of the flank is as good as the tip.
        for &v in found.vertices() {
            let again = region::stalactite(&mesh, &positions, v, &StalactiteOptions::default()).unwrap();
            assert_eq!(again, found, "from {v:?}");
        }
    }
}

macro_rules! test_of {
    (adjacency $name:ident $mesh:ty) => {
        #[test]
        fn grows() {
            crate::adjacency::<$mesh>();
        }
    };
    (incidence $name:ident $mesh:ty) => {
        #[test]
        fn stalactites() {
            crate::incidence::<$mesh>();
        }
    };
    ($other:ident $name:ident $mesh:ty) => {};
}

macro_rules! each {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {
        $(mod $name {
            #[allow(unused_imports, reason = "not every backend has what is tested")]
            use onering::*;
            $(test_of! { $has $name $mesh })*
        })+
    };
}
onering::with_backends!(each);

/// A square roof that hangs down in two cones, whose flanks meet.
fn two_cones(side: u32) -> Roof {
    let row = side + 1;
    let corner = |i: u32| {
        let [x, y] = [i % row, i / row].map(|k| f64::from(k) / f64::from(side));
        let cone = |cx: f64, depth: f64| (4.0 * (x - cx).hypot(y - 0.52) - depth).min(0.0);
        [x, y, cone(0.3, 1.0).min(cone(0.7, 1.2))].map(|x| x as f32)
    };
    let cell = |i: u32| {
        let a = i / side * row + i % side;
        [[a, a + row + 1, a + 1], [a, a + row, a + row + 1]]
    };
    ((0..row * row).map(corner).collect(), (0..side * side).flat_map(cell).collect())
}

/// The rule, written down again: slowly, and over the faces alone.
fn slow_stalactite((corners, faces): &Roof, tip: u32, steep: f64) -> BTreeSet<usize> {
    let z = |v: u32| corners[v as usize][2];
    let is_steep = |f: usize| {
        let [a, b, c] = faces[f].map(|v| corners[v as usize].map(f64::from));
        let [p, q] = [b, c].map(|b| [0, 1, 2].map(|i| b[i] - a[i]));
        let n = [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
        n[0].hypot(n[1]).atan2(n[2].abs()) >= steep.to_radians()
    };
    let rises = |f: usize, g: usize| {
        let shared = faces[g].iter().filter(|v| faces[f].contains(v)).map(|&v| z(v));
        let apex = faces[g].iter().find(|v| !faces[f].contains(v)).unwrap();
        z(*apex) >= shared.fold(f32::INFINITY, f32::min)
    };
    let at_tip = (0..faces.len()).filter(|&f| faces[f].contains(&tip)).collect();
    let cap = slow_growth(faces, &at_tip, |f, g| rises(f, g) && !is_steep(f) && !is_steep(g));
    let all = slow_growth(faces, &cap, |f, g| rises(f, g) && is_steep(g));
    if all.iter().any(|&f| is_steep(f)) { all } else { at_tip }
}

#[test]
fn stalactites_that_have_grown_together() {
    let roof = two_cones(24);
    let (mesh, positions) = built::<CheL2>(&roof);
    let height: Map<_, f32> = roof.0.iter().map(|p| p[2]).collect();
    let tips = critical::local_minima(&mesh, &height).unwrap();
    let tips: Vec<_> = tips.into_iter().filter(|&v| height[v] < -0.5).collect();
    assert_eq!(tips.len(), 2);
    let find = |tip| region::stalactite(&mesh, &positions, tip, &StalactiteOptions::default()).unwrap();
    let found = [tips[0], tips[1]].map(find);
    for (i, region) in found.iter().enumerate() {
        let faces: BTreeSet<usize> = region.faces().iter().map(|f| f.index()).collect();
        assert_eq!(faces, slow_stalactite(&roof, tips[i].index() as u32, 45.0));
        assert!(faces.len() > 100 && !region.vertices().contains(&tips[1 - i]));
        assert!(region.vertices().iter().filter(|&&v| height[v] == 0.0).count() < 60, "the roof is left out");
    }
}

#[test]
fn a_roof_without_stalactites() {
    let (corners, faces) = two_cones(8);
    let flat: Vec<_> = corners.iter().map(|&[x, y, z]| [x, y, 0.01 * z]).collect();
    let (mesh, positions) = built::<CheL2>(&(flat, faces));
    let v = VertexId::new(40);
    let found = region::stalactite(&mesh, &positions, v, &StalactiteOptions::default()).unwrap();
    assert!(found.faces().len() <= 6, "the faces at the tip alone");
    let gentle = region::stalactite(&mesh, &positions, v, &StalactiteOptions { steep: 0.5 }).unwrap();
    assert!(gentle.faces().len() > 12, "steep is what the caller says");
}

#[test]
fn nothing_around_an_isolated_vertex() {
    let mesh = CheL2::from_faces(4, &[[0, 1, 2]]).unwrap();
    let positions = Map::filled(4, [0.0; 3]);
    let isolated = VertexId::new(3);
    let found = region::stalactite(&mesh, &positions, isolated, &StalactiteOptions::default()).unwrap();
    assert!(found.faces().is_empty() && found.vertices().is_empty());
    assert_eq!(found.area(&mesh, &positions), 0.0);
    assert_eq!(found.bounding_box(&positions), [[f32::INFINITY; 3], [f32::NEG_INFINITY; 3]]);
    let nan = Map::filled(4, [0.0, 0.0, f32::NAN]);
    assert!(region::stalactite(&mesh, &nan, isolated, &StalactiteOptions::default()).is_err());
}

/// A structure that counts how often it goes from one face of an edge to the next.
struct Counted {
    mesh: DirectedEdgesSmall,
    steps: Cell<usize>,
}

impl Topology for Counted {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    fn vertex_count(&self) -> usize {
        self.mesh.vertex_count()
    }

    fn face_count(&self) -> usize {
        self.mesh.face_count()
    }

    fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.mesh.origin(h)
    }
}

impl Adjacency for Counted {
    fn opposite(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.mesh.opposite(h)
    }

    fn edge_fan(&self, h: HalfEdgeId) -> impl Iterator<Item = HalfEdgeId> {
        self.mesh.edge_fan(h).inspect(|_| self.steps.set(self.steps.get() + 1))
    }
}

impl Incidence for Counted {
    fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId> {
        self.mesh.outgoing(v)
    }

    fn fans(&self, v: VertexId) -> impl Iterator<Item = HalfEdgeId> {
        self.mesh.fans(v)
    }
}

/// A tip below an edge of many faces, every other of them steep. To pass all of them by from each took the square.
#[test]
fn an_edge_of_many_faces_is_passed_over_a_few_times() {
    let pages = 1000;
    let faces: Vec<[u32; 3]> =
        std::iter::once([0, 1, 2]).chain((0..pages).map(|page| [1, 2, page + 3])).collect();
    let page = |page: u32| if page.is_multiple_of(2) { [0.5, 0.001, 0.0] } else { [0.5, 1.0, -0.999] };
    let positions = [[0.5, -1.0, -1.01], [0.0, 0.0, -1.0], [1.0, 0.0, -1.0]].into_iter();
    let positions: Map<VertexId, [f32; 3]> = positions.chain((0..pages).map(page)).collect();
    let mesh = DirectedEdgesSmall::from_faces(positions.len(), &faces).unwrap();
    let mesh = Counted { mesh, steps: Cell::new(0) };
    let most = 20 * faces.len();
    let all = region::grow(&mesh, [FaceId::new(0)], |_, _| true);
    assert_eq!(all.faces().len(), faces.len());
    assert!(mesh.steps.replace(0) <= most);
    let tip = VertexId::new(0);
    let found = region::stalactite(&mesh, &positions, tip, &StalactiteOptions::default()).unwrap();
    assert_eq!(found.faces().len(), faces.len());
    assert!(mesh.steps.get() <= most, "{} steps", mesh.steps.get());
}

#[test]
fn a_degenerate_face_is_in_a_region_once() {
    let soup = SharedVertex::from_faces(3, &[[0, 0, 1], [0, 1, 2]]).unwrap();
    let mesh = Searched::new(soup);
    let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]].into();
    let found =
        region::stalactite(&mesh, &positions, VertexId::new(0), &StalactiteOptions::default()).unwrap();
    let mut faces = found.faces().to_vec();
    faces.sort_unstable();
    assert_eq!(faces, [0, 1].map(FaceId::new));
}

//! Filled holes: closed afterwards, in one orientation, by no edge too many, and with the least area where that is asked.
#![allow(unreachable_pub, reason = "a test has no outside")]
#[path = "common/real.rs"]
#[allow(dead_code, reason = "figures are for other tests")]
mod real;
#[path = "algorithms/samples.rs"]
#[allow(dead_code, reason = "each test uses a part of it")]
mod samples;
#[path = "common/shapes.rs"]
mod shapes;

use onering::holes::{FillOptions, Filled, LeftReason, fill};
use onering::repair::{RepairOptions, repair};
use onering::vector::{cross, dot, length, minus, of};
use onering::*;
use std::collections::{BTreeMap, BTreeSet};

fn scattered(count: usize, seed: u64) -> Vec<[f32; 3]> {
    let mut random = shapes::Random(seed);
    (0..count).map(|_| [(); 3].map(|()| random.below(2001) as f32 / 100.0 - 10.0)).collect()
}

/// How to fill: the best way, by area alone, by ears, and each with few edges.
fn ways() -> [FillOptions; 4] {
    let mut ways = [FillOptions::default(); 4];
    ways[1].weigh_folds = false;
    ways[2].optimal_edges = 0;
    ways[3].max_edges = 4;
    ways
}

/// Edge -> how often faces run along it, from the lesser end and from the greater.
fn edges(faces: &[[u32; 3]]) -> BTreeMap<[u32; 2], [usize; 2]> {
    let mut edges = BTreeMap::<_, [usize; 2]>::new();
    for [a, b] in faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]) {
        edges.entry([a.min(b), a.max(b)]).or_default()[usize::from(a > b)] += 1;
    }
    edges
}

/// What has to hold whatever the mesh and the options.
fn obeys<M: Adjacency>(mesh: &M, filled: &Filled<M::HalfEdge>, name: &str) {
    let before = mesh.to_faces();
    let all = [before.clone(), filled.faces.clone()].concat();
    let (before_edges, after_edges) = (edges(&before), edges(&all));
    for (edge, along) in &after_edges {
        let was = before_edges.get(edge).map_or(0, |along| along[0] + along[1]);
        assert!(along[0] + along[1] == was || *along == [1, 1], "{name}: {edge:?} has {along:?}, had {was}");
    }
    let mut starts: Vec<_> = filled.filled.iter().map(|curve| curve.start).collect();
    starts.extend(filled.left.iter().map(|curve| curve.start));
    starts.sort_unstable();
    assert_eq!(starts, boundary::curves(mesh), "{name}");
    let mut end = 0;
    for curve in &filled.filled {
        assert_eq!(curve.faces.start, end, "{name}");
        end = curve.faces.end;
        let side = |h| [mesh.origin(h), mesh.target(h)].map(|v| v.index() as u32);
        let sides = boundary::Curve::new(mesh, curve.start).map(side);
        assert!(sides.into_iter().all(|[a, b]| after_edges[&[a.min(b), a.max(b)]] == [1, 1]), "{name}");
    }
    assert_eq!(end, filled.faces.len(), "{name}");
    let vertices = |face: &[u32; 3]| BTreeSet::from(*face);
    let distinct = |faces: &[[u32; 3]]| faces.iter().map(vertices).collect::<BTreeSet<_>>().len();
    assert_eq!(distinct(&all), distinct(&before) + filled.faces.len(), "{name}: a copy of a face");
}

fn check<M: Adjacency<Vertex = VertexId> + FromFaces>() {
    for (sample, mesh) in samples::held::<M>() {
        let positions = scattered(sample.vertex_count, 11).into();
        for (way, options) in ways().iter().enumerate() {
            let name = format!("{}, way {way}", sample.name);
            let filled = fill(&mesh, &positions, options).unwrap();
            obeys(&mesh, &filled, &name);
            for curve in &filled.left {
                let half_edges: Vec<_> = boundary::Curve::new(&mesh, curve.start).collect();
                let last = *half_edges.last().unwrap();
                let is_closed = boundary::next_along(&mesh, last) == Some(curve.start);
                match curve.reason {
                    LeftReason::EndsEarly => assert!(!is_closed, "{name}"),
                    LeftReason::TooLong => assert!(half_edges.len() > options.max_edges, "{name}"),
                    _ => assert!(is_closed, "{name}"),
                }
            }
            let all = [sample.faces.clone(), filled.faces].concat();
            let is_whole = sample.is_clean && M::from_faces(sample.vertex_count, &all).is_err();
            assert!(!is_whole, "{name}: no backend takes it");
        }
    }
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

fn area(faces: &[[u32; 3]], positions: &[[f32; 3]]) -> f64 {
    let at = |v: u32| of(positions[v as usize]);
    let doubled = |&[a, b, c]: &[u32; 3]| length(cross(minus(at(b), at(a)), minus(at(c), at(a))));
    faces.iter().map(doubled).sum::<f64>() / 2.0
}

fn volume(faces: &[[u32; 3]], positions: &[[f32; 3]]) -> f64 {
    let at = |v: u32| of(positions[v as usize]);
    faces.iter().map(|&[a, b, c]| dot(at(a), cross(at(b), at(c)))).sum::<f64>() / 6.0
}

/// A wall of quads that stands on the outline of a polygon in the plane, which is its hole below; the other is above.
fn wall(outline: &[[f32; 2]]) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let n = outline.len() as u32;
    let at = |z: f32| outline.iter().map(move |&[x, y]| [x, y, z]);
    let quad = |i: u32| [[i, (i + 1) % n, n + i], [(i + 1) % n, n + (i + 1) % n, n + i]];
    (at(0.0).chain(at(1.0)).collect(), (0..n).flat_map(quad).collect())
}

/// A star with deep notches, and a spiral: concave, of known area by the shoelace formula.
fn outlines() -> Vec<Vec<[f32; 2]>> {
    let polar = |r: f32, turn: f32| {
        [r * (turn * std::f32::consts::TAU).cos(), r * (turn * std::f32::consts::TAU).sin()]
    };
    let star = |n: usize| (0..2 * n).map(|i| polar([1.0, 0.3][i % 2], i as f32 / (2 * n) as f32)).collect();
    let outward = (0..60).map(|i| polar(1.0 + i as f32 * 0.1, i as f32 / 20.0));
    let back = (0..60).rev().map(|i| polar(0.8 + i as f32 * 0.1, i as f32 / 20.0));
    vec![star(3), star(7), star(40), star(300), outward.chain(back).rev().collect(), outward_of_a_comb()]
}

fn outward_of_a_comb() -> Vec<[f32; 2]> {
    let teeth =
        (0..50).rev().flat_map(|i| [[i as f32 + 0.6, 1.0], [i as f32 + 0.5, 9.0], [i as f32 + 0.4, 1.0]]);
    [[0.0, 0.0], [50.0, 0.0]].into_iter().chain(teeth).collect()
}

/// Twice the area is covered, below and above, so no triangle lies outside, and the volume is that of the prism.
#[test]
fn a_flat_hole_gets_its_area() {
    for outline in outlines() {
        let next = |i: usize| outline[(i + 1) % outline.len()];
        let shoelace = |(i, p): (usize, &[f32; 2])| {
            f64::from(p[0]) * f64::from(next(i)[1]) - f64::from(p[1]) * f64::from(next(i)[0])
        };
        let known = (outline.iter().enumerate().map(shoelace).sum::<f64>() / 2.0).abs();
        let (positions, faces) = wall(&outline);
        let mesh = CheL2::from_faces(positions.len(), &faces).unwrap();
        for options in &ways()[..3] {
            let filled = fill(&mesh, &positions.clone().into(), options).unwrap();
            obeys(&mesh, &filled, "wall");
            assert!(filled.left.is_empty() && filled.filled.len() == 2);
            let found = area(&filled.faces, &positions);
            assert!((found - 2.0 * known).abs() < 1e-4 * known, "{} edges: {found}, {known}", outline.len());
            let all = [faces.clone(), filled.faces].concat();
            assert!((volume(&all, &positions).abs() - known).abs() < 1e-4 * known, "{} edges", outline.len());
        }
    }
}

/// All triangulations of a loop, by the triangle at its last edge.
fn least_area(loop_: &[u32], positions: &[[f32; 3]]) -> f64 {
    if loop_.len() < 3 {
        return 0.0;
    }
    let last = loop_.len() - 1;
    let with = |j: usize| {
        area(&[[loop_[0], loop_[j], loop_[last]]], positions)
            + least_area(&loop_[..=j], positions)
            + least_area(&loop_[j..], positions)
    };
    (1..last).map(with).fold(f64::INFINITY, f64::min)
}

#[test]
fn no_triangulation_has_less_area() {
    for seed in 0..20 {
        let n = 4 + seed as usize % 6;
        let faces: Vec<_> = shapes::wheel(n as u32).into_iter().map(|[a, b, c]| [a, c, b]).collect();
        let mesh = HalfEdgeMesh::from_faces(n + 1, &faces).unwrap();
        let positions = scattered(n + 1, seed);
        let filled = fill(&mesh, &positions.clone().into(), &ways()[1]).unwrap();
        let rim: Vec<u32> = (1..=n as u32).collect();
        let (found, least) = (area(&filled.faces, &positions), least_area(&rim, &positions));
        assert!((found - least).abs() < 1e-9 * least, "{n} edges: {found}, {least}");
    }
}

/// A sphere of triangles with round holes cut into it: nearly the area and the volume of the sphere again.
#[test]
fn a_sphere_is_whole_again() {
    let (rows, columns) = (40, 80);
    let angle = |i: u32, n: u32| std::f64::consts::PI * f64::from(i) / f64::from(n);
    let point = |i: u32, j: u32| {
        let (latitude, longitude) = (angle(i, rows), 2.0 * angle(j, columns));
        [latitude.sin() * longitude.cos(), latitude.sin() * longitude.sin(), latitude.cos()].map(|x| x as f32)
    };
    let mut positions = vec![];
    (1..rows).for_each(|i| (0..columns).for_each(|j| positions.push(point(i, j))));
    let v = |i: u32, j: u32| (i - 1) * columns + j % columns;
    let quad = |i, j| [[v(i, j), v(i + 1, j), v(i + 1, j + 1)], [v(i, j), v(i + 1, j + 1), v(i, j + 1)]];
    let mut faces: Vec<_> = (1..rows - 1).flat_map(|i| (0..columns).flat_map(move |j| quad(i, j))).collect();
    let axis = |p: [f32; 3]| p[0] > 0.97 || p[1] > 0.97 || p[0] + p[1] < -1.38;
    faces.retain(|face| !face.iter().any(|&v| axis(positions[v as usize])));
    let mesh = MateFace::from_faces(positions.len(), &faces).unwrap();
    for options in &ways()[..3] {
        let filled = fill(&mesh, &positions.clone().into(), options).unwrap();
        obeys(&mesh, &filled, "sphere");
        assert_eq!((filled.filled.len(), filled.left.len()), (5, 0));
        let all = [faces.clone(), filled.faces].concat();
        let closed = MateFace::from_faces(positions.len(), &all).unwrap();
        assert!(boundary::edge_count(&closed) == 0 && euler::genus(&closed) == Some(0));
        let sphere = 4.0 * std::f64::consts::PI;
        let (area, volume) = (area(&all, &positions), volume(&all, &positions));
        assert!((area / sphere - 1.0).abs() < 0.03, "{area}, {sphere}");
        assert!((3.0 * volume / sphere - 1.0).abs() < 0.03, "{volume}, {sphere}");
    }
}

/// A square with a square hole that touches another in a corner: one curve, two loops.
#[test]
fn holes_that_touch_in_a_vertex() {
    let (n, mut faces) = shapes::grid(6, 6, [false, false], false);
    let mut face = 0..;
    faces.retain(|_| ![7, 14].contains(&(face.next().unwrap() / 2)));
    let positions: Vec<_> = (0..n).map(|v| [(v / 7) as f32, (v % 7) as f32, 0.0]).collect();
    let mesh = DirectedEdgesSmall::from_faces(n, &faces).unwrap();
    let mut options = FillOptions::default();
    options.max_edges = 8;
    let filled = fill(&mesh, &positions.clone().into(), &options).unwrap();
    obeys(&mesh, &filled, "touching holes");
    assert_eq!((filled.faces.len(), filled.filled.len(), filled.left.len()), (4, 1, 1));
    assert_eq!(filled.left[0].reason, LeftReason::TooLong);
    assert_eq!(area(&filled.faces, &positions), 2.0);
    let all = [faces, filled.faces].concat();
    assert!(CheL3::from_faces(n, &all).is_ok_and(|mesh| mesh.curve_count() == 1));
}

/// A lone triangle would be filled by its own copy; so would the two of a bowtie.
#[test]
fn a_copy_of_a_face_fills_nothing() {
    let bowtie = DirectedEdgesSmall::from_faces(5, &[[0, 1, 2], [0, 3, 4]]).unwrap();
    let filled = fill(&bowtie, &scattered(5, 1).into(), &FillOptions::default()).unwrap();
    assert!(filled.faces.is_empty() && filled.filled.is_empty());
    assert!(filled.left.iter().all(|curve| curve.reason == LeftReason::NoWay) && filled.left.len() == 2);
}

/// Two holes of four edges around the same two vertices: the chord between them is for one of them only.
#[test]
fn a_chord_is_used_once() {
    // A ring of four quads, two of them missing, whose corners 0 and 2 both have.
    let faces = [[0, 1, 4], [1, 2, 4], [0, 5, 3], [5, 2, 3]];
    let positions = [
        [0.0, 0.0, 0.0],
        [1.0, 1.0, 0.0],
        [2.0, 0.0, 0.0],
        [1.0, -1.0, 0.0],
        [1.0, 1.0, 1.0],
        [1.0, -1.0, 1.0],
    ];
    let mesh = DirectedEdgesSmall::from_faces(6, &faces).unwrap();
    for options in &ways()[..3] {
        let filled = fill(&mesh, &positions.to_vec().into(), options).unwrap();
        obeys(&mesh, &filled, "two pairs of wings");
    }
}

/// A loop of which every chord is an edge already is left, and nothing else with it.
#[test]
fn a_hole_whose_chords_are_there_is_left() {
    // The torus of seven vertices has all edges that there can be; two faces that share an edge are missing.
    let torus: Vec<_> = (0..7).flat_map(|i| [[0, 1, 3], [0, 3, 2]].map(|f| f.map(|k| (i + k) % 7))).collect();
    let mesh = CheL1::from_faces(7, &torus[2..]).unwrap();
    let filled = fill(&mesh, &scattered(7, 4).into(), &FillOptions::default()).unwrap();
    obeys(&mesh, &filled, "torus of seven");
    // The chord that was the edge between both is free again, and the other one taken.
    let mut new: Vec<_> = filled.faces.iter().map(|face| BTreeSet::from(*face)).collect();
    let mut old: Vec<_> = torus[..2].iter().map(|face| BTreeSet::from(*face)).collect();
    new.sort();
    old.sort();
    assert_eq!(new, old);
    let again = [&torus[2..], &[[0, 7, 3], [3, 7, 0]]].concat();
    let taken = DirectedEdgesSmall::from_faces(8, &again).unwrap();
    let filled = fill(&taken, &scattered(8, 4).into(), &FillOptions::default()).unwrap();
    assert!(filled.left.iter().any(|curve| curve.reason == LeftReason::NoWay), "{filled:?}");
    obeys(&taken, &filled, "torus of seven, its chord taken");
}

#[test]
fn a_position_that_is_no_number_is_an_error() {
    let mesh = CheL1::from_faces(3, &[[0, 1, 2]]).unwrap();
    let positions = vec![[0.0; 3], [0.0; 3], [f32::NAN; 3]].into();
    assert_eq!(fill(&mesh, &positions, &FillOptions::default()).unwrap_err().vertex, 2);
}

/// Scans with holes are closed after repair and filling.
#[test]
fn real_meshes_are_closed() {
    for name in ["many_small_holes.ply", "elephant_with_holes.off"] {
        let Some(real) = real::MESHES.iter().find(|real| real.name == name) else { continue };
        let repaired =
            repair(real.mesh.positions.len(), &real.mesh.faces, &RepairOptions::default()).unwrap();
        let positions = repaired.carry_vertices(&real.mesh.positions);
        let mesh = CheL3::from_faces(repaired.vertex_count, &repaired.faces).unwrap();
        assert!(mesh.curve_count() > 0);
        let filled = fill(&mesh, &positions.into(), &FillOptions::default()).unwrap();
        obeys(&mesh, &filled, name);
        assert!(filled.left.is_empty(), "{name}: {:?}", filled.left);
        let all = [repaired.faces, filled.faces].concat();
        let closed = CheL3::from_faces(repaired.vertex_count, &all).unwrap();
        assert_eq!(closed.curve_count(), 0, "{name}");
    }
}

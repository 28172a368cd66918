//! Contours against segments found face by face, on every backend that has opposites; and against circles.
use onering::contours::{self, Contours, Line};
use onering::*;
use proptest::prelude::*;
use std::collections::BTreeMap;

#[path = "common/real.rs"]
#[allow(dead_code, reason = "the figures are for the tests of the algorithms")]
mod real;
#[path = "algorithms/samples.rs"]
#[allow(unreachable_pub, dead_code, reason = "shared with the tests of the algorithms")]
mod samples;
#[path = "common/shapes.rs"]
mod shapes;

type Edge = [u32; 2];

fn edge(a: u32, b: u32) -> Edge {
    [a.min(b), a.max(b)]
}

/// The edges that a level crosses in a face: none or two.
fn crossed([a, b, c]: [u32; 3], field: &[f32], level: f32) -> Vec<Edge> {
    let is_crossed = |&[a, b]: &Edge| (field[a as usize] >= level) != (field[b as usize] >= level);
    [edge(a, b), edge(b, c), edge(c, a)].into_iter().filter(is_crossed).collect()
}

/// The segments of a level, found face by face.
fn slow_segments(faces: &[[u32; 3]], field: &[f32], level: f32) -> Vec<[Edge; 2]> {
    let ends = faces.iter().map(|&f| crossed(f, field, level)).filter(|ends| !ends.is_empty());
    let mut segments: Vec<_> = ends.map(|ends| [ends[0].min(ends[1]), ends[0].max(ends[1])]).collect();
    segments.sort_unstable();
    segments
}

fn edge_of<M: Topology>(mesh: &M, h: M::HalfEdge) -> Edge {
    edge(mesh.origin(h).index() as u32, mesh.target(h).index() as u32)
}

/// The edges that a line crosses, the first once more at the end of a closed one.
fn edges_of<M: Topology>(mesh: &M, line: &Line<'_, M::HalfEdge>) -> Vec<Edge> {
    let crossings = line.crossings.iter().chain(line.crossings.iter().take(usize::from(line.is_closed)));
    crossings.map(|c| edge_of(mesh, c.half_edge)).collect()
}

/// Number of faces along each edge.
fn face_counts(faces: &[[u32; 3]]) -> BTreeMap<Edge, usize> {
    let mut counts = BTreeMap::new();
    let sides = faces.iter().flat_map(|&[a, b, c]| [edge(a, b), edge(b, c), edge(c, a)]);
    sides.for_each(|side| *counts.entry(side).or_default() += 1);
    counts
}

/// Every law that the lines of a level obey.
fn check<M: Adjacency>(mesh: &M, faces: &[[u32; 3]], values: &[f32], levels: &[f32], name: &str) {
    let field = Map::from(values.to_vec());
    let found = contours::contours(mesh, &field, levels).unwrap();
    assert!(found.lines().map(|line| line.level).is_sorted(), "{name}");
    let counts = face_counts(faces);
    let mut total = 0;
    for &level in levels {
        let lines: Vec<_> = found.lines().filter(|line| line.level == level).collect();
        let mut segments = Vec::new();
        let mut crossings = BTreeMap::<Edge, usize>::new();
        for line in &lines {
            total += line.crossings.len();
            let edges = edges_of(mesh, line);
            assert_eq!(edges.len(), line.segment_count() + 1, "{name}");
            segments.extend(edges.windows(2).map(|w| [w[0].min(w[1]), w[0].max(w[1])]));
            line.crossings
                .iter()
                .for_each(|c| *crossings.entry(edge_of(mesh, c.half_edge)).or_default() += 1);
            goes_on_across_pairs(line, &edges, &counts, name);
            runs_through_faces(mesh, line, name);
            is_at_the_level(mesh, line, values, name);
        }
        segments.sort_unstable();
        assert_eq!(segments, slow_segments(faces, values, level), "{name}, level {level}");
        for (edge, &count) in &counts {
            let is_crossed = (values[edge[0] as usize] >= level) != (values[edge[1] as usize] >= level);
            let expected = if !is_crossed {
                0
            } else if count <= 2 {
                1
            } else {
                count
            };
            assert_eq!(crossings.get(edge).copied().unwrap_or(0), expected, "{name}, {edge:?}");
        }
    }
    assert_eq!(total, found.crossing_count(), "{name}");
}

/// Lines end exactly where an edge has not two faces.
fn goes_on_across_pairs<H>(line: &Line<'_, H>, edges: &[Edge], counts: &BTreeMap<Edge, usize>, name: &str) {
    let last = edges.len() - 1;
    for (i, edge) in edges.iter().enumerate() {
        let is_end = !line.is_closed && (i == 0 || i == last);
        assert_eq!(counts[edge] != 2, is_end, "{name}, {edges:?}");
    }
}

/// The half-edge of a crossing is a side of the face of the segment that begins there; that of the last one of
/// the face before.
fn runs_through_faces<M: Topology>(mesh: &M, line: &Line<'_, M::HalfEdge>, name: &str) {
    let after = line.crossings.iter().cycle().skip(1);
    for (crossing, next) in line.crossings.iter().zip(after).take(line.segment_count()) {
        let sides = mesh.face_half_edges(mesh.face(crossing.half_edge)).map(|h| edge_of(mesh, h));
        assert!(sides.contains(&edge_of(mesh, next.half_edge)), "{name}");
    }
    if let [.., before, last] = line.crossings
        && !line.is_closed
    {
        assert_eq!(mesh.face(before.half_edge), mesh.face(last.half_edge), "{name}");
    }
}

fn is_at_the_level<M: Topology>(mesh: &M, line: &Line<'_, M::HalfEdge>, values: &[f32], name: &str) {
    for crossing in line.crossings {
        let [from, to] = [mesh.origin(crossing.half_edge), mesh.target(crossing.half_edge)];
        let [from, to] = [from, to].map(|v| f64::from(values[v.index()]));
        assert!((0.0..=1.0).contains(&crossing.t), "{name}");
        let at = (1.0 - crossing.t) * from + crossing.t * to;
        assert!((at - f64::from(line.level)).abs() <= 1e-12 * from.abs().max(to.abs()), "{name}");
    }
}

/// What is above is on the left: lines come into faces over sides that run down.
fn above_is_left<M: Adjacency>(mesh: &M, found: &Contours<M::HalfEdge>, values: &[f32], name: &str) {
    for line in found.lines() {
        for crossing in &line.crossings[..line.segment_count()] {
            let ends = [mesh.origin(crossing.half_edge), mesh.target(crossing.half_edge)];
            let [from, to] = ends.map(|v| values[v.index()]);
            assert!(from >= line.level && to < line.level, "{name}");
        }
    }
}

fn adjacency<M: Adjacency + FromFaces>() {
    let mut random = shapes::Random(7);
    for (sample, mesh) in samples::held::<M>() {
        for range in [2, 5, 1000] {
            let values: Vec<f32> = (0..sample.vertex_count).map(|_| random.below(range) as f32).collect();
            let levels = [-1.0, 0.0, 0.5, 1.0, 3.0, 3.5, 4.0, 600.25, 999.0, 1000.0];
            check(&mesh, &sample.faces, &values, &levels, &sample.name);
            if sample.is_clean {
                let found = contours::contours(&mesh, &Map::from(values.clone()), &levels).unwrap();
                above_is_left(&mesh, &found, &values, &sample.name);
            }
        }
    }
    circles::<M>();
}

macro_rules! test_of {
    (adjacency $name:ident $mesh:ty) => {
        #[test]
        fn $name() {
            adjacency::<$mesh>();
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

/// A fan of `sectors` around an apex and rings of quads around that: (x, y) at whole radii.
fn disc(sectors: u32, rings: u32) -> (Vec<[f64; 2]>, Vec<[u32; 3]>) {
    let at = |ring: u32, sector: u32| {
        let angle = std::f64::consts::TAU * f64::from(sector) / f64::from(sectors);
        [f64::from(ring) * angle.cos(), f64::from(ring) * angle.sin()]
    };
    let rim = (1..=rings).flat_map(|ring| (0..sectors).map(move |sector| at(ring, sector)));
    let v = |ring: u32, sector: u32| 1 + (ring - 1) * sectors + sector % sectors;
    let apex = (0..sectors).map(|s| [0, v(1, s), v(1, s + 1)]);
    let quad = |r, s| [[v(r, s), v(r + 1, s), v(r + 1, s + 1)], [v(r, s), v(r + 1, s + 1), v(r, s + 1)]];
    let quads = (1..rings).flat_map(|r| (0..sectors).flat_map(move |s| quad(r, s)));
    (std::iter::once([0.0; 2]).chain(rim).collect(), apex.chain(quads).collect())
}

/// Around a cone, the lines are regular polygons; the length of all is known, and so is their turn.
fn circles<M: Adjacency + FromFaces>() {
    let (sectors, rings) = (48, 8);
    let (plane, faces) = disc(sectors, rings);
    let radius = |p: &[f64; 2]| p[0].hypot(p[1]).round();
    let height: Map<_, f32> = plane.iter().map(|p| -radius(p) as f32).collect();
    let positions: Map<_, [f32; 3]> =
        plane.iter().map(|p| [p[0], p[1], -radius(p)].map(|x| x as f32)).collect();
    let mesh = M::from_faces(plane.len(), &faces).unwrap();
    let levels = [-7.5, -3.0, -0.25];
    let found = contours::contours(&mesh, &height, &levels).unwrap();
    assert_eq!(
        found.lines().map(|line| (line.level, line.is_closed)).collect::<Vec<_>>(),
        levels.map(|l| (l, true))
    );
    for line in found.lines() {
        let angle = std::f64::consts::PI / f64::from(sectors);
        let radius = -f64::from(line.level);
        // The diagonals of the quads cross a line between rings on the way, on the polygon itself.
        let polygon = 2.0 * f64::from(sectors) * radius * angle.sin();
        let length = line.length(&mesh, &positions);
        assert!((length - polygon).abs() < 1e-5 * polygon, "{length}, {polygon}");
        let points: Vec<_> = line.crossings.iter().map(|c| c.point(&mesh, &positions)).collect();
        let turn = points.iter().zip(points.iter().cycle().skip(1)).map(|(p, q)| p[0] * q[1] - p[1] * q[0]);
        let area = 0.5 * turn.sum::<f64>();
        let expected = 0.5 * f64::from(sectors) * radius * radius * (2.0 * angle).sin();
        assert!((area - expected).abs() < 1e-5 * expected, "counter-clockwise around the summit: {area}");
    }
}

/// An octahedron, every triangle divided into four, on the sphere.
fn sphere(times: u32) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let mut points = vec![
        [1.0, 0.0, 0.0],
        [0.0, 1.0, 0.0],
        [0.0, 0.0, 1.0],
        [-1.0, 0.0, 0.0],
        [0.0, -1.0, 0.0],
        [0.0, 0.0, -1.0],
    ];
    let mut faces =
        vec![[0, 1, 2], [1, 3, 2], [3, 4, 2], [4, 0, 2], [1, 0, 5], [3, 1, 5], [4, 3, 5], [0, 4, 5]];
    for _ in 0..times {
        let mut middles = BTreeMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry(edge(a, b)).or_insert_with(|| {
                let [p, q] = [a, b].map(|v| points[v as usize]);
                let sum = [0, 1, 2].map(|i| p[i] + q[i]);
                points.push(sum.map(|x: f64| x / sum.iter().map(|x| x * x).sum::<f64>().sqrt()));
                points.len() as u32 - 1
            })
        };
        faces = faces
            .iter()
            .flat_map(|&[a, b, c]| {
                let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
                [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
            })
            .collect();
    }
    (points, faces)
}

#[test]
fn parallels_of_a_sphere() {
    let (points, faces) = sphere(5);
    let mesh = CheL1::from_faces(points.len(), &faces).unwrap();
    let positions: Map<_, [f32; 3]> = points.iter().map(|p| p.map(|x| x as f32)).collect();
    let height: Map<_, f32> = points.iter().map(|p| p[2] as f32).collect();
    let levels = contours::levels(0.1, -0.95, 0.95);
    assert_eq!(levels.len(), 19);
    let found = contours::contours(&mesh, &height, &levels).unwrap();
    assert_eq!(
        found.lines().len(),
        19,
        "one line each, that of the equator too, which runs through vertices"
    );
    for line in found.lines() {
        let circle = std::f64::consts::TAU * (1.0 - f64::from(line.level).powi(2)).sqrt();
        let length = line.length(&mesh, &positions);
        assert!(line.is_closed && (length / circle - 1.0).abs() < 2e-3, "{} {length} {circle}", line.level);
    }
}

#[test]
fn moebius_strips_have_closed_lines() {
    let (n, m) = (12, 4);
    let (vertex_count, faces) = shapes::grid(n, m, [true, false], true);
    let mesh = DirectedEdgesSmall::from_faces(vertex_count, &faces).unwrap();
    // The distance from the core, which is the same from both sides of the seam.
    let values: Map<_, f32> =
        (0..vertex_count as u32).map(|v| (v % (m + 1)).abs_diff(m / 2) as f32).collect();
    let found = contours::contours(&mesh, &values, &[0.5]).unwrap();
    let lines: Vec<_> = found.lines().map(|line| (line.is_closed, line.crossings.len())).collect();
    assert_eq!(lines, [(true, 4 * n as usize)], "around both sides of the core, in two turns");
}

#[test]
fn plateaus_have_their_lower_edge() {
    // A square of value 1 in the middle of a field of 0, in whole numbers of cells.
    let (vertex_count, faces) = shapes::grid(6, 6, [false, false], false);
    let is_in = |v: usize| (2..=4).contains(&(v / 7)) && (2..=4).contains(&(v % 7));
    let values: Map<_, f32> = (0..vertex_count).map(|v| f32::from(is_in(v))).collect();
    let positions: Map<_, _> = (0..vertex_count).map(|v| [(v / 7) as f32, (v % 7) as f32, 0.0]).collect();
    let mesh = CheL2::from_faces(vertex_count, &faces).unwrap();
    let found = contours::contours(&mesh, &values, &[1.0, 0.0]).unwrap();
    let lines: Vec<_> = found.lines().map(|l| (l.level, l.is_closed, l.length(&mesh, &positions))).collect();
    assert_eq!(lines, [(1.0, true, 8.0)], "nothing is lower than the lower plateau");
}

#[test]
fn levels_in_any_order() {
    let (vertex_count, faces) = shapes::grid(5, 5, [false, false], false);
    let mesh = CheL1::from_faces(vertex_count, &faces).unwrap();
    let values: Map<_, f32> = (0..vertex_count).map(|v| (v % 7) as f32 - 3.0).collect();
    let sorted = contours::contours(&mesh, &values, &[-0.5, 0.0, 2.0]).unwrap();
    let mixed = [2.0, f32::NAN, 0.0, -0.0, f32::INFINITY, -0.5, 2.0, f32::NEG_INFINITY];
    assert_eq!(contours::contours(&mesh, &values, &mixed).unwrap().lines().len(), sorted.lines().len());
    assert_eq!(contours::contours(&mesh, &values, &[]).unwrap().lines().len(), 0);
}

#[test]
fn equidistant_levels() {
    assert_eq!(contours::levels(2.0, -4.0, 3.0), [-4.0, -2.0, 0.0, 2.0]);
    assert_eq!(contours::levels(2.0, 0.5, 1.5), [0.0; 0]);
    assert_eq!(contours::levels(1.0, 2.0, -2.0), [0.0; 0]);
    for step in [0.0, -1.0, f32::NAN, f32::INFINITY, f32::MIN_POSITIVE] {
        assert_eq!(contours::levels(step, 0.0, 1.0), [0.0; 0], "{step}");
    }
    assert_eq!(contours::levels(1.0, f32::NEG_INFINITY, 0.0), [0.0; 0]);
    let close = contours::levels(1.0, 33_554_432.0, 33_554_440.0);
    assert!(close.is_sorted_by(|a, b| a < b), "multiples that are the same number are one level: {close:?}");
}

#[test]
fn values_are_finite_or_named() {
    let mesh = CheL1::from_faces(4, &[[0, 1, 2], [2, 1, 3]]).unwrap();
    let error = contours::contours(&mesh, &Map::from(vec![0.0, 1.0, f32::NAN, 2.0]), &[0.5]).unwrap_err();
    assert_eq!(error.vertex, 2);
}

#[test]
fn real_meshes() {
    for real in real::MESHES.iter() {
        let faces = &real.mesh.faces;
        let Ok(mesh) = DirectedEdgesSmall::from_faces(real.mesh.positions.len(), faces) else { continue };
        let height: Map<_, f32> = real.mesh.positions.iter().map(|p| p[2]).collect();
        let range = height.as_slice().iter().fold([f32::MAX, f32::MIN], |[a, b], &z| [a.min(z), b.max(z)]);
        let levels: Vec<f32> =
            (0..9u8).map(|k| range[0] + (range[1] - range[0]) * f32::from(k) / 8.0).collect();
        let found = contours::contours(&mesh, &height, &levels).unwrap();
        let segments: usize = found.lines().map(|line| line.segment_count()).sum();
        let mut distinct = levels.clone();
        distinct.dedup();
        let slow = distinct.iter().map(|&level| slow_segments(faces, height.as_slice(), level).len());
        assert_eq!(segments, slow.sum::<usize>(), "{}", real.name);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn any_faces_and_values(
        faces in prop::collection::vec([0..9u32, 0..9u32, 0..9u32], 0..40),
        values in prop::collection::vec(prop_oneof![-3..3i8, Just(0)].prop_map(f32::from), 9),
    ) {
        let faces: Vec<_> = faces.into_iter().filter(|[a, b, c]| a != b && b != c && c != a).collect();
        let mesh = DirectedEdgesSmall::from_faces(9, &faces).unwrap();
        check(&mesh, &faces, &values, &[-2.5, -1.0, 0.0, 0.75, 2.0], "made at random");
    }
}

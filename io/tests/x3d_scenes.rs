//! The same scenes as XML and in the classic encoding: both give the same mesh.

use onering_io::{Error, Format, Note, Place, Reason, Skipped, Triangles, read_as};
use proptest::prelude::*;

const POINTS: &str = "0 0 0, 1 0 0, 1 1 0, 0 1 0, 2 2 2";

/// A geometry node, in terms of neither encoding.
#[derive(Clone, Debug)]
struct Shape {
    kind: &'static str,
    index: String,
    points: Points,
}

#[derive(Clone, Debug)]
enum Points {
    Here { name: Option<String>, numbers: String },
    Used(String),
}

impl Shape {
    fn new(kind: &'static str, index: &str) -> Self {
        Self::with_points(kind, index, POINTS)
    }

    fn with_points(kind: &'static str, index: &str, numbers: &str) -> Self {
        Self { kind, index: index.into(), points: Points::Here { name: None, numbers: numbers.into() } }
    }

    fn field(&self) -> &'static str {
        if self.kind == "IndexedFaceSet" { "coordIndex" } else { "index" }
    }

    fn xml(&self) -> String {
        let (kind, field, index) = (self.kind, self.field(), &self.index);
        let coordinates = match &self.points {
            Points::Here { name: None, numbers } => format!("<Coordinate point='{numbers}'/>"),
            Points::Here { name: Some(name), numbers } => {
                format!("<Coordinate DEF=\"{name}\" point=\"{numbers}\"></Coordinate>")
            }
            Points::Used(name) => format!("<Coordinate USE='{name}'/>"),
        };
        format!("<Shape><{kind} {field}='{index}'>{coordinates}</{kind}></Shape>\n")
    }

    fn classic(&self) -> String {
        let (kind, field, index) = (self.kind, self.field(), &self.index);
        let coordinates = match &self.points {
            Points::Here { name: None, numbers } => format!("Coordinate {{ point [{numbers}] }}"),
            Points::Here { name: Some(name), numbers } => {
                format!("DEF {name} Coordinate{{point[{numbers}]}}")
            }
            Points::Used(name) => format!("USE {name}"),
        };
        format!("Shape {{ geometry {kind} {{ {field} [{index}] coord {coordinates} }} }}\n")
    }
}

fn xml(shapes: &[Shape]) -> String {
    let shapes: String = shapes.iter().map(Shape::xml).collect();
    format!("<?xml version='1.0'?>\n<X3D><Scene>\n{shapes}</Scene></X3D>\n")
}

fn classic(shapes: &[Shape]) -> String {
    let shapes: String = shapes.iter().map(Shape::classic).collect();
    format!("#VRML V2.0 utf8\n\n{shapes}")
}

/// The mesh that both encodings give. Their lines are the same too.
fn both(shapes: &[Shape]) -> Triangles {
    let [xml, classic] = results(shapes).map(|mesh| mesh.unwrap_or_else(|error| panic!("{error}")));
    assert_eq!(xml, classic);
    xml
}

fn results(shapes: &[Shape]) -> [Result<Triangles, Error>; 2] {
    let x3d = read_as(xml(shapes).as_bytes(), Format::X3d);
    [x3d, read_as(classic(shapes).as_bytes(), Format::Vrml)]
}

/// The line and the reason for which both encodings refuse a shape.
fn refusal(shape: Shape) -> (Place, Reason) {
    let [xml, classic] = results(&[shape]).map(|result| match result {
        Err(Error::Malformed { place, reason, .. }) => (place, reason),
        other => panic!("{other:?}"),
    });
    assert_eq!(xml, classic);
    xml
}

fn faces(kind: &'static str, index: &str) -> Vec<[u32; 3]> {
    both(&[Shape::new(kind, index)]).faces
}

#[test]
fn each_kind_of_geometry_makes_its_faces() {
    assert_eq!(faces("IndexedFaceSet", "0 1 2 3 -1 4 3 2 -1"), [[0, 1, 2], [0, 2, 3], [4, 3, 2]]);
    assert_eq!(faces("IndexedTriangleSet", "0 1 2 4 3 2"), [[0, 1, 2], [4, 3, 2]]);
    assert_eq!(faces("TriangleSet", ""), [[0, 1, 2]]);
    let strips = [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 2]];
    assert_eq!(faces("IndexedTriangleStripSet", "0 1 2 3 4 -1 4 3 2 -1"), strips);
    assert_eq!(faces("IndexedTriangleFanSet", "0 1 2 3 -1 4 3 2"), [[0, 1, 2], [0, 2, 3], [4, 3, 2]]);
}

#[test]
fn polygons_are_counted() {
    let mesh = both(&[Shape::new("IndexedFaceSet", "0 1 2 3 4 -1 0 1 2 -1 0 1 2 3 -1")]);
    assert_eq!(mesh.polygon_sizes, [(3, 1), (4, 1), (5, 1)].into());
    assert!(mesh.polygons().eq([0..3, 3..4, 4..6]));
    let mesh = both(&[Shape::new("IndexedTriangleStripSet", "0 1 2 3 4")]);
    assert_eq!((mesh.polygon_sizes, mesh.polygon_starts), ([(3, 3)].into(), None));
}

#[test]
fn lists_may_have_commas_and_no_end() {
    for index in
        ["0,1,2,-1,0,2,3", "0, 1 2 ,-1 0 2 3,,-1,", "+0\t1\n2 -1\r\n0 02 3 -7 -1 -1", "-1 0 1 2 -1 0 2 3"]
    {
        assert_eq!(faces("IndexedFaceSet", index), [[0, 1, 2], [0, 2, 3]], "{index}");
    }
}

#[test]
fn numbers_are_decimal() {
    let shape = Shape::with_points("TriangleSet", "", "1 -2.5 .5, 1e3 -1E-2 +4. inf -inf 0");
    let expected = [[1.0, -2.5, 0.5], [1000.0, -0.01, 4.0], [f32::INFINITY, f32::NEG_INFINITY, 0.0]];
    assert_eq!(both(&[shape]).positions, expected);
    for word in ["0x1", "1..2", "1-2", "one", ";", "1.f"] {
        let shape = Shape::with_points("TriangleSet", "", &format!("0 0 0\n0 0 {word}"));
        assert_eq!(refusal(shape), (Place::Line(4), Reason::BadNumber { word: word.into() }));
    }
    for word in ["0x1", "1.0", "1e0", "b", "--1", "-"] {
        let shape = Shape::new("IndexedFaceSet", &format!("0 1 2 -1\n0 1\n{word}"));
        assert_eq!(refusal(shape).1, Reason::BadIndex { word: word.into() });
    }
}

#[test]
fn corners_have_to_be_there() {
    for (kind, index, bad) in [
        ("IndexedFaceSet", "0 1 5", "5"),
        ("IndexedFaceSet", "9 -1 0 1 2", "9"),
        ("IndexedTriangleSet", "0 1 -1", "-1"),
        ("IndexedTriangleSet", "0 1 4294967296", "4294967296"),
        ("IndexedTriangleStripSet", "0 1 2 99999999999999999999999", "99999999999999999999999"),
        ("IndexedTriangleFanSet", "0 1 2 18446744073709551616", "18446744073709551616"),
    ] {
        let expected = Reason::IndexOutOfRange { index: bad.into(), vertices: 5 };
        assert_eq!(refusal(Shape::new(kind, index)), (Place::Line(3), expected), "{index}");
    }
}

#[test]
fn points_have_three_coordinates() {
    for (points, found) in [("0 0 0 0", 1), ("0 0 0 1 2", 2), ("5", 1)] {
        let shape = Shape::with_points("TriangleSet", "", points);
        assert_eq!(refusal(shape), (Place::Line(3), Reason::TooFewCoordinates { found }));
    }
}

#[test]
fn what_makes_no_face_is_noted() {
    let note = |kind, index: &str| {
        let notes = both(&[Shape::new("TriangleSet", "0"), Shape::new(kind, index)]).notes;
        notes.into_iter().map(|Note { what, count, first, .. }| (what, count, first)).collect::<Vec<_>>()
    };
    // Five points are a triangle and two loose points.
    let loose = |count| vec![(Skipped::LooseCorners, count, Place::Line(3))];
    let short = (Skipped::ShortFaces, 2, Place::Line(4));
    assert_eq!(note("IndexedFaceSet", "0 1 -1 2 -1 -1 0 1 2 -1"), [loose(2), vec![short]].concat());
    assert_eq!(note("IndexedTriangleSet", "0 1 2 3"), loose(3));
    assert_eq!(note("IndexedTriangleStripSet", "0 1 -1 0 1 2 -1 4"), loose(5));
    assert_eq!(note("IndexedTriangleFanSet", "0 1 -1 -1 0"), loose(5));
    assert_eq!(note("TriangleSet", ""), loose(4));
}

#[test]
fn points_are_appended_for_each_geometry_that_names_them() {
    let name = Some("points".to_owned());
    let first = Shape {
        points: Points::Here { name, numbers: POINTS.into() },
        ..Shape::new("IndexedFaceSet", "0 1 2")
    };
    let second = Shape { points: Points::Used("points".into()), ..Shape::new("IndexedTriangleSet", "2 3 4") };
    let mesh = both(&[first, Shape::new("IndexedFaceSet", "4 3 2"), second]);
    assert_eq!(mesh.positions.len(), 15);
    assert_eq!(mesh.positions[..5], mesh.positions[10..]);
    assert_eq!(mesh.faces, [[0, 1, 2], [9, 8, 7], [12, 13, 14]]);
}

#[test]
fn unknown_names_are_told() {
    let shape = Shape { points: Points::Used("nowhere".into()), ..Shape::new("IndexedFaceSet", "") };
    assert_eq!(refusal(shape), (Place::Line(3), Reason::UnknownName { name: "nowhere".into() }));
}

#[test]
fn a_mesh_far_larger_than_its_file_is_refused() {
    let numbers = "0 0 0 ".repeat(20_000);
    let first = Shape {
        points: Points::Here { name: Some("p".into()), numbers },
        ..Shape::new("IndexedTriangleSet", "")
    };
    let again = Shape { points: Points::Used("p".into()), ..first.clone() };
    let scene = |uses: usize| [vec![first.clone()], vec![again.clone(); uses]].concat();
    assert_eq!(both(&scene(20)).positions.len(), 21 * 20_000);
    for result in results(&scene(1_000)) {
        let Err(Error::Malformed { reason, .. }) = result else { panic!("{:?}", result.map(|_| ())) };
        assert!(matches!(reason, Reason::OutOfProportion { .. }), "{reason}");
    }
}

fn any_shape() -> impl Strategy<Value = Shape> {
    let kinds = [
        "IndexedFaceSet",
        "IndexedTriangleSet",
        "TriangleSet",
        "IndexedTriangleStripSet",
        "IndexedTriangleFanSet",
    ];
    let number =
        prop_oneof![any::<f32>().prop_filter("finite", |x| x.is_finite()), (-9i8..9).prop_map(f32::from)];
    let blank = prop::sample::select(vec![" ", ", ", "\n", "\t,"]);
    (
        prop::sample::select(kinds.to_vec()),
        prop::collection::vec([number.clone(), number.clone(), number], 1..7),
        prop::collection::vec(prop::option::weighted(0.8, any::<prop::sample::Index>()), 0..20),
        (blank.clone(), blank, any::<bool>()),
    )
        .prop_map(|(kind, points, corners, (blank, other, is_named))| {
            let count = points.len();
            let index = corners.iter().filter_map(|corner| match corner {
                Some(corner) => Some(format!("{}{blank}", corner.index(count))),
                None => (kind != "IndexedTriangleSet").then(|| format!("-1{other}")),
            });
            let numbers = points.as_flattened().iter().map(|x| format!("{x:e}{other}")).collect();
            let name = is_named.then(|| "name".to_owned());
            Shape { kind, index: index.collect(), points: Points::Here { name, numbers } }
        })
}

/// What the list of corners stands for, by the book: faces of any size, then fans.
fn expected_faces(shape: &Shape, count: usize) -> Vec<[u32; 3]> {
    let numbers: Vec<i64> = shape
        .index
        .split([' ', ',', '\n', '\t'])
        .filter(|word| !word.is_empty())
        .map(|word| word.parse().unwrap())
        .collect();
    let runs: Vec<Vec<u32>> =
        numbers.split(|i| *i < 0).map(|run| run.iter().map(|i| *i as u32).collect()).collect();
    let fan = |run: &Vec<u32>| (2..run.len()).map(|i| [run[0], run[i - 1], run[i]]).collect::<Vec<_>>();
    match shape.kind {
        "TriangleSet" => (0..count as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect(),
        "IndexedTriangleSet" => runs[0].chunks_exact(3).map(|c| [c[0], c[1], c[2]]).collect(),
        "IndexedTriangleStripSet" => {
            let turn =
                |(i, c): (usize, &[u32])| if i % 2 == 0 { [c[0], c[1], c[2]] } else { [c[1], c[0], c[2]] };
            runs.iter().flat_map(|run| run.windows(3).enumerate().map(turn)).collect()
        }
        _ => runs.iter().flat_map(fan).collect(),
    }
}

proptest! {
    #[test]
    fn random_scenes_read_alike(shapes in prop::collection::vec(any_shape(), 0..5)) {
        let mesh = both(&shapes);
        let (mut positions, mut faces) = (Vec::<f32>::new(), Vec::new());
        for shape in &shapes {
            let Points::Here { numbers, .. } = &shape.points else { continue };
            let base = positions.len() / 3;
            let words = numbers.split([' ', ',', '\n', '\t']).filter(|word| !word.is_empty());
            positions.extend(words.map(|word| word.parse::<f32>().unwrap()));
            let own = expected_faces(shape, positions.len() / 3 - base);
            faces.extend(own.into_iter().map(|face| face.map(|corner| corner + base as u32)));
        }
        prop_assert_eq!(mesh.positions.as_flattened(), &positions[..]);
        prop_assert_eq!(mesh.faces, faces);
    }
}

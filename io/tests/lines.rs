//! Polylines and points as OBJ and PLY: what is read back is what was written.

use onering_io::{Error, Format, Lines, Skipped, read};
use ply_rs_bw::parser::Parser;
use ply_rs_bw::ply::{DefaultElement, Property};
use std::fs;
use std::path::PathBuf;

/// Numbers that lose something on every detour.
const P: [[f32; 3]; 6] = [
    [0.1, -0.0, f32::MIN_POSITIVE],
    [1.0e-45, 3.4e38, 16777217.0],
    [0.3, 0.2, 0.1],
    [5.0, 6.0, 7.0],
    [-1.0, 1.0 / 3.0, 2.0],
    [f32::NAN, f32::INFINITY, 0.0],
];

/// An open line, a closed one, and a point.
fn sample() -> Lines {
    let mut lines = Lines::new("level");
    lines.push(P[..2].iter().copied(), false, -1.5).unwrap();
    lines.push([], true, 9.0).unwrap();
    lines.push(P[2..5].iter().copied(), true, 2.5).unwrap();
    lines.push([P[5]], false, 0.1).unwrap();
    lines
}

fn bytes_of(lines: &Lines, format: Format) -> Vec<u8> {
    let mut bytes = Vec::new();
    lines.write(&mut bytes, format).unwrap();
    bytes
}

fn bits(positions: &[[f32; 3]]) -> Vec<[u32; 3]> {
    positions.iter().map(|p| p.map(f32::to_bits)).collect()
}

#[test]
fn a_line_without_points_is_none() {
    let lines = sample();
    assert_eq!((lines.len(), lines.is_empty(), Lines::new("x").is_empty()), (3, false, true));
    let found: Vec<_> = lines.iter().map(|line| (line.start, line.points.len(), line.is_closed)).collect();
    assert_eq!(found, [(0, 2, false), (2, 3, true), (5, 1, false)]);
    assert!(lines.iter().map(|line| line.value).eq([-1.5, 2.5, 0.1]));
}

#[test]
fn obj_repeats_the_first_point_of_a_closed_line() {
    let bytes = bytes_of(&sample(), Format::Obj);
    let text = String::from_utf8(bytes.clone()).unwrap();
    let elements: Vec<_> = text.lines().filter(|line| !line.starts_with("v ")).collect();
    assert_eq!(elements, ["l 1 2", "l 3 4 5 3", "p 6"]);
    let mesh = read(&bytes).unwrap();
    assert_eq!(bits(&mesh.positions), bits(&P));
    let what: Vec<_> = mesh.notes.iter().map(|note| (note.what.clone(), note.count)).collect();
    let element = |keyword: &'static str| Skipped::Elements(keyword.into());
    assert_eq!(what, [(element("l"), 2), (element("p"), 1)]);
}

#[test]
fn ply_has_edges_values_and_colours() {
    let bytes = bytes_of(&sample(), Format::Ply);
    assert_eq!(bits(&read(&bytes).unwrap().positions), bits(&P));
    let ply = Parser::<DefaultElement>::new().read_ply(&mut &bytes[..]).unwrap();
    let edges: Vec<_> = ply.payload["edge"]
        .iter()
        .map(|edge| match (&edge["vertex1"], &edge["vertex2"]) {
            (Property::Int(a), Property::Int(b)) => [*a, *b],
            other => panic!("{other:?}"),
        })
        .collect();
    assert_eq!(edges, [[0, 1], [2, 3], [3, 4], [4, 2]]);
    let levels = ply.payload["vertex"].iter().map(|vertex| vertex["level"].clone());
    assert!(levels.eq([-1.5, -1.5, 2.5, 2.5, 2.5, 0.1].map(Property::Float)));
    let reds: Vec<_> = ply.payload["vertex"].iter().map(|vertex| vertex["red"].clone()).collect();
    // Both ends of viridis, and a place between.
    assert_eq!([&reds[0], &reds[2]], [&Property::UChar(68), &Property::UChar(253)]);
    assert!(reds[0] == reds[1] && reds[5] != reds[0] && reds[5] != reds[2]);
}

#[test]
fn the_value_keeps_its_name_unless_that_is_taken() {
    for (name, property) in
        [("level", "level"), ("x", "x_2"), ("two words\nend_header", "two_words_end_header")]
    {
        let text = bytes_of(&Lines::new(name), Format::Ply);
        let text = String::from_utf8(text).unwrap();
        assert!(text.contains(&format!("property float {property}\nelement edge 0\n")), "{text}");
        assert!(text.ends_with("\nend_header\n") && text.matches("end_header").count() <= 2, "{text}");
    }
}

#[test]
fn what_is_closed_has_an_edge_back_and_a_point_has_none() {
    for (count, edges) in [(1, 0), (2, 2), (3, 3)] {
        let mut lines = Lines::new("level");
        lines.push(P[..count].iter().copied(), true, 0.0).unwrap();
        let text = String::from_utf8_lossy(&bytes_of(&lines, Format::Ply)).into_owned();
        assert!(text.contains(&format!("element edge {edges}\n")), "{text}");
    }
}

fn fresh(name: &str) -> PathBuf {
    let path = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("lines").join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    let _ = fs::remove_file(&path);
    path
}

#[test]
fn files_appear_whole_or_not_at_all() {
    let lines = sample();
    for name in ["a.obj", "a.ply", "a.PLY.gz"] {
        let path = fresh(name);
        lines.save(&path).unwrap();
        assert_eq!(bits(&onering_io::load(&path).unwrap().positions), bits(&P), "{name}");
    }
    for format in Format::all().filter(|format| ![Format::Obj, Format::Ply].contains(format)) {
        let path = fresh(&format!("old.{}", format.extensions()[0]));
        fs::write(&path, "old").unwrap();
        let error = lines.save(&path).unwrap_err();
        assert!(matches!(error, Error::NoLines { .. }), "{error}");
        let text =
            format!("{}: lines and points are written as .obj and .ply, not as {format}", path.display());
        assert_eq!(error.to_string(), text);
        assert_eq!(fs::read(&path).unwrap(), b"old");
    }
    assert!(matches!(lines.save("lines").unwrap_err(), Error::UnknownFormat { .. }));
    assert!(matches!(lines.save("no such folder/a.obj").unwrap_err(), Error::Write { path: Some(_), .. }));
}

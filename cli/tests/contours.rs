//! `onering contours`: figures, lines and maps.

mod common;

use common::{Run, fresh, onering, onering_with_input};
use onering_io::load;
use serde_json::Value;
use std::fs;
use std::path::Path;
use svg::parser::Event;

/// A pyramid of height 1 over a square with sides of 2.
const PYRAMID: &str = "v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nv 0 0 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

fn contours(file: &Path, more: &[&str]) -> Run {
    onering(["contours", file.to_str().unwrap()].into_iter().chain(more.iter().copied()))
}

fn json(run: &Run) -> Value {
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    run.json_lines().remove(0)
}

/// The start tags of an SVG file, which has to be well-formed: each with its name and its class.
fn tags(path: &Path) -> Vec<(String, String)> {
    let mut content = String::new();
    let mut open = Vec::new();
    let mut tags = Vec::new();
    for event in svg::open(path, &mut content).unwrap() {
        match event {
            Event::Error(error) => panic!("{error}"),
            Event::Tag(name, kind, attributes) => {
                if kind == svg::node::element::tag::Type::End {
                    assert_eq!(open.pop().as_deref(), Some(name));
                    continue;
                }
                let class = attributes.get("class").map_or(String::new(), |class| class.to_string());
                tags.push((name.to_string(), class));
                if kind == svg::node::element::tag::Type::Start {
                    open.push(name.to_string());
                }
            }
            _ => {}
        }
    }
    assert!(open.is_empty() && tags[0].0 == "svg", "{open:?}");
    tags
}

/// How many levels have a path on the map.
fn levels_on_map(path: &Path) -> usize {
    tags(path).iter().filter(|(name, class)| name == "path" && class.starts_with('l')).count()
}

#[test]
fn a_pyramid_has_squares() {
    let file = fresh("squares", "pyramid.obj", PYRAMID);
    let found = json(&contours(&file, &["--at", "0.75,0.25,2", "--json"]));
    let rows: Vec<_> = found["levels"].as_array().unwrap().iter().collect();
    let figures = |row: &Value| {
        let count = |name: &str| row[name].as_u64().unwrap();
        (row["level"].as_f64().unwrap(), count("closed"), count("open"), row["length"].as_f64().unwrap())
    };
    let figures: Vec<_> = rows.into_iter().map(figures).collect();
    assert_eq!(figures, [(0.25, 1, 0, 6.0), (0.75, 1, 0, 2.0), (2.0, 0, 0, 0.0)]);
    assert_eq!((&found["closed"], &found["open"], &found["length"]), (&2.into(), &0.into(), &8.0.into()));
    assert_eq!(found["range"], serde_json::json!([0.0, 1.0]));
    assert_eq!((&found["up"], &found["field"], &found["unit"]), (&"z".into(), &"height".into(), &"".into()));
    assert!(found["seconds"].as_f64().unwrap() >= 0.0);
}

#[test]
fn a_level_is_a_line_of_text_and_the_time_is_on_standard_error() {
    let file = fresh("text", "pyramid.obj", PYRAMID);
    let run = contours(&file, &["--levels", "3", "--unit", "cm"]);
    assert_eq!((run.code, run.err.lines().count()), (Some(0), 1), "{run:?}");
    assert!(run.err.starts_with("traced in ") && run.err.ends_with("on directed-edges-small\n"), "{run:?}");
    let lines: Vec<Vec<&str>> = run.out.lines().map(|line| line.split_whitespace().collect()).collect();
    assert_eq!(lines.len(), 7, "{run:?}");
    assert_eq!(lines[1], ["from", "0", "to", "1", "cm,", "3", "levels"]);
    assert_eq!(lines[3], ["0.25", "1", "0", "6.000000"]);
    assert_eq!(lines[6], ["all", "3", "0", "12.000000"]);
}

#[test]
fn every_backend_draws_the_same() {
    let file = fresh("backends", "pyramid.obj", PYRAMID);
    let levels = |backend: &str| {
        json(&contours(&file, &["--levels", "7", "--minima", "--json", "--backend", backend]))["levels"]
            .take()
    };
    let expected = levels("directed-edges-small");
    assert_eq!(expected.as_array().unwrap().len(), 7);
    for backend in ["shared-vertex", "che-l1", "che-l3", "mate-face", "winged-edge", "searched"] {
        assert_eq!(levels(backend), expected, "{backend}");
    }
}

/// A closed line ends where it began, and lies at its level.
#[test]
fn lines_are_written() {
    let file = fresh("lines", "pyramid.obj", PYRAMID);
    for name in ["out.obj", "out.ply", "out.ply.gz"] {
        let out = file.with_file_name(name);
        contours(&file, &["--at", "0.5", "--lines", out.to_str().unwrap()]);
        let mut points = load(&out).unwrap().positions;
        points.sort_by(|a, b| a.partial_cmp(b).unwrap());
        assert_eq!(
            points,
            [[-0.5, -0.5, 0.5], [-0.5, 0.5, 0.5], [0.5, -0.5, 0.5], [0.5, 0.5, 0.5]],
            "{name}"
        );
    }
    let text = fs::read_to_string(file.with_file_name("out.obj")).unwrap();
    assert!(text.ends_with("\nl 1 2 3 4 1\n"), "{text}");
}

#[test]
fn a_map_has_a_path_for_each_level_that_is_met() {
    let file = fresh("map", "<pyramid> & \"co\".obj", PYRAMID);
    let out = file.with_file_name("out.svg");
    let svg = out.to_str().unwrap();
    contours(&file, &["--at", "-3,0.25,0.5,7", "--svg", svg, "--unit", "<&\">"]);
    assert_eq!(levels_on_map(&out), 2);
    contours(&file, &["--levels", "40", "--minima", "--svg", svg]);
    assert_eq!(levels_on_map(&out), 40);
    assert!(tags(&out).contains(&("path".into(), "minimum".into())));
    let text = fs::read_to_string(&out).unwrap();
    assert!(text.contains("&lt;pyramid&gt; &amp; \"co\".obj"), "names are text, not tags");
    assert!(text.contains("prefers-color-scheme:dark"));
}

#[test]
fn up_is_as_the_format_has_it_or_as_is_said() {
    let file = fresh("up", "pyramid.obj", PYRAMID);
    let glb = file.with_file_name("pyramid.glb");
    onering(["convert", file.to_str().unwrap(), glb.to_str().unwrap()]);
    let found = |file: &Path, more: &[&str]| {
        let found = json(&contours(file, &[more, &["--json"]].concat()));
        (found["up"].as_str().unwrap().to_owned(), found["range"].to_string(), found["unit"].to_string())
    };
    let expected = |up: &str, range: &str, unit: &str| (up.into(), range.into(), format!("{unit:?}"));
    assert_eq!(found(&file, &[]), expected("z", "[0.0,1.0]", ""));
    assert_eq!(found(&glb, &[]), expected("y", "[-1.0,1.0]", "m"));
    assert_eq!(found(&glb, &["--up", "z", "--unit", "ft"]), expected("z", "[0.0,1.0]", "ft"));
    assert_eq!(found(&file, &["--up", "-z"]), expected("-z", "[-1.0,-0.0]", ""));
    assert_eq!(found(&file, &["--up=-y", "--field", "z"]), expected("-y", "[0.0,1.0]", ""));
    assert_eq!(contours(&file, &["--up", "w"]).code, Some(2));
}

#[test]
fn levels_are_asked_for_in_one_way_and_are_not_too_many() {
    let file = fresh("levels", "pyramid.obj", PYRAMID);
    let count = |more: &[&str]| {
        let found = json(&contours(&file, &[more, &["--json"]].concat()));
        found["levels"].as_array().unwrap().len()
    };
    assert_eq!(count(&["--step", "0.25"]), 5);
    assert_eq!(count(&["--levels", "100000"]), 100_000);
    assert_eq!([count(&["--step", "0.05"]), count(&[])], [21; 2]);
    assert_eq!(count(&["--at", "-1,-1,5"]), 2);
    for wrong in [
        &["--levels", "0"][..],
        &["--levels", "100001"],
        &["--step", "0"],
        &["--step", "-1"],
        &["--step", "nan"],
        &["--step", "1e-9"],
        &["--at", "inf"],
        &["--at", "1", "--levels", "2"],
    ] {
        let run = contours(&file, wrong);
        assert_eq!((run.code, run.out.as_str()), (Some(2), ""), "{wrong:?}: {run:?}");
    }
}

#[test]
fn standard_input_is_read() {
    let (run, out) = onering_with_input(["contours", "-", "--at", "0.5", "--json"], PYRAMID.as_bytes());
    assert_eq!(run.code, Some(0), "{run:?}");
    let found: Value = serde_json::from_slice(&out).unwrap();
    assert_eq!((&found["file"], &found["closed"]), (&"standard input".into(), &1.into()));
}

#[test]
fn without_faces_there_are_no_lines() {
    let empty = fresh("empty", "empty.obj", "");
    let points = empty.with_file_name("points.obj");
    fs::write(&points, "v 0 0 0\nv 1 1 1\n").unwrap();
    let flat = empty.with_file_name("flat.obj");
    fs::write(&flat, common::SQUARE).unwrap();
    for file in [&empty, &points, &flat] {
        let out = file.with_extension("svg");
        let found = json(&contours(file, &["--minima", "--json", "--svg", out.to_str().unwrap()]));
        assert_eq!((&found["closed"], &found["open"]), (&0.into(), &0.into()), "{found}");
        assert_eq!(levels_on_map(&out), 0);
        let run = contours(file, &[]);
        assert_eq!((run.code, run.err.lines().count()), (Some(0), 1), "{run:?}");
    }
}

#[test]
fn extremes_are_drawn_too() {
    for (name, scale) in [("huge", "3e38"), ("tiny", "1e-40")] {
        let text = format!("v -{scale} 0 -{scale}\nv {scale} 0 0\nv 0 {scale} {scale}\nf 1 2 3\n");
        let file = fresh(name, "one.obj", &text);
        let out = file.with_extension("svg");
        let found = json(&contours(&file, &["--levels", "4", "--json", "--svg", out.to_str().unwrap()]));
        assert_eq!((&found["open"], levels_on_map(&out)), (&4.into(), 4), "{found}");
        contours(&file, &["--svg", out.to_str().unwrap()]);
    }
}

#[test]
fn what_is_not_finite_is_said_with_its_vertex() {
    for coordinate in ["nan", "inf"] {
        let file = fresh("finite", "bad.obj", &PYRAMID.replace("v 1 1 0", &format!("v {coordinate} 1 0")));
        let out = file.with_extension("svg");
        let run = contours(&file, &["--svg", out.to_str().unwrap()]);
        assert_eq!((run.code, out.exists(), run.out.as_str()), (Some(2), false, ""), "{run:?}");
        let line = format!("onering: {}: vertex 2 has a coordinate or a value", file.display());
        assert!(run.err.starts_with(&line) && run.err.lines().count() == 1, "{run:?}");
    }
}

#[test]
fn output_that_cannot_be_written_leaves_nothing() {
    let file = fresh("unwritable", "pyramid.obj", PYRAMID);
    let folder = file.parent().unwrap();
    let cases = [
        ("--svg", "none/out.svg", 1),
        ("--lines", "none/out.obj", 1),
        ("--lines", "out.stl", 2),
        ("--lines", "out", 2),
    ];
    for (option, name, code) in cases {
        let out = folder.join(name);
        let run = contours(&file, &[option, out.to_str().unwrap()]);
        assert_eq!((run.code, run.out.as_str(), run.err.lines().count()), (Some(code), "", 1), "{run:?}");
        assert!(run.err.starts_with(&format!("onering: {}: ", out.display())), "{run:?}");
        assert_eq!(fs::read_dir(folder).unwrap().count(), 1, "{run:?}");
    }
}

/// The picture in the README is the one that the command there makes.
#[test]
fn the_mesh_that_is_read_is_spared() {
    let mesh = fresh("contours", "spared", PYRAMID).with_file_name("pyramid.obj");
    fs::write(&mesh, PYRAMID).unwrap();
    let same = mesh.to_str().unwrap();
    let otherwise = mesh.parent().unwrap().join(".").join("pyramid.obj");
    for (command, option) in [
        ("contours", "--lines"),
        ("contours", "--svg"),
        ("minima", "--points"),
        ("minima", "--svg"),
        ("deform", "--png"),
    ] {
        let run = onering([command, same, option, otherwise.to_str().unwrap()]);
        assert_eq!((run.code, run.out.as_str()), (Some(2), ""), "{command} {option}: {run:?}");
        assert!(run.err.contains("it is the mesh to read"), "{command} {option}: {run:?}");
        assert_eq!(fs::read_to_string(&mesh).unwrap(), PYRAMID);
    }
}

#[test]
fn the_picture_in_the_documents_is_up_to_date() {
    let out = fresh("picture", "none", "").with_file_name("contours.svg");
    let run = onering(["contours", "--minima", "--svg", out.to_str().unwrap()]);
    assert_eq!(run.code, Some(0), "{run:?}");
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let readme = fs::read_to_string(root.join("README.md")).unwrap();
    assert!(readme.contains("onering contours --minima --svg docs/contours.svg"));
    let kept = fs::read_to_string(root.join("docs/contours.svg")).unwrap().replace('\r', "");
    assert!(kept == fs::read_to_string(&out).unwrap(), "docs/contours.svg is not what the command makes");
    assert!(kept.len() < 150_000);
}

/// Whatever is wrong with a file, it is said in a line.
#[test]
fn broken_files_end_with_a_line() {
    let Some((folder, entries)) = common::malformed() else { return };
    for entry in &entries {
        let path = folder.join(entry["file"].as_str().unwrap());
        for command in ["contours", "minima", "region"] {
            let run = common::onering_in_little_memory([command, path.to_str().unwrap()]);
            assert!(matches!(run.code, Some(0..=2)), "{run:?}");
            assert_eq!(run.err.lines().count(), 1, "{run:?}");
        }
    }
}

#[test]
fn real_terrain_has_its_lines() {
    let Some((folder, _)) = common::meshes() else { return };
    let file = folder.join("peak_district_terrain.glb");
    let out = fresh("real", "none", "").with_file_name("peak.svg");
    let more = ["--up", "z", "--levels", "50", "--minima", "--json", "--svg", out.to_str().unwrap()];
    let found = json(&contours(&file, &more));
    assert_eq!(levels_on_map(&out), 50);
    // A terrain over a square: every level is met, and minima are below their surroundings.
    assert!(found["levels"].as_array().unwrap().iter().all(|row| row["length"].as_f64().unwrap() > 0.0));
    assert!(!found["minima"].as_array().unwrap().is_empty());
}

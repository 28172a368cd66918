//! `onering minima`: what is found, in figures, as points and on a map.

mod common;

use common::{Run, fresh, onering, onering_with_input};
use onering_io::{Skipped, load};
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// A strip of triangles with these heights.
fn strip(heights: &[i32]) -> String {
    let vertex = |(i, z): (usize, &i32)| format!("v {} {} {z}\n", i / 2, i % 2);
    let face = |i: usize| if i % 2 == 1 { [i, i + 1, i + 2] } else { [i + 1, i, i + 2] };
    let face = |i: usize| format!("f {} {} {}\n", face(i)[0], face(i)[1], face(i)[2]);
    heights.iter().enumerate().map(vertex).chain((1..heights.len() - 1).map(face)).collect()
}

/// Two minima, at 1 (a plateau of 1 and 2) and 5, with a maximum at 3 between them, and one at 0.
const W: [i32; 6] = [5, 1, 1, 4, 3, 2];

fn minima(file: &Path, more: &[&str]) -> Run {
    onering(["minima", file.to_str().unwrap()].into_iter().chain(more.iter().copied()))
}

fn found(run: &Run) -> Value {
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    run.json_lines().remove(0)
}

fn vertices(found: &Value) -> Vec<u64> {
    found.as_array().unwrap().iter().map(|extremum| extremum["vertex"].as_u64().unwrap()).collect()
}

#[test]
fn minima_and_maxima_of_a_strip() {
    let file = fresh("strip", "w.obj", &strip(&W));
    let report = found(&minima(&file, &["--maxima", "--json"]));
    assert_eq!((vertices(&report["minima"]), vertices(&report["maxima"])), (vec![1, 5], vec![0, 3]));
    assert_eq!(report["minima"][1], json!({"vertex": 5, "position": [2.0, 1.0, 2.0], "value": 2.0}));
    assert_eq!((&report["vertices"], &report["triangles"]), (&6.into(), &4.into()));
    assert!(report["saddles"].is_null() && report["stalactites"].is_null());
    let upside_down = found(&minima(&file, &["--up", "-z", "--json"]));
    assert_eq!(vertices(&upside_down["minima"]), [0, 3]);
    let along_x = found(&minima(&file, &["--field", "x", "--json"]));
    assert_eq!((vertices(&along_x["minima"]), &along_x["field"]), (vec![0], &"x".into()));
}

#[test]
fn a_saddle_is_said_with_its_multiplicity() {
    let wheel = "v 0 0 0\nv 1 0 -1\nv 0 1 1\nv -1 0 -1\nv 0 -1 1\nf 1 2 3\nf 1 3 4\nf 1 4 5\nf 1 5 2\n";
    let file = fresh("saddle", "wheel.obj", wheel);
    let report = found(&minima(&file, &["--saddles", "--json"]));
    let expected = json!([{"vertex": 0, "position": [0.0, 0.0, 0.0], "value": 0.0, "multiplicity": 1}]);
    assert_eq!(report["saddles"], expected);
}

#[test]
fn text_has_a_line_for_each() {
    let file = fresh("text", "w.obj", &strip(&W));
    let run = minima(&file, &["--maxima", "--backend", "che-l2"]);
    assert_eq!(run.code, Some(0), "{run:?}");
    assert!(run.err.starts_with("found in ") && run.err.ends_with(" ms on che-l2\n"), "{run:?}");
    let lines: Vec<Vec<&str>> =
        run.out.lines().skip(1).map(|line| line.split_whitespace().collect()).collect();
    assert_eq!(lines[..2], [vec!["2", "minima"], "1 height 1 at 0 1 1".split(' ').collect()]);
    assert_eq!((&lines[3], lines.len()), (&vec!["2", "maxima"], 6));
}

#[test]
fn every_backend_finds_the_same() {
    let file = fresh("backends", "w.obj", &strip(&W));
    for backend in onering::registry::BACKENDS.iter().filter(|backend| backend.traits.contains(&"topology")) {
        let report = found(&minima(&file, &["--maxima", "--json", "--backend", backend.name]));
        assert_eq!((vertices(&report["minima"]), vertices(&report["maxima"])), (vec![1, 5], vec![0, 3]));
        assert_eq!(report["backend"], backend.name);
    }
}

#[test]
fn points_are_written() {
    let file = fresh("points", "w.obj", &strip(&W));
    for name in ["out.obj", "out.ply"] {
        let out = file.with_file_name(name);
        minima(&file, &["--maxima", "--points", out.to_str().unwrap()]);
        let points = load(&out).unwrap();
        assert_eq!(points.positions.iter().map(|p| p[2]).collect::<Vec<_>>(), [1.0, 2.0, 5.0, 4.0], "{name}");
        if name == "out.obj" {
            assert_eq!((&points.notes[0].what, points.notes[0].count), (&Skipped::Elements("p".into()), 4));
        }
    }
    let ply = fs::read(file.with_file_name("out.ply")).unwrap();
    assert!(String::from_utf8_lossy(&ply).contains("property float height\nelement edge 0\n"));
}

#[test]
fn a_map_shows_each_kind() {
    let file = fresh("map", "w.obj", &strip(&W));
    let out = file.with_file_name("out.svg");
    minima(&file, &["--maxima", "--saddles", "--svg", out.to_str().unwrap()]);
    let text = fs::read_to_string(&out).unwrap();
    assert!(text.starts_with("<svg") && text.trim_end().ends_with("</svg>"));
    assert!(text.contains("2 minima") && text.contains("2 maxima") && !text.contains("saddles"), "{text}");
}

/// Every tip of the made roof is lower than what is around it, and the largest stalactites have one.
#[test]
fn a_made_roof_has_stalactites() {
    let report = found(&onering(["minima", "--stalactites", "--json"]));
    let tips = report["stalactites"].as_array().unwrap();
    let at = |tip: &Value, i: usize| tip["position"][i].as_f64().unwrap();
    for [x, y] in [[1.0, 1.1], [2.1, 2.0], [2.9, 2.7], [3.2, 0.9]] {
        let near = |tip: &&Value| (at(tip, 0) - x).abs() < 0.11 && (at(tip, 1) - y).abs() < 0.11;
        assert!(tips.iter().any(|tip| near(&tip)), "{x} {y}: {tips:?}");
    }
    assert!(report["minima"].is_null());
    // Seen from outside it is a hill with pits, and nothing hangs.
    let above = found(&onering(["minima", "--stalactites", "--json", "--up", "-z"]));
    assert!(above["stalactites"].as_array().unwrap().is_empty(), "{above}");
}

#[test]
fn standard_input_is_read() {
    let (run, out) = onering_with_input(["minima", "-", "--json", "--from", "obj"], strip(&W).as_bytes());
    assert_eq!(run.code, Some(0), "{run:?}");
    let report: Value = serde_json::from_slice(&out).unwrap();
    assert_eq!((vertices(&report["minima"]), &report["file"]), (vec![1, 5], &"standard input".into()));
}

#[test]
fn weld_and_repair_come_first() {
    // Two triangles that share an edge only after welding.
    let text = "v 0 0 1\nv 1 0 0\nv 1 1 2\nv 1 0 0\nv 2 0 -1\nv 1 1 2\nf 1 2 3\nf 4 5 6\n";
    let file = fresh("weld", "apart.obj", text);
    let count = |more: &[&str]| found(&minima(&file, more))["minima"].as_array().unwrap().len();
    assert_eq!((count(&["--json"]), count(&["--json", "--weld"])), (2, 1));
    let three = fresh(
        "repair",
        "three.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 1\nv 0 -1 1\nv 0 0 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n",
    );
    let run = minima(&three, &["--backend", "che-l2"]);
    assert_eq!((run.code, run.err.lines().count()), (Some(1), 1), "{run:?}");
    assert!(run.err.contains("che-l2 cannot hold the mesh") && run.err.contains("--repair"), "{run:?}");
    assert_eq!(minima(&three, &["--backend", "che-l2", "--repair"]).code, Some(0));
}

#[test]
fn no_faces_no_minima() {
    let file = fresh("empty", "empty.obj", "v 0 0 0\n");
    let report = found(&minima(&file, &["--maxima", "--saddles", "--json"]));
    assert_eq!([&report["minima"], &report["maxima"], &report["saddles"]], [&json!([]); 3]);
}

#[test]
fn failures_are_a_line_and_leave_nothing() {
    let file = fresh("failures", "w.obj", &strip(&W).replace("v 2 0 3", "v 2 inf 3"));
    let run = minima(&file, &[]);
    assert_eq!((run.code, run.out.as_str(), run.err.lines().count()), (Some(2), "", 1), "{run:?}");
    assert!(
        run.err.starts_with(&format!("onering: {}: vertex 4 has a coordinate", file.display())),
        "{run:?}"
    );
    fs::write(&file, strip(&W)).unwrap();
    for (option, name) in [("--points", "none/out.ply"), ("--points", "out.glb"), ("--svg", "none/out.svg")] {
        let out = file.with_file_name(name);
        let run = minima(&file, &[option, out.to_str().unwrap()]);
        assert_eq!((run.code, run.out.as_str(), run.err.lines().count()), (Some(1), "", 1), "{run:?}");
        assert_eq!(fs::read_dir(file.parent().unwrap()).unwrap().count(), 1, "{run:?}");
    }
    assert_eq!(minima(&file, &["--stalactites", "--field", "x"]).code, Some(2));
    assert_eq!(minima(Path::new("missing.obj"), &[]).code, Some(2));
}

/// By looking at all faces: a vertex below all its neighbours is found, and none that is found has a lower one.
#[test]
fn real_minima_are_those_of_a_slow_search() {
    let Some((folder, _)) = common::meshes() else { return };
    for (name, up) in [("peak_district_terrain.glb", 2), ("cave_bones.glb", 1)] {
        let path = folder.join(name);
        let axis = ["x", "y", "z"][up];
        let report = found(&minima(&path, &["--up", axis, "--json"]));
        let claimed = vertices(&report["minima"]);
        let mesh = load(&path).unwrap();
        let height = |v: u32| mesh.positions[v as usize][up];
        let mut lowest = vec![f32::INFINITY; mesh.positions.len()];
        for face in &mesh.faces {
            for (&v, &u) in face.iter().flat_map(|v| face.iter().map(move |u| (v, u))).filter(|(v, u)| v != u)
            {
                lowest[v as usize] = lowest[v as usize].min(height(u));
            }
        }
        for v in 0..mesh.positions.len() as u32 {
            let (is_claimed, around) = (claimed.contains(&v.into()), lowest[v as usize]);
            assert!(!is_claimed || height(v) <= around, "{name}: {v}");
            assert!(is_claimed || height(v) >= around || around == f32::INFINITY, "{name}: {v}");
        }
    }
}

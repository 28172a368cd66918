//! `onering deform`: what it makes of a mesh, not how long that takes.

mod common;

use common::{Run, SQUARE, fresh, inspect, onering, onering_with_input};
use onering_io::Triangles;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

fn deform(mesh: &Path, more: &[&str]) -> Run {
    onering(["deform", mesh.to_str().unwrap()].into_iter().chain(more.iter().copied()))
}

/// Deforms, which has to succeed, and gives the JSON.
fn deformed(mesh: &Path, more: &[&str]) -> Value {
    let run = deform(mesh, &[more, &["--json"]].concat());
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    run.json_lines().remove(0)
}

/// A square of `n` times `n` cells of two triangles, in the plane z = 0.
fn sheet(n: usize) -> String {
    let side = n + 1;
    let mut text: String = (0..side * side).map(|i| format!("v {} {} 0\n", i % side, i / side)).collect();
    for i in (0..n * n).map(|i| i / n * side + i % n + 1) {
        text += &format!("f {i} {} {}\nf {i} {} {}\n", i + 1, i + side + 1, i + side + 1, i + side);
    }
    text
}

fn moved(before: &Triangles, after: &Triangles) -> Vec<[f32; 3]> {
    assert_eq!(before.faces, after.faces);
    let pairs = before.positions.iter().zip(&after.positions);
    pairs.map(|(p, q)| [q[0] - p[0], q[1] - p[1], q[2] - p[2]]).collect()
}

/// Held at its boundary, with a force on the middle: the middle of 2 x 2 cells has six springs to what is held.
#[test]
fn one_free_vertex_moves_by_the_force_over_its_springs() {
    let file = fresh("six", "sheet.obj", &sheet(2));
    let out = file.with_file_name("out.ply");
    let more =
        ["--at", "1.1,0.9,0.2", "--force", "0,0,-3", "--rings", "0", "--fix", "boundary", "--stiffness", "2"];
    let found = deformed(&file, &[&more[..], &["-o", out.to_str().unwrap()]].concat());
    assert_eq!((found["at"].as_u64(), found["held"].as_u64()), (Some(4), Some(8)));
    assert!((found["largest_displacement"].as_f64().unwrap() - 0.25).abs() < 1e-9, "{found}");
    assert!(found["residual"].as_f64().unwrap() <= 1e-8);
    assert!(found["queries_ms"].as_f64().unwrap() > 0.0 && found["total_ms"].as_f64().unwrap() > 0.0);
    let [before, after] = [&file, &out].map(|path| onering_io::load(path).unwrap());
    let mut expected = [[0.0; 3]; 9];
    expected[4] = [0.0, 0.0, -0.25];
    assert_eq!(moved(&before, &after), expected);
    let header = String::from_utf8_lossy(&fs::read(&out).unwrap()).into_owned();
    assert!(header.contains("property float displacement"));
    // The file without room for displacements says so.
    let run = deform(&file, &[&more[..], &["-o", out.with_extension("obj").to_str().unwrap()]].concat());
    assert!(run.out.contains("holds no displacements"), "{run:?}");
    assert!(inspect(&out.with_extension("obj"))["bbox_min"][2] == -0.25);
}

#[test]
fn every_backend_gives_the_same_displacements() {
    let file = fresh("backends", "sheet.obj", &sheet(12));
    let before = onering_io::load(&file).unwrap();
    let mut first: Option<Vec<[f32; 3]>> = None;
    let with_faces =
        onering::registry::BACKENDS.iter().filter(|backend| backend.traits.contains(&"topology"));
    for name in with_faces.map(|backend| backend.name).chain(["searched"]) {
        let out = file.with_file_name(format!("{name}.ply"));
        let place = ["--at", "84", "--force", "1,2,-3", "--fix", "boundary", "--tolerance", "1e-12"];
        let found =
            deformed(&file, &[&place[..], &["--backend", name, "-o", out.to_str().unwrap()]].concat());
        assert_eq!((found["backend"].as_str(), found["held"].as_u64()), (Some(name), Some(48)));
        let moved = moved(&before, &onering_io::load(&out).unwrap());
        let first = first.get_or_insert_with(|| moved.clone());
        let pairs = moved.as_flattened().iter().zip(first.as_flattened());
        // Coordinates up to 12 are rounded to 1e-6.
        assert!(pairs.clone().all(|(a, b)| (a - b).abs() < 4e-6), "{name}");
        assert!(moved[84][2] < -0.3 && moved[0] == [0.0; 3], "{:?}", moved[84]);
    }
}

#[test]
fn steps_in_time_end_near_where_the_mesh_comes_to_rest() {
    let file = fresh("steps", "sheet.obj", &sheet(6));
    let place = ["--at", "24", "--force", "0,0,-1", "--fix", "boundary"];
    let rest = deformed(&file, &place)["largest_displacement"].as_f64().unwrap();
    let after = |steps: &str| {
        let found = deformed(&file, &[&place[..], &["--steps", steps, "--damping", "1"]].concat());
        assert_eq!((found["is_in_time"].as_bool(), &found["residual"]), (Some(true), &Value::Null));
        found["largest_displacement"].as_f64().unwrap()
    };
    assert_eq!(after("0"), 0.0);
    assert!(after("1") > 0.0 && after("1") < rest / 2.0);
    assert!((after("2000") / rest - 1.0).abs() < 1e-6);
}

/// Width and height in the header of a PNG.
fn size_of_png(path: &Path) -> [u32; 2] {
    let bytes = fs::read(path).unwrap();
    assert_eq!(&bytes[..8], b"\x89PNG\r\n\x1a\n");
    [16, 20].map(|i| u32::from_be_bytes(bytes[i..i + 4].try_into().unwrap()))
}

#[test]
fn without_a_file_an_organ_gives_way_visibly() {
    let png = fresh("organ", "organ.png", "");
    let run = onering(["deform", "--width", "300", "--json", "--png", png.to_str().unwrap()]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    let found = &run.json_lines()[0];
    let largest = found["largest_displacement"].as_f64().unwrap();
    assert!((0.2..1.0).contains(&largest), "{largest}");
    let [width, height] = size_of_png(&png);
    assert!(width == 300 && (60..=190).contains(&height), "{width} x {height}");
}

#[test]
fn the_camera_is_where_it_is_asked_to_be() {
    let file = fresh("camera", "sheet.obj", &sheet(3));
    let png = file.with_file_name("sheet.png");
    let draw = |more: &[&str]| {
        let place = ["--at", "5", "--fix", "boundary", "--width", "202", "--png", png.to_str().unwrap()];
        let run = deform(&file, &[&place[..], more].concat());
        (run.code, run.err)
    };
    assert_eq!(draw(&["--view", "0,0,1"]), (Some(0), String::new()));
    assert_eq!(size_of_png(&png), [202, 100]);
    // Edge on.
    assert_eq!(draw(&["--view", "0,-1,0", "--up", "0,0,1"]).0, Some(0));
    assert_eq!(size_of_png(&png), [202, 40]);
    let (code, err) = draw(&["--view", "0,2,0"]);
    assert!(code == Some(2) && err.contains("parallel"), "{err}");
}

fn refused(mesh: &Path, more: &[&str], code: i32, message: &str) {
    let run = deform(mesh, more);
    assert_eq!((run.code, run.out.as_str()), (Some(code), ""), "{more:?}: {run:?}");
    assert!(run.err.contains(message) && run.err.trim_end().lines().count() <= 12, "{more:?}: {}", run.err);
}

#[test]
fn what_makes_no_sense_is_refused_by_name() {
    let file = fresh("refused", "square.obj", SQUARE);
    for (more, message) in [
        (&["--at", "4"][..], "there is no vertex 4: there are 4"),
        (&["--at", "-1"], "neither the number"),
        (&["--at", "1,2,nan"], "no finite number"),
        (&["--at", "1e300,0,0"], "too far away"),
        (&["--force", "0,0,inf"], "no finite number"),
        (&["--force", "0,0,0"], "--force needs a direction"),
        (&["--force", "1,2"], "three numbers"),
        (&["--stiffness", "nan"], "--stiffness NaN"),
        (&["--stiffness", "0"], "more than 0"),
        (&["--tolerance", "-1"], "--tolerance -1"),
        (&["--fix", "farthest:100"], "less than 100"),
        (&["--fix", "9"], "there is no vertex 9"),
        (&["--fix", "beyond:5"], "holds no vertex"),
        (&["--backend", "nonsense"], "nonsense"),
        (&["--steps", "3", "--tolerance", "1"], "cannot be used with"),
        (&["--view", "0,0,1"], "--png"),
        (&["--width", "5000", "--png", "x.png"], "5000"),
        (&["-o", "out.xyz"], "tells no format"),
        (&["-o", "-"], "--to"),
    ] {
        refused(&file, more, 2, message);
    }
    let nowhere = file.with_file_name("nowhere");
    refused(&nowhere.join("mesh.obj"), &[], 2, "nowhere");
    refused(&file, &["-o", nowhere.join("out.ply").to_str().unwrap()], 1, "nowhere");
    refused(&file, &["--png", nowhere.join("out.png").to_str().unwrap()], 1, "nowhere");
    refused(&file, &["--force", "0,0,1e100", "--fix", "0"], 1, "too large");
    refused(&file, &["--max-iterations", "0", "--fix", "0"], 1, "--max-iterations");
}

fn bad_mesh(name: &str, text: &str, more: &[&str], message: &str) {
    refused(&fresh(name, "bad.obj", text), more, 1, message);
}

#[test]
fn meshes_that_cannot_be_pressed_are_refused_by_element() {
    bad_mesh("nan", &SQUARE.replace("v 1 1 0", "v nan 1 0"), &[], "vertex 2 has a coordinate");
    bad_mesh("points", "v 0 0 0\n", &[], "no faces");
    bad_mesh("double", &SQUARE.replace("v 1 1 0", "v 0 0 0"), &["--at", "1"], "--weld");
    bad_mesh("isolated", &format!("{SQUARE}v 5 5 5\n"), &["--at", "4"], "vertex 4");
    let two = format!("{SQUARE}v 9 0 0\nv 9 1 0\nv 9 0 1\nf 5 6 7\n");
    bad_mesh("apart", &two, &["--at", "0", "--fix", "4,5,6"], "--fix");
    // Held by directed edges, but not by half-edges.
    let three = format!("{SQUARE}v 0 0 9\nf 1 3 5\n");
    bad_mesh("fan", &three, &["--backend", "half-edge"], "--repair");
}

#[test]
fn from_standard_input_to_standard_output_with_words_beside() {
    let args = ["deform", "-", "--at", "0", "--force", "0,0,1", "--fix", "2", "-o", "-", "--to", "obj"];
    let (run, out) = onering_with_input(args, SQUARE.as_bytes());
    assert_eq!(run.code, Some(0), "{run:?}");
    assert!(run.err.contains("largest displacement"), "{run:?}");
    let after = onering_io::read(&out).unwrap();
    assert!(after.positions[0][2] > 0.1 && after.positions[2] == [1.0, 1.0, 0.0]);
}

#[test]
fn the_figure_has_a_line_for_each_structure() {
    let json: PathBuf = fresh("figure", "figure.json", "");
    let svg = json.with_file_name("figure.svg");
    let args = ["compare", "--deform", "--budget", "0", "--quadratic-up-to", "2500"];
    let files = ["--json", json.to_str().unwrap(), "--plot", svg.to_str().unwrap()];
    let run = onering(args.into_iter().chain(files));
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    assert!(run.out.contains("all neighbours and displacements agree"), "{}", run.out);
    let result: Value = serde_json::from_slice(&fs::read(&json).unwrap()).unwrap();
    let sizes: Vec<u64> =
        result["sizes"].as_array().unwrap().iter().filter_map(|size| size["vertices"].as_u64()).collect();
    assert_eq!(sizes, [198, 1_026, 4_902, 10_002, 20_166]);
    let lines = result["lines"].as_array().unwrap();
    let with_rings =
        onering::registry::BACKENDS.iter().filter(|backend| backend.traits.contains(&"incidence"));
    let names: Vec<&str> =
        ["no data structure"].into_iter().chain(with_rings.map(|backend| backend.name)).collect();
    assert_eq!(lines.iter().map(|line| line["name"].as_str().unwrap()).collect::<Vec<_>>(), names);
    let svg = fs::read_to_string(&svg).unwrap();
    for (i, line) in lines.iter().enumerate() {
        let points = line["points"].as_array().unwrap();
        assert!(svg.contains(names[i]) && run.out.contains(names[i]));
        for (k, point) in points.iter().enumerate() {
            // The search was allowed for the two smallest only.
            assert_eq!(point.is_null(), i == 0 && k >= 2, "{} {k}", names[i]);
            assert!(point.is_null() || point["total"]["median_ns"].as_f64() > Some(0.0));
        }
    }
    let twice = ["--deform", "--json", "new.svg", "--plot", "./new.svg"];
    for (more, message) in [
        (&["--plot", "x.svg"][..], "--deform"),
        (&["--deform", "x.obj"], "cannot be used"),
        (&["--deform", "--plot", "x.obj"], "--plot does not write to 'x.obj'"),
        (&twice, "--json and --plot cannot be one file"),
    ] {
        let run = onering(["compare"].iter().chain(more));
        assert!(run.code == Some(2) && run.err.contains(message), "{run:?}");
    }
}

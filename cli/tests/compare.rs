//! `onering compare`: what it measures, not how long that takes.

mod common;

use common::{FAN, SQUARE, fresh, onering, onering_within, plane, renumbering, scratch};
use onering::registry::{BACKENDS, COMPRESSED, RENUMBERING};
use serde_json::Value;
use std::ffi::OsString;
use std::path::Path;

/// Runs with as little repetition as may be, and gives the JSON.
fn compare(test: &str, files: &[&Path], more: &[&str]) -> (common::Run, Value) {
    let json = scratch(test, "result.json", "not yet");
    let mut args: Vec<OsString> = ["compare", "--budget", "0", "--json"].map(OsString::from).into();
    args.push(json.clone().into());
    args.extend(files.iter().map(|file| file.as_os_str().to_owned()));
    args.extend(more.iter().map(OsString::from));
    let run = onering(args);
    let text = std::fs::read_to_string(&json).unwrap();
    let result = serde_json::from_str(&text).unwrap_or_else(|error| panic!("{error}: {run:?}"));
    (run, result)
}

fn backends(result: &Value, mesh: usize) -> &Vec<Value> {
    result["meshes"][mesh]["backends"].as_array().unwrap()
}

fn backend<'a>(result: &'a Value, mesh: usize, name: &str) -> &'a Value {
    let mut all = backends(result, mesh).iter();
    all.find(|backend| backend["name"] == name).unwrap_or_else(|| panic!("no {name}"))
}

/// An octahedron: V = 6, E = 12, T = 8.
const OCTAHEDRON: &str = "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n\
    f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n";

#[test]
fn every_backend_on_a_small_mesh() {
    let file = scratch("small", "octahedron.obj", OCTAHEDRON);
    let (run, result) = compare("small", &[&file], &[]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    assert_eq!(result["version"], env!("CARGO_PKG_VERSION"));
    assert!(result["machine"]["cores"].as_u64().unwrap() >= 1 && result["machine"]["cpu"].is_string());
    let mesh = &result["meshes"][0];
    assert_eq!(
        [&mesh["vertices"], &mesh["edges"], &mesh["triangles"]].map(Value::as_u64),
        [6, 12, 8].map(Some)
    );
    assert_eq!((mesh["random_vertices"].as_array().unwrap().len(), &mesh["repair"]), (30, &Value::Null));
    let names: Vec<&str> = backends(&result, 0).iter().map(|row| row["name"].as_str().unwrap()).collect();
    let registered = BACKENDS.iter().map(|entry| entry.name).chain(renumbering().map(|(name, _)| name));
    assert_eq!(names, registered.chain(["no data structure"]).collect::<Vec<_>>());
    names.iter().for_each(|name| assert!(run.out.contains(name), "{name}"));
    for row in backends(&result, 0) {
        check_row(row);
    }
    // 24 T + 4 V + 4 E
    let memory = &backend(&result, 0, "che-l2")["memory"];
    assert_eq!(memory["formula_bytes"].as_u64(), Some(24 * 8 + 4 * 6 + 4 * 12));
    assert_eq!(memory["counted_bytes"], memory["formula_bytes"]);
    assert!(memory["peak_bytes"].as_u64() >= memory["counted_bytes"].as_u64());
    // The order of vertices matters as well, so there is a formula in words alone.
    let memory = &backend(&result, 0, "compact-stars")["memory"];
    assert_eq!((&memory["formula"], &memory["formula_bytes"]), (&COMPRESSED[0].formula.into(), &Value::Null));
    // Six vertices differ by five at most: three bits and one for the direction, in each of 24 places. The window behind
    // them, and the marks: of 25 places and 7 starts of stars, and of 24 places and 8 faces.
    assert_eq!(memory["counted_bytes"], 24 * 4 / 8 + 8 + (12 + 4) + (12 + 4));
}

/// A backend has the figures that its traits can give, and `null` for the others.
fn check_row(row: &Value) {
    let (name, traits) = (row["name"].as_str().unwrap(), row["traits"].as_array().unwrap());
    let has =
        |known: &str| traits.iter().any(|t| t == known) || name == "no data structure" && known != "graph";
    let (pairs, walks) = (has("adjacency"), has("incidence") || has("graph"));
    assert_eq!(row["mesh"], "as it is", "{name}");
    if name != "no data structure" {
        assert!(row["build"]["auto"]["median_ns"].as_f64().unwrap() > 0.0, "{name}");
        for strategy in ["quadratic", "paper-hash", "hash", "partition", "chain"] {
            // How those that renumber are made is not for their user to say.
            let is_free = BACKENDS.iter().any(|entry| entry.name == name);
            assert_eq!(row["build"][strategy].is_object(), pairs && is_free, "{name} {strategy}");
        }
        for order in ["shuffled", "reordered"] {
            assert!(row["orders"][order]["build"]["median_ns"].is_f64(), "{name} {order}");
            assert_eq!(row["orders"][order]["sweep"]["ns_per_vertex"].is_f64(), walks, "{name} {order}");
        }
    }
    assert_eq!(row["random_face_queries"].is_object(), pairs, "{name}");
    assert_eq!(row["random_vertex_queries"].is_object(), walks, "{name}");
    assert_eq!(row["sweep"]["ns_per_vertex"].is_number(), walks, "{name}");
    let rings: Vec<f64> =
        row["rings"].as_array().unwrap().iter().filter_map(|r| r["vertices"].as_f64()).collect();
    // Four neighbours, and beyond them the vertex on the other side.
    assert_eq!(rings, if walks { vec![4.0, 5.0, 5.0, 5.0] } else { vec![] }, "{name}");
}

/// Two triangles a row, so that consecutive faces have near vertices; shuffled, they have not.
#[test]
fn the_report_says_how_auto_pairs_in_which_order() {
    let rows = 20_000;
    let vertices = (0..2 * rows).map(|v| format!("v {} {} 0\n", v % 2, v / 2));
    let faces = (1..rows).map(|row| 2 * row - 1).map(|v| {
        let [a, b, c, d] = [v, v + 1, v + 3, v + 2];
        format!("f {a} {b} {c}\nf {a} {c} {d}\n")
    });
    let file = scratch("orders", "ladder.obj", &vertices.chain(faces).collect::<String>());
    let (run, result) = compare("orders", &[&file], &["--backend", "sot", "che-l2"]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    let choices = &result["meshes"][0]["auto_pairing"];
    let choice = |order: &str| choices[order].as_str().unwrap();
    assert_eq!(["given", "shuffled", "reordered"].map(choice), ["chain", "partition", "chain"]);
    let line =
        "auto on the mesh as it is: chain where given, partition where shuffled, chain where reordered\n";
    assert!(run.out.contains(line), "{}", run.out);
    // 12 T, and the two ends of the ladder have corners in one face only.
    let memory = &backend(&result, 0, "sot")["memory"];
    assert_eq!(memory["formula_bytes"], memory["counted_bytes"]);
    assert!(memory["formula_bytes"].as_u64().unwrap() >= 12 * 2 * (rows as u64 - 1));
    assert!(memory["peak_bytes"].as_u64() > memory["counted_bytes"].as_u64());
}

#[test]
fn without_positions_that_are_numbers_there_is_no_reordering() {
    let file = scratch("nowhere", "square.obj", &SQUARE.replacen("v 0 0 0", "v nan 0 0", 1));
    let (run, result) = compare("nowhere", &[&file], &["--backend", "che-l2"]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    let orders = &backend(&result, 0, "che-l2")["orders"];
    assert!(orders["shuffled"].is_object() && orders["reordered"].is_null(), "{orders}");
}

#[test]
fn defects_are_held_or_repaired_and_the_report_says_so() {
    let file = scratch("defective", "fan.obj", FAN);
    let (run, result) = compare("defective", &[&file], &[]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    let (mesh, repair) = (&result["meshes"][0], &result["meshes"][0]["repair"]);
    assert_eq!((&mesh["defects"], &repair["triangles"]), (&"1 non-manifold edge".into(), &3.into()));
    // Three edges less the two that were one with the first, and three times three.
    assert_eq!((&mesh["edges"], &repair["edges"]), (&7.into(), &9.into()));
    let starts = |state: &Value| state["random_vertices"].as_array().unwrap().clone();
    assert_eq!((starts(mesh).len(), starts(repair).len()), (30, 30));
    assert!(
        starts(mesh).iter().all(|v| v.as_u64() < Some(5))
            && starts(repair).iter().any(|v| v.as_u64() > Some(4))
    );
    // In the repaired mesh every vertex has two neighbours and no others, whatever the choice of vertices.
    let counts: Vec<Vec<&str>> = run
        .out
        .lines()
        .filter(|line| line.trim_start().starts_with("(vertices)"))
        .map(|line| line.split_whitespace().collect())
        .collect();
    assert_eq!(counts.len(), 2, "{}", run.out);
    assert_eq!(counts[0][..4], ["(vertices)", "as", "it", "is"]);
    assert_eq!(counts[1], ["(vertices)", "repaired", "(2)", "(2)", "(2)", "(2)"]);
    for entry in BACKENDS.iter().chain(RENUMBERING) {
        let row = backend(&result, 0, entry.name);
        let holds = entry.holds.contains(&"non_manifold_edge");
        assert_eq!(row["mesh"], if holds { "as it is" } else { "repaired" }, "{}", entry.name);
        assert_eq!(row["refusal"].is_string(), !holds, "{}", entry.name);
    }
    for entry in COMPRESSED {
        let row = backend(&result, 0, entry.name);
        assert!(row["mesh"] == "repaired" && row["refusal"].is_string(), "{}", entry.name);
    }
    for words in
        ["repaired for backends that cannot hold this: 1 edge cut", "che-l2 repaired: 3 faces lie along"]
    {
        assert!(run.out.contains(words), "{words}: {}", run.out);
    }
}

#[test]
fn chosen_backends_and_several_files_of_which_one_is_bad() {
    let file = scratch("chosen", "square.obj", SQUARE);
    let missing = file.with_file_name("missing.obj");
    let (run, result) =
        compare("chosen", &[&file, &missing], &["--backend", "che-l3", "--backend", "mate-face"]);
    assert_eq!((run.code, run.err.lines().count()), (Some(1), 1), "{run:?}");
    let names: Vec<&str> = backends(&result, 0).iter().map(|row| row["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["che-l3", "mate-face"]);
    assert!(!run.out.contains("`no data structure`"), "{}", run.out);
    assert_eq!(result["unread"][0]["file"], missing.display().to_string());
    assert_eq!(result["meshes"].as_array().unwrap().len(), 1);
}

#[test]
fn what_is_quadratic_is_left_out_above_a_size_that_is_announced() {
    let file = scratch("limit", "square.obj", SQUARE);
    let (run, result) = compare("limit", &[&file], &["--quadratic-up-to", "1"]);
    assert_eq!(run.code, Some(0));
    assert!(backend(&result, 0, "che-l1")["build"]["quadratic"].is_null());
    assert!(backends(&result, 0).iter().all(|row| row["name"] != "no data structure"));
    let line =
        "left out above 1 triangles (--quadratic-up-to): building without hash, and `no data structure`\n";
    assert!(run.out.contains(line), "{}", run.out);
    assert!(!run.out.contains("searches all faces"), "{}", run.out);
    let (run, _) = compare("limit", &[&file], &["--quadratic-up-to", "1", "--backend", "shared-vertex"]);
    assert!(!run.out.contains("left out above"), "{}", run.out);
}

/// Not a matter of seconds, but of whether it ends.
#[test]
fn many_faces_on_one_edge() {
    let pages = 20_000;
    let mut book = String::from("v 0 0 0\nv 0 0 1\n");
    (0..pages).for_each(|page| book += &format!("v 1 {page} 0\n"));
    (0..pages).for_each(|page| book += &format!("f 1 2 {}\n", page + 3));
    let book = scratch("book", "book.obj", &book);
    // The same three corners again and again, in both orders and with faces that have no area.
    let corners: String = (0..pages).map(|i| ["1 ", "2 ", "3 ", "2 "][i % 4]).collect();
    let polygon = scratch("book", "polygon.obj", &format!("v 0 0 0\nv 1 0 0\nv 0 1 0\nf {corners}\n"));
    let (run, result) = compare("book", &[&book, &polygon], &[]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    assert_eq!(result["meshes"][0]["edges"], 2 * pages + 1);
    for entry in BACKENDS.iter().filter(|entry| entry.holds.contains(&"non_manifold_edge")) {
        assert_eq!(backend(&result, 0, entry.name)["mesh"], "as it is", "{}", entry.name);
    }
}

/// Each step around a vertex is a search over all faces, so that only few faces at it can be gone around.
#[test]
fn a_small_book_is_not_searched_without_a_structure() {
    let pages = 600;
    let vertices = (0..pages).map(|page| format!("v 1 {page} 0\n"));
    let faces = (0..pages).map(|page| format!("f 1 2 {}\n", page + 3));
    let text: String = ["v 0 0 0\nv 0 0 1\n".to_owned()].into_iter().chain(vertices).chain(faces).collect();
    let file = scratch("small_book", "book.obj", &text);
    let (run, result) = compare("small_book", &[&file], &[]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    assert!(backends(&result, 0).iter().all(|row| row["name"] != "no data structure"));
    assert!(backend(&result, 0, "che-l2")["build"]["quadratic"].is_object());
    assert!(
        run.out.contains("left out for vertices of very many faces: `no data structure`\n"),
        "{}",
        run.out
    );
}

#[test]
fn a_single_run_is_marked() {
    let file = scratch("marked", "square.obj", SQUARE);
    let run =
        |budget| onering(["compare", "--budget", budget, "--backend", "che-l2", file.to_str().unwrap()]);
    let is_marked =
        |run: &common::Run| run.out.lines().any(|line| line.contains("che-l2") && line.contains('*'));
    let (once, often) = (run("0"), run("1"));
    assert!(is_marked(&once), "{once:?}");
    assert!(!is_marked(&often), "{often:?}");
    assert!(once.out.contains("`*` is a single run"), "{once:?}");
}

#[test]
fn json_never_takes_the_place_of_a_mesh() {
    let file = scratch("precious", "square.obj", SQUARE);
    let folder = file.parent().unwrap();
    let odd = scratch("precious", "square.mesh", SQUARE);
    std::fs::create_dir_all(folder.join("inner")).unwrap();
    for json in [
        file.clone(),
        odd.clone(),
        folder.join("inner/../square.mesh"),
        folder.join("new.GLB"),
        folder.join("new.off"),
    ] {
        let run = onering(["compare".as_ref(), odd.as_os_str(), "--json".as_ref(), json.as_os_str()]);
        assert_eq!((run.code, run.out.as_str()), (Some(2), ""), "{run:?}");
        assert!(run.err.contains("--json does not write to '"), "{run:?}");
    }
    for kept in [&file, &odd] {
        assert_eq!(std::fs::read_to_string(kept).unwrap(), SQUARE);
    }
    assert_eq!(std::fs::read_dir(folder).unwrap().count(), 3, "something was left behind");
}

#[test]
fn the_same_seed_asks_the_same_vertices() {
    let file = scratch("seed", "octahedron.obj", OCTAHEDRON);
    let vertices = |seed: &str| {
        let (_, result) = compare("seed", &[&file], &["--backend", "che-l2", "--seed", seed]);
        result["meshes"][0]["random_vertices"].clone()
    };
    assert_eq!(vertices("7"), vertices("7"));
    assert_ne!(vertices("7"), vertices("8"));
}

#[test]
fn no_faces_or_none_that_hold_are_no_error() {
    let empty = scratch("few", "empty.obj", "v 0 0 0\n");
    let degenerate = scratch("few", "degenerate.obj", "v 0 0 0\nv 1 0 0\nf 1 1 2\n");
    let (run, result) = compare("few", &[&empty, &degenerate], &[]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    assert!(backends(&result, 0).is_empty());
    assert_eq!(backend(&result, 1, "che-l2")["mesh"], "not built");
    assert_eq!(backend(&result, 1, "shared-vertex")["mesh"], "as it is");
}

#[test]
fn without_a_file_three_meshes_are_made() {
    let (run, result) = compare("made", &[], &["--backend", "che-l2"]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    let meshes = result["meshes"].as_array().unwrap();
    let sizes: Vec<u64> = meshes.iter().map(|mesh| mesh["triangles"].as_u64().unwrap()).collect();
    assert_eq!(sizes, [2106, 81_920, 82_080]);
    let has_quadratic = |i: usize| backend(&result, i, "che-l2")["build"]["quadratic"].is_object();
    assert_eq!([0, 1, 2].map(has_quadratic), [true, false, false]);
}

#[test]
fn json_that_cannot_be_written_is_said_before_the_work() {
    let file = scratch("unwritable", "square.obj", SQUARE);
    let folder = file.parent().unwrap();
    for json in [folder.to_owned(), folder.join("none/result.json")] {
        let run = onering(["compare".as_ref(), file.as_os_str(), "--json".as_ref(), json.as_os_str()]);
        assert_eq!((run.code, run.err.lines().count(), run.out.as_str()), (Some(2), 1, ""), "{run:?}");
    }
    let left = std::fs::read_dir(folder).unwrap().count();
    assert_eq!(left, 1, "something was left behind");
}

/// Deforming works on the numbers of the organ.
#[test]
fn what_renumbers_is_not_deformed() {
    for name in ["sot", "compact-stars"] {
        let run = onering(["compare", "--deform", "--backend", name]);
        assert_eq!((run.code, run.out.as_str(), run.err.lines().count()), (Some(2), "", 1), "{run:?}");
        assert!(run.err.contains(&format!("--deform does not measure {name}")), "{run:?}");
    }
}

/// A million triangles, with less and less memory beyond what they take themselves.
#[test]
fn a_large_mesh_in_too_little_memory_is_no_abort() {
    let file = fresh("little_memory", "plane.obj", &plane(708));
    let args = ["compare", "--budget=0", "--backend=directed-edges-small", file.to_str().unwrap()];
    for megabytes in (72..=112).step_by(4) {
        let run = onering_within(megabytes, args);
        match run.code {
            Some(0) => assert_eq!(run.err, "", "{megabytes} MB: {run:?}"),
            code => {
                assert_eq!((code, run.err.lines().count()), (Some(2), 1), "{megabytes} MB: {run:?}");
                assert!(run.err.contains("no memory for a table of"), "{megabytes} MB: {run:?}");
            }
        }
    }
    std::fs::remove_file(file).unwrap();
}

//! `onering recommend`: who comes into question and why, not who is how fast.

mod common;

use common::{FAN, SQUARE, fresh, onering, onering_in_little_memory, plane, renumbering};
use onering::registry::{BACKENDS, RENUMBERING};
use serde_json::Value;
use std::collections::BTreeSet;

/// Runs with as little repetition as may be, and gives the JSON.
fn recommend(args: &[&str]) -> (common::Run, Value) {
    let run = onering(["recommend", "--budget", "0", "--json"].iter().chain(args));
    let result = serde_json::from_str(&run.out).unwrap_or_else(|error| panic!("{error}: {run:?}"));
    (run, result)
}

fn candidate<'a>(result: &'a Value, name: &str) -> &'a Value {
    let mut all = result["candidates"].as_array().unwrap().iter();
    all.find(|candidate| candidate["name"] == name).unwrap_or_else(|| panic!("no {name}"))
}

/// The names with one of these verdicts.
fn with(result: &Value, verdicts: &[&str]) -> BTreeSet<String> {
    let all = result["candidates"].as_array().unwrap().iter();
    let asked = all.filter(|candidate| verdicts.contains(&candidate["verdict"].as_str().unwrap()));
    asked.map(|candidate| candidate["name"].as_str().unwrap().to_owned()).collect()
}

/// The names of all that give vertices and faces other numbers.
fn names() -> impl Iterator<Item = &'static str> {
    renumbering().map(|(name, _)| name)
}

const ELIGIBLE: [&str; 3] = ["picked", "slower", "larger"];

#[test]
fn without_a_file_a_mesh_is_made_and_everything_has_a_verdict() {
    let (run, result) = recommend(&[]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    let candidates = result["candidates"].as_array().unwrap();
    assert_eq!(candidates.len(), BACKENDS.len() + names().count());
    assert_eq!((&candidates[0]["verdict"], &candidates[0]["name"]), (&"picked".into(), &result["pick"]));
    assert_eq!(with(&result, &["picked"]).len(), 1);
    // Rings are walked by whoever starts from a vertex, and by graphs.
    let walk = |traits: &[&str]| traits.contains(&"incidence") || traits.contains(&"graph");
    let expected = BACKENDS.iter().filter(|entry| walk(entry.traits)).map(|entry| entry.name.to_owned());
    assert_eq!(with(&result, &ELIGIBLE), expected.collect());
    assert_eq!(with(&result, &["renumbers"]), names().map(str::to_owned).collect());
    for candidate in candidates {
        let is_timed = candidate["times"]["rings"]["median_ns"].is_f64();
        assert_eq!(is_timed, ELIGIBLE.contains(&candidate["verdict"].as_str().unwrap()), "{candidate}");
    }
}

#[test]
fn what_is_asked_for_decides_on_traits() {
    for (queries, traits) in [
        ("edges", &["edge_map"][..]),
        ("curves", &["boundaries"]),
        ("opposites,boundaries", &["adjacency"]),
        ("faces", &["topology"]),
        ("stars", &["incidence"]),
        ("neighbours,k-rings", &["incidence", "graph"]),
        ("build", &["topology", "graph"]),
    ] {
        let (run, result) = recommend(&["--queries", queries]);
        assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
        let has = |known: &[&str]| traits.iter().any(|name| known.contains(name));
        let expected = BACKENDS.iter().filter(|entry| has(entry.traits)).map(|entry| entry.name.to_owned());
        assert_eq!(with(&result, &ELIGIBLE), expected.collect(), "{queries}");
        for query in queries.split(',') {
            let pick = candidate(&result, result["pick"].as_str().unwrap());
            assert!(pick["times"][query]["runs"] == 1, "{query}: {pick}");
        }
    }
}

#[test]
fn a_file_may_follow_what_is_asked_for_and_what_is_asked_for_twice_counts_once() {
    let file = fresh("queries", "square.obj", SQUARE);
    let file = file.to_str().unwrap();
    let (run, result) = recommend(&["--queries", "rings", "--queries", "edges,rings", file]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    assert_eq!((&result["mesh"], &result["queries"]), (&file.into(), &serde_json::json!(["rings", "edges"])));
    let has_edges = BACKENDS.iter().filter(|entry| entry.traits.contains(&"edge_map"));
    assert_eq!(with(&result, &ELIGIBLE), has_edges.map(|entry| entry.name.to_owned()).collect());
}

#[test]
fn more_memory_never_takes_a_candidate_away() {
    let (_, free) = recommend(&["--renumber"]);
    let mut needs: Vec<(u64, String)> = free["candidates"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|candidate| ELIGIBLE.contains(&candidate["verdict"].as_str().unwrap()))
        .map(|candidate| (candidate["needs_bytes"].as_u64().unwrap(), candidate["name"].to_string()))
        .collect();
    needs.sort();
    let limits = [needs[0].0 - 1, needs[0].0, needs[needs.len() / 2].0, needs[needs.len() - 1].0];
    let mut before = BTreeSet::new();
    for limit in limits {
        let (run, result) = recommend(&["--renumber", "--memory", &limit.to_string()]);
        let fits = with(&result, &ELIGIBLE);
        let expected =
            needs.iter().filter(|(bytes, _)| *bytes <= limit).map(|(_, name)| name.replace('"', ""));
        assert_eq!(fits, expected.collect(), "{limit}");
        assert!(fits.is_superset(&before), "{limit}");
        assert_eq!(run.code, Some(i32::from(fits.is_empty())), "{run:?}");
        before = fits;
    }
    assert_eq!(before.len(), needs.len());
}

#[test]
fn needs_are_what_is_kept_and_the_list_it_is_built_from() {
    let (_, result) = recommend(&["--queries", "faces"]);
    let [vertices, triangles] = ["vertices", "triangles"].map(|what| result[what].as_u64().unwrap());
    // 12 T, a list of 12 T, and positions.
    let bare = candidate(&result, "che-l0");
    assert_eq!(bare["keeps_bytes"], 12 * triangles + 12 * vertices);
    assert_eq!(bare["needs_bytes"], 24 * triangles + 12 * vertices);
}

#[test]
fn nothing_that_fits_is_said_in_a_line_after_the_table() {
    let run = onering(["recommend", "--budget", "0", "--memory", "1kB"]);
    assert_eq!((run.code, run.err.lines().count()), (Some(1), 1), "{run:?}");
    assert!(run.err.contains("nothing fits in 1.0 kB: the least is "), "{run:?}");
    assert!(run.out.contains("does not fit"), "{run:?}");
    // What was not built is not known to fit in what it takes in any case.
    assert!(run.err.contains(" needs at least ") && run.out.contains("≥ "), "{run:?}");
    let (_, result) = recommend(&["--memory", "1kB"]);
    assert!(result["pick"].is_null() && result["cargo"].is_null(), "{result}");
    for wrong in ["1X", "-1", "0", "many"] {
        let run = onering(["recommend", &format!("--memory={wrong}")]);
        assert_eq!((run.code, run.out.as_str()), (Some(2), ""), "{run:?}");
    }
}

#[test]
fn defects_are_held_or_it_says_that_repair_is_needed() {
    let file = fresh("defects", "fan.obj", FAN);
    let file = file.to_str().unwrap();
    let (run, result) = recommend(&[file]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    assert_eq!((&result["repair"], &result["defects"]), (&Value::Null, &"1 non-manifold edge".into()));
    let holds = |entry: &&onering::registry::Entry| entry.holds.contains(&"non_manifold_edge");
    let walks =
        |entry: &&onering::registry::Entry| entry.traits.iter().any(|t| *t == "incidence" || *t == "graph");
    let expected = BACKENDS.iter().filter(holds).filter(walks).map(|entry| entry.name.to_owned());
    assert_eq!(with(&result, &ELIGIBLE), expected.collect());
    assert!(with(&result, &["needs-repair"]).contains("che-l2"), "{result}");
    // Nothing with names for edges holds it.
    let (run, result) = recommend(&[file, "--queries", "edges"]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    assert!(result["repair"].as_str().unwrap().contains("1 edge cut"), "{result}");
    assert!(result["reason"].as_str().unwrap().starts_with("after repair"), "{result}");
    let (_, repaired) = recommend(&[file, "--queries", "edges", "--repair"]);
    assert!(repaired["repair"].is_null() && repaired["pick"].is_string(), "{repaired}");
}

/// Which would take the square of its faces.
#[test]
fn what_looks_around_a_vertex_of_very_many_faces_is_left_out() {
    let cone = |sides: u32| -> String {
        let vertices = (0..sides).map(|side| format!("v 1 {side} 0\n"));
        let faces = (0..sides).map(|side| format!("f 1 {} {}\n", side + 2, (side + 1) % sides + 2));
        ["v 0 0 0\n".to_owned()].into_iter().chain(vertices).chain(faces).collect()
    };
    let file = fresh("cone", "cone.obj", &cone(40_000));
    let (run, result) = recommend(&["--renumber", "--queries", "opposites", "--", file.to_str().unwrap()]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    assert_eq!(with(&result, &["too-slow"]), names().map(str::to_owned).collect());
    let file = file.to_str().unwrap();
    let backends = ["--backend", "sot", "--backend", "compact-stars", "--backend", "che-l2"];
    let run = onering([&["compare", "--budget", "0"], &backends[..], &["--", file]].concat());
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    for left_out in ["what lies across edges in compact-stars", "all questions to sot"] {
        let line = format!("left out for vertices of very many faces: {left_out}\n");
        assert!(run.out.contains(&line), "{run:?}");
    }
    let (_, rings) = recommend(&["--renumber", "--", file]);
    let renumber = RENUMBERING.iter().map(|entry| entry.name.to_owned());
    assert_eq!(with(&rings, &["too-slow"]), renumber.collect());
    // A few times around is not too much, but from each start of rings it is.
    let file = fresh("lower cone", "cone.obj", &cone(10_000));
    let run =
        onering([&["compare", "--budget", "0"], &backends[..], &["--", file.to_str().unwrap()]].concat());
    let left_out = "left out for vertices of very many faces: all questions to sot\n";
    assert!(run.code == Some(0) && run.out.contains(left_out), "{run:?}");
    assert!(!run.out.contains("across edges in compact-stars"), "{run:?}");
    let (_, rings) = recommend(&["--renumber", "--queries", "k-rings", "--", file.to_str().unwrap()]);
    assert_eq!(with(&rings, &["too-slow"]), ["sot".to_owned()].into());
}

#[test]
fn the_line_for_cargo_names_a_feature_that_there_is() {
    let manifest = std::fs::read_to_string(concat!(env!("CARGO_MANIFEST_DIR"), "/../Cargo.toml")).unwrap();
    let (_, result) = recommend(&["--renumber", "--queries", "build"]);
    for name in BACKENDS.iter().map(|entry| entry.name).chain(names()) {
        let feature = &candidate(&result, name)["feature"];
        let is_there = manifest.contains(&format!("\n{name} = ["));
        assert_eq!(feature.is_string(), is_there, "{name}");
        assert!(feature.is_null() || *feature == name, "{feature}");
    }
    let file = fresh("cargo", "square.obj", SQUARE);
    let run =
        onering(["recommend".as_ref(), "--budget=0".as_ref(), "--queries=curves".as_ref(), file.as_os_str()]);
    assert!(run.out.starts_with("che-l3: "), "{run:?}");
    assert!(run.out.contains("features = [\"che-l3\"] }\nin the program: onering::CheL3, "), "{run:?}");
    assert!(run.out.contains("no answer to curves: lacks boundaries"), "{run:?}");
}

#[test]
fn what_cannot_be_measured_is_said() {
    let empty = fresh("empty", "points.obj", "v 0 0 0\n");
    let run = onering(["recommend".as_ref(), empty.as_os_str()]);
    assert_eq!((run.code, run.err.lines().count(), run.out.as_str()), (Some(1), 1, ""), "{run:?}");
    let run = onering(["recommend", "missing.obj"]);
    assert_eq!((run.code, run.err.lines().count(), run.out.as_str()), (Some(2), 1, ""), "{run:?}");
    assert_eq!(onering(["recommend", "--queries", "miracles"]).code, Some(2));
}

/// 1.6 million triangles, of which what is held before anything is measured is a few times the mesh at most.
#[test]
fn a_large_mesh_in_little_memory_is_no_abort() {
    let file = fresh("little_memory", "plane.obj", &plane(900));
    let run = onering_in_little_memory(["recommend", "--budget=0", "--memory=100M", file.to_str().unwrap()]);
    std::fs::remove_file(file).unwrap();
    match run.code {
        Some(0) => assert!(run.out.contains(" that answer and fit in 100.0 MB"), "{run:?}"),
        code => assert!(code == Some(1) && run.err.contains("no memory for a table"), "{run:?}"),
    }
}

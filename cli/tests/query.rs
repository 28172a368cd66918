//! `onering query`: the nine relations, and the table of random queries.

mod common;

use common::{Run, SQUARE, onering, onering_with_input, scratch};
use serde_json::{Value, json};
use std::path::Path;

/// A square of two triangles, 0 1 2 and 0 2 3, asked on a structure.
fn on(test: &str, backend: &str, args: &[&str]) -> Run {
    let file = scratch(test, "square.obj", SQUARE);
    ask(&file, &[&["--backend", backend], args].concat())
}

fn ask(file: &Path, args: &[&str]) -> Run {
    onering(["query".as_ref(), file.as_os_str()].into_iter().chain(args.iter().map(AsRef::as_ref)))
}

/// The words behind the colon, in order.
fn results(run: &Run) -> Vec<String> {
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    let (_, words) = run.out.trim_end().split_once(':').unwrap();
    let mut words: Vec<String> = words.split_whitespace().map(str::to_owned).collect();
    words.sort();
    words
}

/// The structures that work on meshes, and the empty one.
fn with_faces() -> Vec<&'static str> {
    let with_faces = onering::registry::BACKENDS.iter().filter(|row| row.name != "vertex-graph");
    with_faces.map(|row| row.name).chain(["searched"]).collect()
}

#[test]
fn every_relation_on_every_structure() {
    let known: [(&str, &str, &[&str]); 9] = [
        ("vertex-vertices", "0", &["1", "2", "3"]),
        ("vertex-edges", "0", &["0-1", "0-2", "0-3"]),
        ("vertex-faces", "2", &["0", "1"]),
        ("edge-vertices", "2-0", &["0", "2"]),
        ("edge-edges", "0,1", &["0-2", "0-3", "1-2"]),
        ("edge-faces", "0-2", &["0", "1"]),
        ("face-vertices", "1", &["0", "2", "3"]),
        ("face-edges", "1", &["0-2", "0-3", "2-3"]),
        ("face-faces", "0", &["1"]),
    ];
    for backend in with_faces() {
        for (relation, id, expected) in known {
            let run = on("every", backend, &["--relation", relation, "--id", id]);
            assert_eq!(results(&run), expected, "{backend} {relation}");
        }
    }
}

#[test]
fn names_of_toptri_and_its_graph() {
    let known: [(&str, &str, &[&str]); 6] = [
        ("vGetAdjacentVertices", "0", &["1", "2", "3"]),
        ("vGetIncidentEdges", "0", &["0-1", "0-2", "0-3"]),
        ("vGetIncidentFaces", "1", &["1-0-2"]),
        ("eGetAdjacentEdges", "0-1", &["0-2", "0-3", "1-2"]),
        ("eGetIncidentFaces", "0-2", &["0-2-1", "0-2-3"]),
        ("fGetAdjacentFaces", "0", &["2-0-3"]),
    ];
    for (relation, id, expected) in known {
        let run = on("toptri", "vertex-graph", &["--relation", relation, "--id", id]);
        assert_eq!(results(&run), expected, "{relation}");
    }
    let run = on("toptri", "vertex-graph", &["--relation", "face-edges", "--id", "0"]);
    assert_eq!(run.code, Some(2));
    assert!(run.err.contains("six queries"), "{run:?}");
}

#[test]
fn edges_go_by_number_too_whatever_the_structure() {
    for backend in with_faces() {
        let args = ["--relation", "edge-vertices", "--id", "2", "--id", "3", "--id", "4", "--json"];
        let run = on("numbers", backend, &args);
        let edges: Vec<_> = run.json_lines().iter().map(|line| line["of"]["vertices"].clone()).collect();
        assert_eq!(edges, [json!([0, 2]), json!([2, 3]), json!([0, 3])], "{backend}");
        let numbers: Vec<_> = run.json_lines().iter().map(|line| line["of"]["edge"].clone()).collect();
        assert_eq!(numbers, [2, 3, 4], "{backend}");
    }
}

#[test]
fn json_has_coordinates() {
    let run = on("json", "che-l2", &["--relation", "vertex-faces", "--id", "3", "--json"]);
    let expected = json!({
        "backend": "che-l2",
        "relation": "vertex-faces",
        "toptri": "vGetIncidentFaces",
        "of": { "vertex": 3, "positions": [[0.0, 1.0, 0.0]] },
        "results": [{
            "face": 1, "vertices": [0, 2, 3], "positions": [[0.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
        }],
    });
    assert_eq!(run.json_lines(), [expected]);
}

#[test]
fn an_isolated_vertex_has_nothing_and_a_crowded_edge_all() {
    let crowded = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 1 1\nv 9 9 9\nf 1 2 3\nf 2 1 4\nf 1 2 5\n";
    let file = scratch("crowded", "three.obj", crowded);
    let run = ask(&file, &["--relation", "vertex-edges", "--id", "5", "--id", "0"]);
    assert_eq!(run.out.lines().next(), Some("vertex-edges 5: none"));
    assert_eq!(run.out.lines().nth(1).unwrap().split_whitespace().count(), 2 + 4);
    assert_eq!(results(&ask(&file, &["--relation", "face-faces", "--id", "1"])), ["0", "2"]);
    let run = ask(&file, &["--relation", "face-faces", "--id", "1", "--backend", "che-l2"]);
    assert!(run.code == Some(1) && run.err.contains("che-l2 cannot hold"), "{run:?}");
    let run = ask(&file, &["--random", "9", "--budget", "0", "--backend", "all"]);
    assert!(run.code == Some(0) && run.out.contains("che-l2 cannot hold"), "{run:?}");
}

#[test]
fn a_wrong_id_is_told_in_a_line() {
    let wrong = [
        (["vertex-faces", "4"], "no vertex 4: the mesh has 4 vertices, 0 to 3"),
        (["face-faces", "2"], "no face 2: the mesh has 2 faces, 0 to 1"),
        (["edge-faces", "5"], "no edge 5: the mesh has 5 edges, 0 to 4"),
        (["edge-faces", "1-3"], "no edge 1-3"),
        (["edge-faces", "1-9"], "no edge 1-9"),
        (["face-faces", "1-2"], "1-2 names an edge"),
        (["face-faces", "x"], "an id is a number"),
        (["face-faces", "4294967296"], "an id is a number"),
        (["face-noses", "1"], "face-noses"),
    ];
    for ([relation, id], said) in wrong {
        let run = on("wrong", "directed-edges-small", &["--relation", relation, "--id", id]);
        assert!(run.code == Some(2) && run.out.is_empty() && run.err.contains(said), "{run:?}");
    }
    for args in [&["--id", "1"][..], &["--relation", "face-edges"], &["--random", "0"]] {
        assert_eq!(on("wrong", "che-l2", args).code, Some(2), "{args:?}");
    }
    let run = on("wrong", "all", &["--relation", "face-edges", "--id", "1"]);
    assert!(run.code == Some(2) && run.err.contains("one --backend"), "{run:?}");
}

fn table(args: &[&str]) -> Value {
    let run = onering(["query", "--budget", "0", "--random", "200", "--json"].iter().chain(args));
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    serde_json::from_str(&run.out).unwrap()
}

#[test]
fn structures_list_as_many_results() {
    let table = table(&["--backend", "all"]);
    assert_eq!(table["queries"], json!(200));
    assert!(table["vertices"].as_u64().unwrap() > 1_000);
    let columns = table["backends"].as_array().unwrap();
    assert_eq!((columns.len(), &table["refusals"]), (12, &json!([])));
    for column in columns {
        let name = &column["name"];
        assert!(column["build"]["median_ns"].as_f64().unwrap() > 0.0, "{name}");
        for (query, first) in column["queries"].as_array().unwrap().iter().zip(0..) {
            let first = &columns[0]["queries"][first];
            assert_eq!(query["relation"], first["relation"]);
            // The terrain has no cycle of three edges that is no face.
            let is_left_out = name == "vertex-graph" && query["toptri"].is_null();
            let expected = if is_left_out { &Value::Null } else { &first["results_per_query"] };
            assert_eq!(&query["results_per_query"], expected, "{name} {}", query["relation"]);
            assert_eq!(query["timing"].is_null(), is_left_out, "{name}");
        }
    }
    let of = |relation: usize| columns[0]["queries"][relation]["results_per_query"].as_f64().unwrap();
    assert_eq!([of(3), of(6), of(7)], [2.0, 3.0, 3.0]);
    assert!((5.0..6.0).contains(&of(0)) && of(0) == of(1) && of(2) <= of(1), "{table}");
}

#[test]
fn a_seed_chooses_the_elements() {
    let results = |seed: &str| {
        let table = table(&["--seed", seed, "--backend", "che-l2,mate-face"]);
        assert_eq!(table["backends"].as_array().unwrap().len(), 2);
        table["backends"][0]["queries"]
            .as_array()
            .unwrap()
            .iter()
            .map(|q| q["results_per_query"].clone())
            .collect()
    };
    let [one, same, other]: [Vec<Value>; 3] = ["1", "1", "2"].map(results);
    assert!(one == same && one != other);
}

#[test]
fn the_table_of_a_file_for_people() {
    let file = scratch("table", "square.obj", SQUARE);
    let run = ask(&file, &["--budget", "0", "--backend", "searched", "--backend", "vertex-graph"]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    for said in
        ["10000 queries", "vGetAdjacentVertices", "face-edges", "load", "build", "one query in 100", "4:"]
    {
        assert!(run.out.contains(said), "{said}: {run:?}");
    }
    let (run, out) = onering_with_input(["query", "-", "--budget", "0", "--json"], SQUARE.as_bytes());
    let table: Value = serde_json::from_slice(&out).unwrap();
    assert_eq!((run.code, &table["load"], &table["mesh"]), (Some(0), &Value::Null, &json!("standard input")));
    assert_eq!(table["degrees"], json!([[2, 2], [3, 2]]));
    let (run, _) = onering_with_input(["query", "-"], b"v 0 0 0\n");
    assert!(run.code == Some(1) && run.err.contains("no faces"), "{run:?}");
}

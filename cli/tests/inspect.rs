//! `onering inspect` on meshes whose figures were counted by hand.

mod common;

use common::{SQUARE, onering, scratch};
use serde_json::{Value, json};
use sha2::Digest;

fn inspect(test: &str, name: &str, content: &str) -> Value {
    let path = scratch(test, name, content);
    let run = onering(["inspect".as_ref(), "--json".as_ref(), path.as_os_str()]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    let mut found = run.json_lines();
    assert_eq!(found.len(), 1);
    found.remove(0)
}

fn check(found: &Value, expected: &Value) {
    for (name, value) in expected.as_object().unwrap() {
        assert_eq!(&found[name], value, "{name}");
    }
}

/// A square pyramid: a base of one quad, four sides. Edges: 4 around the base, 4 up, 1 diagonal.
const PYRAMID: &str = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 1\n\
    f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

#[test]
fn a_pyramid() {
    let found = inspect("pyramid", "pyramid.obj", PYRAMID);
    check(
        &found,
        &json!({
            "format": "OBJ", "bytes": PYRAMID.len(), "vertices": 5, "polygons": 5,
            "polygon_sizes": {"3": 4, "4": 1}, "triangles": 6, "finite_coordinates": true,
            "bbox_min": [0.0, 0.0, 0.0], "bbox_max": [2.0, 2.0, 1.0],
            // The diagonal of the base goes from vertex 4 to 2.
            "degree_histogram": {"3": 2, "4": 3},
            "verdict": "closed manifold",
            "welded": "same as topology (no two vertices share a position)",
        }),
    );
    check(
        &found["topology"],
        &json!({
            "degenerate_faces": 0, "duplicate_faces": 0, "isolated_vertices": 0, "edges": 9, "boundary_edges": 0,
            "nonmanifold_edges": 0, "max_faces_per_edge": 2, "components": 1, "euler": 2, "boundary_loops": 0,
            "orientable": true, "closed": true, "manifold": true, "genus": 0, "valence_min": 3, "valence_max": 4,
            "max_faces_per_vertex": 4,
        }),
    );
    let near = |name: &str, value: f64| {
        assert!((found[name].as_f64().unwrap() - value).abs() < 1e-12, "{name}");
    };
    near("area", 4.0 + 4.0 * 2.0_f64.sqrt());
    near("signed_volume", 4.0 / 3.0);
}

#[test]
fn defects_and_what_was_left_out() {
    // Three faces on one edge, one of them twice, a degenerate face, a vertex in none, a point, a face of two.
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nv 9 9 9\np 1\nf 1 2\n\
        f 1 2 3\nf 2 1 4\nf 1 2 5\nf 5 1 2\nf 3 3 4\n";
    let found = inspect("defects", "defects.obj", text);
    check(
        &found,
        &json!({
            "skipped_faces": 1, "ignored_elements": {"p": 1}, "polygons": 5, "triangles": 5,
            "degree_histogram": {"0": 1, "2": 3, "4": 2},
        }),
    );
    check(
        &found["topology"],
        &json!({
            "degenerate_faces": 1, "duplicate_faces": 1, "duplicate_faces_same_orientation": 1,
            "isolated_vertices": 1, "edges": 7, "boundary_edges": 4, "nonmanifold_edges": 1,
            "max_faces_per_edge": 4, "closed": false, "manifold": false, "genus": null,
        }),
    );
    // The copy runs along two more edges of its original, in the same direction.
    let verdict = "needs repair: 1 degenerate face, 1 non-manifold edge, 2 inconsistent edges";
    assert_eq!(found["verdict"], verdict);
    assert_eq!(found["notes"].as_array().unwrap().len(), 2);
}

#[test]
fn two_sheets_that_welding_joins() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 0 1 -0\nv 1 1 0\nf 1 2 3\nf 5 4 6\n";
    let found = inspect("sheets", "sheets.obj", text);
    check(&found["topology"], &json!({"components": 2, "edges": 6, "boundary_loops": 2}));
    let verdict =
        "open manifold: 6 boundary edges in 2 loops; welded: open manifold: 4 boundary edges in 1 loop";
    assert_eq!(found["verdict"], verdict);
    check(&found["welded"], &json!({"vertices": 4, "components": 1, "edges": 5, "boundary_loops": 1}));
}

#[test]
fn a_mesh_of_nothing_and_a_mesh_without_place() {
    let found = inspect("nothing", "empty.obj", "# nothing\n");
    check(
        &found,
        &json!({"verdict": "no faces", "vertices": 0, "triangles": 0, "bbox_min": null, "area": null, "degree_histogram": {}}),
    );
    let found = inspect("nothing", "nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
    check(
        &found,
        &json!({"finite_coordinates": false, "bbox_max": null, "signed_volume": null, "triangles": 1}),
    );
}

#[test]
fn the_same_figures_in_words() {
    let path = scratch("words", "square.obj", SQUARE);
    let run = onering(["inspect".as_ref(), path.as_os_str()]);
    assert_eq!(run.code, Some(0));
    let verdict = format!("{}: open manifold: 4 boundary edges in 1 loop", path.display());
    assert_eq!(run.out.lines().next(), Some(&verdict[..]));
    for line in ["triangles                         2", "degree_histogram                  2: 2, 3: 2"] {
        assert!(run.out.lines().any(|found| found.trim() == line), "{}", run.out);
    }
    let words = |line: &str| line.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
    assert!(run.out.lines().any(|line| words(line) == ["boundary_edges", "4"]), "{}", run.out);
}

/// Of a large file only a piece at a time is in memory, unless something is wrong with it: then it is read again.
#[test]
fn a_large_file_has_the_digest_of_all_its_bytes() {
    let large = SQUARE.to_owned() + &"# a comment\n".repeat(100_000);
    let path = scratch("large", "large.obj", &large);
    let run = onering(["inspect".as_ref(), "--json".as_ref(), path.as_os_str()]);
    let digest: String = sha2::Sha256::digest(&large).iter().map(|byte| format!("{byte:02x}")).collect();
    check(&run.json_lines()[0], &json!({ "bytes": large.len(), "sha256": digest, "triangles": 2 }));
    let path = scratch("large", "bad.obj", &(large.clone() + "f 1 2 x\n"));
    let run = onering(["inspect".as_ref(), path.as_os_str()]);
    let line = large.lines().count() + 1;
    assert!(run.err.contains(&format!("bad.obj:{line}: ")), "{run:?}");
}

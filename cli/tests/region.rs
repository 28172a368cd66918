//! `onering region`: the stalactite that a point is on.

mod common;

use common::{Run, fresh, onering, onering_with_input};
use onering_io::load;
use serde_json::{Value, json};
use std::fs;
use std::path::Path;

/// A pyramid that hangs from its square, then one face of the roof beside it, and a vertex without faces.
const TIP: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0.5 0.5 -1\nv 0.5 -1 0\nv 9 9 -9\n\
                   f 2 1 5\nf 3 2 5\nf 4 3 5\nf 1 4 5\nf 1 2 6\n";

fn region(file: &Path, more: &[&str]) -> Run {
    onering(["region", file.to_str().unwrap()].into_iter().chain(more.iter().copied()))
}

fn found(run: &Run) -> Value {
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    run.json_lines().remove(0)
}

/// Four triangles with a base of 1 and a height of the square root of 1.25.
fn is_the_pyramid(found: &Value) {
    assert_eq!((&found["triangles"], &found["vertices"]), (&4.into(), &5.into()), "{found}");
    assert!((found["area"].as_f64().unwrap() - 2.0 * 1.25f64.sqrt()).abs() < 1e-12, "{found}");
    assert_eq!((&found["bbox_min"], &found["bbox_max"]), (&json!([0.0, 0.0, -1.0]), &json!([1.0, 1.0, 0.0])));
    assert_eq!(found["size"], json!([1.0, 1.0, 1.0]));
}

#[test]
fn a_vertex_a_point_or_neither() {
    let file = fresh("seeds", "tip.obj", TIP);
    for (at, vertex) in [("4", 4), ("0", 0), ("0.6,0.4,-0.9", 4), ("-1,-1,0", 0), (" 9, 9, -9", 4)] {
        let found = found(&region(&file, &["--json", "--at", at]));
        is_the_pyramid(&found);
        assert_eq!(found["at"], vertex, "{at}");
    }
    assert_eq!(found(&region(&file, &["--json"]))["at"], 4);
}

#[test]
fn every_backend_finds_the_same() {
    let file = fresh("backends", "tip.obj", TIP);
    for backend in ["shared-vertex", "che-l1", "che-l2", "half-edge", "mate-face", "searched"] {
        is_the_pyramid(&found(&region(&file, &["--json", "--at", "4", "--backend", backend])));
    }
}

#[test]
fn text_has_units_where_they_are_known() {
    let file = fresh("text", "tip.obj", TIP);
    let run = region(&file, &["--unit", "dm"]);
    assert_eq!((run.code, run.err.lines().count()), (Some(0), 1), "{run:?}");
    assert!(run.err.starts_with("found in "), "{run:?}");
    let lines: Vec<&str> = run.out.lines().map(str::trim).collect();
    assert_eq!(lines[1..3], ["triangles  4", "vertices   5"]);
    assert!(lines[3].starts_with("area       2.2360679") && lines[3].ends_with(" dm\u{b2}"), "{run:?}");
    assert_eq!(lines[4], "size       1 x 1 x 1 dm");
    assert!(!region(&file, &[]).out.contains("dm"));
}

#[test]
fn the_region_is_written_as_a_mesh() {
    let file = fresh("written", "tip.obj", TIP);
    for format in common::written() {
        let out = file.with_file_name(format!("part.{format}"));
        assert_eq!(region(&file, &["-o", out.to_str().unwrap()]).code, Some(0));
        let part = load(&out).unwrap();
        assert_eq!((part.positions.len(), part.faces.len()), (5, 4), "{format}");
        assert!(part.positions.contains(&[0.5, 0.5, -1.0]), "{format}");
    }
}

#[test]
fn up_and_the_angle_can_be_said() {
    let lying = TIP.lines().map(|line| match line.split(' ').collect::<Vec<_>>()[..] {
        ["v", x, y, z] => format!("v {x} {z} -{y}\n").replace("--", ""),
        _ => format!("{line}\n"),
    });
    let file = fresh("up", "lying.obj", &lying.collect::<String>());
    let found_of = |more: &[&str]| found(&region(&file, &[more, &["--json"]].concat()));
    let upright = found_of(&["--up", "y", "--at", "4"]);
    assert_eq!((&upright["triangles"], &upright["up"]), (&4.into(), &"y".into()));
    assert_eq!(upright["size"], json!([1.0, 1.0, 1.0]));
    // No flank is as steep as that, so the faces at the tip are all.
    assert_eq!(found_of(&["--up", "y", "--at", "1", "--steep", "89"])["triangles"], 4);
    for steep in ["-1", "91", "nan", "x"] {
        assert_eq!(region(&file, &["--steep", steep]).code, Some(2), "{steep}");
    }
}

/// On a made roof, the longest stalactite is cut out, and not the roof.
#[test]
fn a_made_roof_has_a_stalactite() {
    let run = onering(["region", "--json"]);
    let found = found(&run);
    assert!((60..2000).contains(&found["triangles"].as_u64().unwrap()), "{found}");
    assert!(found["size"][2].as_f64().unwrap() > 0.8, "{found}");
    assert_eq!(found["unit"], "m");
}

#[test]
fn standard_input_is_read() {
    let (run, out) = onering_with_input(["region", "-", "--json"], TIP.as_bytes());
    assert_eq!(run.code, Some(0), "{run:?}");
    is_the_pyramid(&serde_json::from_slice(&out).unwrap());
}

#[test]
fn failures_are_a_line_and_leave_nothing() {
    let file = fresh("failures", "tip.obj", TIP);
    let folder = file.parent().unwrap();
    let cases: [(&[&str], i32, &str); 6] = [
        (&["--at", "7"], 2, "there is no vertex 7: there are 7, counted from 0"),
        (&["--at", "18446744073709551615"], 2, "there is no vertex"),
        (&["--at", "6"], 1, "no face has vertex 6"),
        (&["-o", "none/part.ply"], 1, "none/part.ply"),
        (&["-o", "part.xyz"], 1, "not a known mesh format"),
        (&["-o", "part.x3d"], 1, "is read, but not written"),
    ];
    for (more, code, words) in cases {
        let run = region(&file, more);
        assert_eq!((run.code, run.out.as_str(), run.err.lines().count()), (Some(code), "", 1), "{run:?}");
        assert!(run.err.starts_with("onering: ") && run.err.contains(words), "{run:?}");
        assert_eq!(fs::read_dir(folder).unwrap().count(), 1);
    }
    for at in ["1,2", "1,2,3,4", "a", "1,2,nan", "-1", ""] {
        assert_eq!(region(&file, &["--at", at]).code, Some(2), "{at}");
    }
    for (text, code, words) in [
        ("", 1, "it has no faces, and so no region"),
        ("v 0 0 0\n", 1, "it has no faces, and so no region"),
        ("v 0 0 0\nv nan 0 0\nv 0 1 0\nf 1 2 3\n", 2, "vertex 1 has a coordinate or a value"),
    ] {
        fs::write(&file, text).unwrap();
        for at in [&[][..], &["--at", "0,0,0"]] {
            let run = region(&file, at);
            assert_eq!((run.code, run.err.lines().count()), (Some(code), 1), "{run:?}");
            assert!(run.err.contains(words), "{run:?}");
        }
    }
}

//! `onering convert`: what comes out is what went in, but for what was asked for.

#[path = "../common/mod.rs"]
mod common;
mod order;

use common::{Run, SQUARE, fresh, inspect, onering, written};
use onering_io::Format;
use serde_json::Value;
use std::fs;
use std::path::{Path, PathBuf};

fn convert(input: &Path, output: &Path, more: &[&str]) -> Run {
    let paths = [input.to_str().unwrap(), output.to_str().unwrap()];
    onering(["convert"].into_iter().chain(paths).chain(more.iter().copied()))
}

/// Converts, which has to succeed, and gives what is said of it.
fn converted(input: &Path, output: &Path, more: &[&str]) -> String {
    let run = convert(input, output, more);
    assert_eq!((run.code, run.out.as_str()), (Some(0), ""), "{run:?}");
    run.err
}

/// A torus of `n` times `n` quads, each two triangles, its vertices in order of first appearance: all formats can hold
/// it as it is.
fn torus(n: usize) -> String {
    let at = |i: usize, j: usize| (i % n, j % n);
    let quads = (0..n * n).map(|k| {
        let (i, j) = (k / n, k % n);
        [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]
    });
    let faces: Vec<_> = quads.flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    let mut order = Vec::new();
    let mut text = String::new();
    for corner in faces.as_flattened() {
        if !order.contains(corner) {
            order.push(*corner);
            let [u, v] = [corner.0, corner.1].map(|k| std::f32::consts::TAU * k as f32 / n as f32);
            let (x, y, z) = ((3.0 + v.cos()) * u.cos(), (3.0 + v.cos()) * u.sin(), v.sin());
            text += &format!("v {x} {y} {z}\n");
        }
    }
    let number = |corner: &(usize, usize)| order.iter().position(|known| known == corner).unwrap() + 1;
    for [a, b, c] in &faces {
        text += &format!("f {} {} {}\n", number(a), number(b), number(c));
    }
    text
}

#[test]
fn every_format_to_every_other_gives_the_same_arrays() {
    let start = fresh("formats", "torus.obj", &torus(7));
    let expected = inspect(&start);
    assert_eq!(expected["verdict"], "closed manifold");
    for first in written() {
        let one = start.with_file_name(format!("one.{first}"));
        converted(&start, &one, &[]);
        for second in written() {
            let two = start.with_file_name(format!("two-{first}.{second}"));
            converted(&one, &two, &[]);
            let found = inspect(&two);
            for figure in ["vertices", "triangles", "tri_sha256", "verdict"] {
                assert_eq!(found[figure], expected[figure], "{first} to {second}: {figure}");
            }
            assert_eq!(bounds(&found), bounds(&expected), "{first} to {second}");
        }
    }
}

/// The box in 32 bits, as positions are: figures of decimals have fewer digits than those of binary files.
fn bounds(found: &Value) -> [f32; 6] {
    let at = |i: usize| &found[["bbox_min", "bbox_max"][i / 3]][i % 3];
    std::array::from_fn(|i| at(i).as_f64().unwrap() as f32)
}

#[test]
fn polygons_stay_polygons() {
    let text = "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 1\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";
    let start = fresh("polygons", "pyramid.obj", text);
    let out = start.with_file_name("out.obj");
    let said = converted(&start, &out, &[]);
    assert_eq!(inspect(&out)["polygon_sizes"], inspect(&start)["polygon_sizes"]);
    assert!(said.contains("polygons   1, of more than 3 corners\n"), "{said}");
    assert!(!said.contains("lost"), "{said}");
}

/// A quad with three others around it, one of which runs the other way, and a face twice.
#[test]
fn repair_keeps_the_polygons_that_it_flips() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nv 2 1 0\nv 3 0 0\nv 3 1 0\n\
        f 1 2 3 4\nf 2 3 6 5\nf 5 7 8 6\nf 1 2 3\n";
    let start = fresh("flipped", "strip.obj", text);
    let out = start.with_file_name("out.obj");
    assert_eq!(inspect(&start)["topology"]["manifold"], false);
    let said = converted(&start, &out, &["--repair"]);
    assert!(said.contains("  triangles  7 -> 6\n"), "{said}");
    assert!(said.contains("repaired   1 duplicate face dropped, 2 faces flipped\n"), "{said}");
    let found = inspect(&out);
    assert_eq!(found["polygon_sizes"], serde_json::json!({"4": 3}));
    assert_eq!(found["verdict"], "open manifold: 8 boundary edges in 1 loop");
}

#[test]
fn repair_makes_a_manifold_of_any_list() {
    // Three faces on an edge, one face degenerate, one twice, two that touch in a vertex only.
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nv 5 5 5\nv 6 5 5\n\
        f 1 2 3\nf 2 1 4\nf 1 2 5\nf 3 3 4\nf 3 1 2\nf 3 6 7\n";
    let start = fresh("repair", "defects.obj", text);
    assert!(inspect(&start)["verdict"].as_str().unwrap().starts_with("needs repair: "));
    for format in written() {
        let out = start.with_file_name(format!("out.{format}"));
        let said = converted(&start, &out, &["--repair"]);
        assert!(said.contains("1 degenerate face dropped, 1 duplicate face dropped"), "{said}");
    }
    let found = inspect(&start.with_file_name("out.obj"));
    assert!(found["verdict"].as_str().unwrap().starts_with("open manifold: "), "{found}");
    assert_eq!(found["triangles"], 4);
}

#[test]
fn welding_joins_what_shares_a_position() {
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 0 0\nv 0 1 -0\nv 1 1 0\nf 1 2 3\nf 5 4 6\n";
    let start = fresh("weld", "sheets.obj", text);
    let out = start.with_file_name("out.obj");
    let said = converted(&start, &out, &["--weld"]);
    assert!(said.contains("  vertices   6 -> 4\n") && said.contains("welded     2 vertices"), "{said}");
    assert_eq!(inspect(&out)["verdict"], "open manifold: 4 boundary edges in 1 loop");
    // Not unless it is asked for.
    let said = converted(&start, &out, &[]);
    assert!(said.contains("  vertices   6\n") && !said.contains("welded"), "{said}");
}

#[test]
fn what_the_reader_left_out_is_said_unless_quiet() {
    let start = fresh("said", "points.obj", &format!("{SQUARE}p 1\n"));
    let out = start.with_file_name("out.obj");
    let said = converted(&start, &out, &[]);
    let head = format!("{} (OBJ) -> {} (OBJ)\n", start.display(), out.display());
    assert!(said.starts_with(&head), "{said}");
    assert!(said.contains("note       1 element of kind `p` skipped, the first at line 7\n"), "{said}");
    for quiet in ["--quiet", "-q"] {
        assert_eq!(converted(&start, &out, &[quiet]), "");
    }
}

#[test]
fn a_format_that_holds_less_says_what_is_lost() {
    let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 9 9 9\nf 1 2 3 4\n";
    let start = fresh("lost", "square.obj", text);
    for format in written() {
        let out = start.with_file_name(format!("out.{format}"));
        let said = converted(&start, &out, &[]);
        let found = inspect(&out);
        let keeps_polygons = found["polygon_sizes"]["4"] == 1;
        assert_eq!(said.contains("1 polygon was cut"), !keeps_polygons, "{format}: {said}");
        assert_eq!(said.contains("1 vertex in none"), found["vertices"] == 4, "{format}: {said}");
    }
}

#[test]
fn in_and_out_may_be_one_file() {
    let path = fresh("same", "square.obj", &format!("{SQUARE}f 3 2 1\n"));
    converted(&path, &path, &["--repair"]);
    assert_eq!(inspect(&path)["triangles"], 2);
    assert_eq!(files_beside(&path), 1);
}

#[test]
fn a_file_packed_with_gzip_in_and_out() {
    let start = fresh("packed", "torus.obj", &torus(5));
    let packed = start.with_file_name("torus.obj.gz");
    converted(&start, &packed, &[]);
    assert!(fs::read(&packed).unwrap().starts_with(&[0x1F, 0x8B]));
    let back = start.with_file_name("back.obj");
    converted(&packed, &back, &[]);
    assert_eq!(inspect(&back)["tri_sha256"], inspect(&start)["tri_sha256"]);
}

#[test]
fn from_and_to_have_the_last_word() {
    let start = fresh("named", "mesh.data", SQUARE);
    let out = start.with_file_name("out.data");
    converted(&start, &out, &["--from", "OBJ", "--to", "obj"]);
    assert_eq!(inspect(&out)["triangles"], 2);
    let run = convert(&start, &out, &["--from", "glb", "--to", "obj"]);
    assert_eq!((run.code, run.err.lines().count()), (Some(2), 1), "{run:?}");
}

fn files_beside(path: &Path) -> usize {
    fs::read_dir(path.parent().unwrap()).unwrap().count()
}

/// What was in OUT is there still, and nothing else is.
fn assert_untouched(run: &Run, code: i32, old: &Path, content: &str, files: usize) {
    assert_eq!((run.code, run.out.as_str()), (Some(code), ""), "{run:?}");
    assert_eq!(fs::read_to_string(old).unwrap(), content, "{run:?}");
    assert_eq!(files_beside(old), files, "{run:?}");
}

#[test]
fn a_failure_leaves_the_old_file() {
    let old = fresh("old", "old.obj", SQUARE);
    let broken = old.with_file_name("broken.obj");
    fs::write(&broken, "v 0 0 0\nf 1 2 3\n").unwrap();
    let empty = old.with_file_name("empty.glb");
    fs::write(&empty, "").unwrap();
    let folder = old.parent().unwrap();
    for input in [&broken, &empty, &folder.join("missing.obj"), folder] {
        let run = convert(input, &old, &[]);
        assert_untouched(&run, 2, &old, SQUARE, 3);
        let line = format!("onering: {}", input.display());
        assert!(run.err.starts_with(&line) && run.err.lines().count() == 1, "{run:?}");
    }
    let run = convert(&old, &old, &["--attribute", "ring=0,colour"]);
    assert_untouched(&run, 2, &old, SQUARE, 3);
    assert!(run.err.contains("boundary"), "{run:?}");
}

#[test]
fn out_that_cannot_be_written_is_said_in_a_line() {
    let start = fresh("unwritable", "square.obj", SQUARE);
    let folder = start.parent().unwrap();
    let mut cases: Vec<(PathBuf, i32, &str)> = vec![
        (folder.join("none/out.obj"), 1, "its folder: "),
        (folder.join("square.obj/out.obj"), 1, "its folder"),
        (folder.join("out.xyz"), 2, "no format that is written; those are "),
        (folder.join("out"), 2, "or say --to"),
    ];
    let only_read = |format: &Format| !format.is_written() && *format != Format::Ring;
    for format in Format::all().filter(only_read) {
        let name = format!("out.{}", format.extensions()[0]);
        cases.push((folder.join(name), 2, " is read, but not written; written are "));
    }
    for (out, code, words) in cases {
        let run = convert(&start, &out, &[]);
        assert_untouched(&run, code, &start, SQUARE, 1);
        assert!(run.err.starts_with(&format!("onering: {}: ", out.display())), "{run:?}");
        assert!(run.err.contains(words) && run.err.lines().count() == 1, "{words}: {run:?}");
    }
    fs::create_dir(folder.join("taken.obj")).unwrap();
    let run = convert(&start, &folder.join("taken.obj"), &[]);
    assert_untouched(&run, 1, &start, SQUARE, 2);
}

/// Attributes go where they can be held, and nowhere else in silence.
#[test]
fn attributes_are_written_or_refused() {
    let start = fresh("attributes", "square.obj", SQUARE);
    let all = ["components", "boundary", "valence", "ring=2", "x", "y", "z"];
    for format in written() {
        let plain = start.with_file_name(format!("plain.{format}"));
        converted(&start, &plain, &[]);
        for name in all {
            let out = start.with_file_name(format!("{}.{format}", name.replace('=', "-")));
            let run = convert(&start, &out, &["--attribute", name]);
            if run.code == Some(0) {
                assert_ne!(fs::read(&out).unwrap(), fs::read(&plain).unwrap(), "{format} {name}");
                assert_eq!(inspect(&out)["tri_sha256"], inspect(&plain)["tri_sha256"], "{format} {name}");
            } else {
                assert_eq!((run.code, out.exists()), (Some(2), false), "{run:?}");
                assert!(run.err.contains("has no place for attributes"), "{run:?}");
            }
        }
    }
}

/// The edges of a face that names a vertex twice are not defined.
#[test]
fn an_attribute_that_the_mesh_has_not_is_said_and_repair_helps() {
    let start = fresh("undefined", "degenerate.obj", &format!("{SQUARE}f 1 1 2\n"));
    for format in written() {
        let out = start.with_file_name(format!("out.{format}"));
        let run = convert(&start, &out, &["--attribute", "boundary"]);
        if run.code == Some(2) {
            continue; // No place for attributes.
        }
        assert_eq!((run.code, out.exists()), (Some(1), false), "{run:?}");
        let line = format!("onering: {}: face 2 names vertex 0 twice", start.display());
        assert!(run.err.starts_with(&line), "{run:?}");
        converted(&start, &out, &["--attribute", "boundary", "--repair"]);
    }
}

#[test]
fn a_backend_is_for_ring_files_alone() {
    let start = fresh("backend", "square.obj", SQUARE);
    let out = start.with_file_name("out.obj");
    let run = convert(&start, &out, &["--backend", "che-l2"]);
    assert_eq!((run.code, out.exists()), (Some(2), false));
    assert!(run.err.contains("--backend is for `.ring` files"), "{run:?}");
    let run = convert(&start, &out, &["--backend", "che-l9"]);
    assert_eq!(run.code, Some(2));
    for backend in onering::registry::BACKENDS {
        assert!(run.err.contains(backend.name), "{run:?}");
    }
}

#[test]
fn unknown_formats_are_answered_with_the_known_ones() {
    let start = fresh("unknown", "square.obj", SQUARE);
    let out = start.with_file_name("out.obj");
    for option in ["--from", "--to"] {
        let run = convert(&start, &out, &[option, "step"]);
        assert_eq!(run.code, Some(2), "{run:?}");
        let known = Format::all()
            .filter(|format| option == "--from" || format.is_written() || *format == Format::Ring);
        for extension in known.flat_map(Format::extensions) {
            assert!(run.err.contains(extension), "{option} {extension}: {run:?}");
        }
    }
}

/// Every real mesh, written in every format, has its triangles still.
#[test]
fn real_meshes_survive() {
    let Some((folder, entries)) = common::meshes() else { return };
    let here = fresh("real", "none", "");
    let small = entries.iter().filter(|entry| entry["figures"]["triangles"].as_u64() < Some(20_000));
    let readable = |path: &PathBuf| Format::of_extension(path).is_some();
    let paths = small.map(|entry| folder.join(entry["file"].as_str().unwrap())).filter(readable);
    for path in paths.take(12) {
        let before = inspect(&path);
        for format in written() {
            let out = here.with_file_name(format!("real.{format}"));
            converted(&path, &out, &[]);
            let after = inspect(&out);
            assert_eq!(after["triangles"], before["triangles"], "{} to {format}", path.display());
            let [old, new] = [&before, &after].map(|found| found["area"].as_f64().unwrap());
            assert!((old - new).abs() <= 1e-9 * old, "{} to {format}: {old} {new}", path.display());
        }
    }
}

/// As a full disk does: the old file stays, and nothing is left beside it.
#[cfg(unix)]
#[test]
fn a_file_that_may_not_grow_is_an_error() {
    let start = fresh("full", "torus.obj", &torus(40));
    let out = start.with_file_name("out.ply");
    fs::write(&out, "old").unwrap();
    let limited = "ulimit -f 8 && exec \"$0\" convert \"$1\" \"$2\"";
    let mut shell = std::process::Command::new("sh");
    shell.args(["-c", limited, env!("CARGO_BIN_EXE_onering")]).args([&start, &out]);
    let run = common::of(&shell.output().unwrap());
    assert_untouched(&run, 1, &out, "old", 2);
    assert!(run.err.starts_with(&format!("onering: {}: ", out.display())), "{run:?}");
}

//! `-`: standard input and output.

mod common;

use common::{SQUARE, fresh, inspect, onering, onering_with_input, written};
use onering_io::Format;
use std::fs;
use std::io::Read;
use std::process::Stdio;

#[test]
fn through_a_pipe_and_back() {
    let start = fresh("through", "square.obj", SQUARE);
    for format in written() {
        let (run, bytes) = onering_with_input(["convert", "-", "-", "--format", format], SQUARE.as_bytes());
        assert_eq!(run.code, Some(0), "{run:?}");
        assert!(run.err.starts_with("standard input (OBJ) -> standard output ("), "{run:?}");
        let back = start.with_file_name(format!("{format}.obj"));
        for name in ["--format", "--from"] {
            let (run, _) =
                onering_with_input(["convert", "-", back.to_str().unwrap(), name, format, "-q"], &bytes);
            assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
            assert_eq!(inspect(&back)["tri_sha256"], inspect(&start)["tri_sha256"], "{format}");
        }
    }
}

#[test]
fn from_a_file_to_standard_output() {
    let start = fresh("out", "square.obj", SQUARE);
    for to in ["--format", "--to"] {
        let run = onering(["convert", start.to_str().unwrap(), "-", to, "obj", "--quiet"]);
        assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
        assert!(run.out.starts_with("v 0.0 0.0 0.0\n") && run.out.ends_with("f 1 3 4\n"), "{run:?}");
    }
}

#[test]
fn both_formats_can_be_said() {
    let (run, bytes) =
        onering_with_input(["convert", "-", "-", "--from", "obj", "--format", "obj"], SQUARE.as_bytes());
    assert_eq!((run.code, bytes.is_empty()), (Some(0), false), "{run:?}");
    let (run, bytes) =
        onering_with_input(["convert", "-", "-", "--from", "glb", "--to", "obj"], SQUARE.as_bytes());
    assert_eq!((run.code, bytes.is_empty()), (Some(2), true), "{run:?}");
    assert!(run.err.starts_with("onering: standard input: "), "{run:?}");
}

#[test]
fn standard_input_is_inspected_among_files() {
    let file = fresh("among", "square.obj", SQUARE);
    let one = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    let args = ["inspect", "--json", file.to_str().unwrap(), "-", "missing.obj"];
    let (run, out) = onering_with_input(args, one.as_bytes());
    assert_eq!((run.code, run.err.lines().count()), (Some(1), 1), "{run:?}");
    let out = String::from_utf8(out).unwrap();
    let found: Vec<serde_json::Value> = out.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    assert_eq!(found.len(), 2);
    assert_eq!(found[1]["file"], "standard input");
    assert_eq!((&found[1]["triangles"], &found[1]["format"]), (&1.into(), &"OBJ".into()));
}

#[test]
fn a_format_that_content_does_not_tell() {
    // Nothing in it is a word of the format.
    let text = b"hello\n";
    let (run, _) = onering_with_input(["inspect", "-"], text);
    assert_eq!((run.code, run.err.lines().count()), (Some(2), 1), "{run:?}");
    assert!(run.err.starts_with("onering: standard input: not a known mesh format"), "{run:?}");
    let (run, _) = onering_with_input(["inspect", "-", "--format", "glb"], text);
    assert!(run.err.starts_with("onering: standard input: GLB"), "{run:?}");
}

#[test]
fn nothing_on_standard_input_is_an_error() {
    let old = fresh("nothing_in", "old.obj", SQUARE);
    for args in [
        &["inspect", "-"][..],
        &["inspect", "-", "--format", "obj"],
        &["convert", "-", old.to_str().unwrap(), "--format", "obj"],
    ] {
        let (run, out) = onering_with_input(args, b"");
        let line = "onering: standard input: it is empty\n";
        assert_eq!((run.code, run.err.as_str(), out.len()), (Some(2), line, 0), "{run:?}");
    }
    assert_eq!(fs::read_to_string(&old).unwrap(), SQUARE);
}

#[test]
fn dashes_that_make_no_sense() {
    for (args, words) in [
        (&["inspect", "-", "-"][..], "once only"),
        (&["inspect", "a.obj", "--format", "obj"], "--format is for standard input"),
        (&["convert", "a.obj", "b.obj", "--format", "obj"], "there are --from and --to"),
        (&["convert", "a.obj", "-"], "add --format; written are ."),
    ] {
        let run = onering(args);
        assert_eq!((run.code, run.out.as_str()), (Some(2), ""), "{args:?}");
        assert!(run.err.contains(words), "{words}: {run:?}");
    }
    for format in Format::all().filter(|format| !format.is_written() && *format != Format::Ring) {
        let run = onering(["convert", "a.obj", "-", "--format", format.extensions()[0]]);
        assert_eq!((run.code, run.out.as_str()), (Some(2), ""), "{format}");
        assert!(run.err.contains(" is read, but not written"), "{run:?}");
    }
}

#[test]
fn a_reader_that_stops_early_is_no_error() {
    // More than a pipe holds.
    let start = fresh("early", "points.obj", &"v 1 2 3\n".repeat(50_000));
    let mut child = common::command()
        .args(["convert", start.to_str().unwrap(), "-", "--format", "obj"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let mut bytes = [0; 10];
    child.stdout.take().unwrap().read_exact(&mut bytes).unwrap();
    let run = common::of(&child.wait_with_output().unwrap());
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
}

/// A device that is always full.
#[cfg(target_os = "linux")]
#[test]
fn output_that_cannot_be_written_ends_with_1() {
    let start = fresh("full_out", "square.obj", SQUARE);
    let path = start.to_str().unwrap();
    for args in [
        &["convert", path, "-", "--format", "obj"][..],
        &["man"],
        &["completions", "bash"],
        &["convert", "-h"],
    ] {
        let full = fs::File::options().write(true).open("/dev/full").unwrap();
        let output = common::command().args(args).stdout(full).stderr(Stdio::piped()).output().unwrap();
        let run = common::of(&output);
        assert_eq!((run.code, run.err.lines().count()), (Some(1), 1), "{args:?}: {run:?}");
        assert!(run.err.starts_with("onering: standard output: "), "{run:?}");
    }
    // The device by its name, as a file.
    let run = onering(["convert", path, "/dev/full", "--to", "obj"]);
    assert_eq!((run.code, run.err.lines().count()), (Some(1), 1), "{run:?}");
}

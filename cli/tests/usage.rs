//! What is said on the command line, and how a run ends.

mod common;

use common::{SQUARE, onering, scratch};
use std::io::Read;
use std::process::Stdio;

#[test]
fn wrong_usage_ends_with_2() {
    for args in [
        &["inspect"][..],
        &["frobnicate"],
        &["inspect", "--frobnicate", "x.obj"],
        &["compare", "--seed", "x"],
    ] {
        let run = onering(args);
        assert_eq!((run.code, run.out.as_str()), (Some(2), ""), "{args:?}");
        assert!(run.err.contains("error: "), "{run:?}");
    }
}

#[test]
fn help_and_version_end_with_0() {
    for (args, text) in [
        (&["--help"][..], "Exit codes"),
        (&["inspect", "--help"], "--json"),
        (&["compare", "--help"], "directed-edges-small"),
        (&["--version"], env!("CARGO_PKG_VERSION")),
    ] {
        let run = onering(args);
        assert_eq!(run.code, Some(0), "{args:?}");
        assert!(run.out.contains(text), "{args:?}: {}", run.out);
    }
}

#[test]
fn an_unknown_backend_is_answered_with_the_list_of_all() {
    for args in
        [&["compare", "--backend", "che-l9"][..], &["compare", "--backend", "che-l1", "che-l9", "x.obj"]]
    {
        let run = onering(args);
        assert_eq!(run.code, Some(2), "{run:?}");
        assert!(run.err.contains("'che-l9'"), "{run:?}");
        for backend in onering::registry::BACKENDS {
            assert!(run.err.contains(backend.name), "{run:?}");
        }
    }
    assert_eq!(onering(["compare", "--backend", "x.obj"]).code, Some(2));
}

#[test]
fn unreadable_files_get_a_line_each_and_the_others_go_on() {
    let good = scratch("unreadable", "square.obj", SQUARE);
    let strange = scratch("unreadable", "picture.png", "\u{89}PNG");
    let folder = good.parent().unwrap();
    let bad = [folder.join("missing.obj"), folder.to_owned(), strange];
    let run =
        onering(bad.iter().chain([&good]).map(|path| path.as_os_str()).collect::<Vec<_>>().iter().fold(
            vec!["inspect".into(), "--json".into()],
            |mut args: Vec<std::ffi::OsString>, path| {
                args.push((*path).to_owned());
                args
            },
        ));
    assert_eq!((run.code, run.json_lines().len()), (Some(1), 1), "{run:?}");
    let lines: Vec<&str> = run.err.lines().collect();
    assert_eq!(lines.len(), 3, "{run:?}");
    for (line, path) in lines.iter().zip(&bad) {
        assert!(line.starts_with(&format!("onering: {}: ", path.display())), "{line}");
    }
}

#[test]
fn no_readable_file_ends_with_2() {
    for command in ["inspect", "compare"] {
        let run = onering([command, "missing.obj", "missing.glb"]);
        assert_eq!((run.code, run.err.lines().count()), (Some(2), 2), "{run:?}");
    }
}

#[test]
fn a_malformed_file_is_named_with_its_line() {
    let path = scratch("malformed_line", "bad.obj", "v 0 0 0\nf 1 2 3\n");
    let run = onering(["inspect".as_ref(), path.as_os_str()]);
    let line = format!("onering: {}:2: face names vertex 2, but there are 1\n", path.display());
    assert_eq!((run.code, run.err), (Some(2), line));
}

#[cfg(unix)]
#[test]
fn a_line_break_in_a_name_does_not_make_two_lines() {
    let run = onering(["inspect", "a\nb.obj"]);
    assert_eq!((run.code, run.err.lines().count()), (Some(2), 1), "{run:?}");
}

#[test]
fn a_reader_that_stops_early_is_no_error() {
    let path = scratch("pipe", "square.obj", SQUARE);
    // More than a pipe holds.
    let mut args = vec!["inspect".into()];
    args.extend(std::iter::repeat_n(path.into_os_string(), 200));
    let mut child =
        common::command().args(args).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap();
    let mut start = [0; 10];
    child.stdout.take().unwrap().read_exact(&mut start).unwrap();
    let run = common::of(&child.wait_with_output().unwrap());
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
}

/// A device that is always full.
#[cfg(target_os = "linux")]
#[test]
fn output_that_cannot_be_written_ends_with_1() {
    let path = scratch("full", "square.obj", SQUARE);
    let path = path.to_str().unwrap();
    for args in [
        &["--help"][..],
        &["compare", "--help"],
        &["--version"],
        &["inspect", path],
        &["inspect", "--json", path],
        &["compare", "--budget", "0", "--backend", "che-l2", path],
    ] {
        let full = std::fs::File::options().write(true).open("/dev/full").unwrap();
        let output = common::command().args(args).stdout(full).stderr(Stdio::piped()).output().unwrap();
        let run = common::of(&output);
        assert_eq!((run.code, run.err.lines().count()), (Some(1), 1), "{args:?}: {run:?}");
        assert!(run.err.starts_with("onering: standard output: "), "{args:?}: {run:?}");
    }
    let run = onering(["--help"]);
    let help = run.out.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(help.contains("or output could not be written"), "{run:?}");
}

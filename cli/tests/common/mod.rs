//! Runs the binary, and finds the real files.
#![allow(dead_code, reason = "each test uses a part of it")]

use onering::registry::{COMPRESSED, RENUMBERING};
use onering_io::Format;
use serde_json::Value;
use std::ffi::OsStr;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::thread;

/// What a run of `onering` gave.
#[derive(Debug)]
pub(crate) struct Run {
    pub(crate) code: Option<i32>,
    pub(crate) out: String,
    pub(crate) err: String,
}

pub(crate) fn onering<S: AsRef<OsStr>>(args: impl IntoIterator<Item = S>) -> Run {
    of(&command().args(args).output().unwrap())
}

/// As [`onering`], with 200 MB of memory and ten seconds of processor at most, where there is a shell to say so.
pub(crate) fn onering_in_little_memory<S: AsRef<OsStr>>(args: impl IntoIterator<Item = S>) -> Run {
    onering_within(200, args)
}

/// The same with so many megabytes.
pub(crate) fn onering_within<S: AsRef<OsStr>>(megabytes: usize, args: impl IntoIterator<Item = S>) -> Run {
    if cfg!(not(target_os = "linux")) {
        return onering(args);
    }
    let limited = format!("ulimit -v {megabytes}000 && ulimit -t 10 && exec \"$0\" \"$@\"");
    let mut shell = Command::new("sh");
    shell.args(["-c", &limited, env!("CARGO_BIN_EXE_onering")]).args(args);
    of(&shell.output().unwrap())
}

pub(crate) fn command() -> Command {
    Command::new(env!("CARGO_BIN_EXE_onering"))
}

pub(crate) fn of(output: &Output) -> Run {
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).unwrap();
    let run = Run { code: output.status.code(), out: text(&output.stdout), err: text(&output.stderr) };
    assert!(!run.err.contains("panicked"), "{run:?}");
    run
}

/// As [`onering`], with these bytes on standard input.
pub(crate) fn onering_with_input<S: AsRef<OsStr>>(
    args: impl IntoIterator<Item = S>,
    input: &[u8],
) -> (Run, Vec<u8>) {
    let mut command = command();
    command.args(args).stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
    let mut child = command.spawn().unwrap();
    let mut stdin = child.stdin.take().unwrap();
    // Written beside the reading: a pipe holds only so much. Who refuses its arguments reads nothing.
    let output = thread::scope(|scope| {
        scope.spawn(move || stdin.write_all(input));
        child.wait_with_output().unwrap()
    });
    let out = output.stdout.clone();
    (of(&Output { stdout: Vec::new(), ..output }), out)
}

/// The extension of every format that is written.
pub(crate) fn written() -> impl Iterator<Item = &'static str> {
    Format::all().filter(|format| format.is_written()).map(|format| format.extensions()[0])
}

/// What `inspect` says of a file.
pub(crate) fn inspect(path: &Path) -> Value {
    let run = onering(["inspect".as_ref(), "--json".as_ref(), path.as_os_str()]);
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""), "{run:?}");
    run.json_lines().remove(0)
}

impl Run {
    /// The JSON objects on standard output, one a line.
    pub(crate) fn json_lines(&self) -> Vec<Value> {
        self.out.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
    }
}

/// A file for one test to write: its own folder in the folder for such things.
pub(crate) fn scratch(test: &str, name: &str, content: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(test);
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join(name);
    std::fs::write(&path, content).unwrap();
    path
}

/// As [`scratch`], in a folder that has nothing else, and that tests in other files do not share.
pub(crate) fn fresh(test: &str, name: &str, content: &str) -> PathBuf {
    let test = format!("{}/{test}", env!("CARGO_CRATE_NAME"));
    let _ = std::fs::remove_dir_all(Path::new(env!("CARGO_TARGET_TMPDIR")).join(&test));
    scratch(&test, name, content)
}

/// A plane of squares, two triangles each, with so many vertices along each side.
pub(crate) fn plane(side: usize) -> String {
    let vertices = (0..side * side).map(|v| format!("v {} {} 0\n", v % side, v / side));
    let corners = (1..side).flat_map(|y| (1..side).map(move |x| (y - 1) * side + x));
    let faces = corners.map(|v| {
        let [a, b, c, d] = [v, v + 1, v + side + 1, v + side];
        format!("f {a} {b} {c}\nf {a} {c} {d}\n")
    });
    vertices.chain(faces).collect()
}

/// Two triangles on an edge.
pub(crate) const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 3 4\n";

/// Three triangles on an edge.
pub(crate) const FAN: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 0 -1 0\nf 1 2 3\nf 2 1 4\nf 1 2 5\n";

/// The name and the traits of all that give vertices and faces other numbers.
pub(crate) fn renumbering() -> impl Iterator<Item = (&'static str, &'static [&'static str])> {
    let entries = RENUMBERING.iter().map(|entry| (entry.name, entry.traits));
    entries.chain(COMPRESSED.iter().map(|entry| (entry.name, entry.traits)))
}

/// The folder of real meshes: `ONERING_MESHES`, or `shared/meshes` beside the workspace.
fn meshes_folder() -> PathBuf {
    match std::env::var_os("ONERING_MESHES") {
        Some(folder) => folder.into(),
        None => concat!(env!("CARGO_MANIFEST_DIR"), "/../../shared/meshes").into(),
    }
}

/// The folder of real meshes and the entries of its manifest.
pub(crate) fn meshes() -> Option<(PathBuf, Vec<Value>)> {
    with_manifest(meshes_folder())
}

/// The folder of broken files, beside the real ones, and the entries of its manifest.
pub(crate) fn malformed() -> Option<(PathBuf, Vec<Value>)> {
    with_manifest(meshes_folder().with_file_name("malformed"))
}

/// Without the folder a test is skipped, unless `ONERING_REQUIRE_MESHES=1`.
fn with_manifest(folder: PathBuf) -> Option<(PathBuf, Vec<Value>)> {
    let path = folder.join("MANIFEST.json");
    match std::fs::read(&path) {
        Ok(bytes) => {
            let manifest: Value = serde_json::from_slice(&bytes).unwrap();
            Some((folder, manifest["files"].as_array().unwrap().clone()))
        }
        Err(error) => {
            let required = std::env::var("ONERING_REQUIRE_MESHES").is_ok_and(|value| value == "1");
            assert!(!required, "{}: {error}", path.display());
            eprintln!("skipped: no {}; set ONERING_MESHES to the folder of meshes", path.display());
            None
        }
    }
}

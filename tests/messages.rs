//! What a backend cannot answer does not compile, and the error names the remedy.
//!
//! The messages are the compiler's own, asked for a few lines each against the library that this test is linked with.
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::atomic::{AtomicUsize, Ordering};

/// The directory of this test's own dependencies, and the newest build of the library in it.
fn library() -> (PathBuf, PathBuf) {
    let program = std::env::current_exe().unwrap();
    let dependencies = program.parent().unwrap().to_path_buf();
    let is_library = |path: &PathBuf| {
        let name = path.file_name().unwrap().to_string_lossy();
        name.starts_with("libonering-") && name.ends_with(".rlib")
    };
    let files = dependencies.read_dir().unwrap().map(|entry| entry.unwrap().path());
    let newest = files.filter(is_library).max_by_key(|path| path.metadata().unwrap().modified().unwrap());
    (dependencies, newest.expect("the library is beside its tests"))
}

/// What the compiler says where `bound` is asked of `mesh`; nothing where that compiles.
fn compile(mesh: &str, bound: &str) -> String {
    static FILES: AtomicUsize = AtomicUsize::new(0);
    let number = FILES.fetch_add(1, Ordering::Relaxed);
    let source =
        Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("uses_{}_{number}.rs", std::process::id()));
    let needs = format!("fn needs(_: &impl onering::{bound}) {{}}");
    let uses = format!("pub fn uses(mesh: &onering::{mesh}) {{ needs(mesh) }}");
    std::fs::write(&source, format!("{needs}\n{uses}\n")).unwrap();
    let (dependencies, library) = library();
    let output = Command::new(std::env::var_os("RUSTC").unwrap_or_else(|| "rustc".into()))
        .args(["--edition=2024", "--crate-type=lib", "--crate-name=uses", "--emit=metadata", "--color=never"])
        .arg(format!("--extern=onering={}", library.display()))
        .arg(format!("-Ldependency={}", dependencies.display()))
        .arg("-o")
        .arg(source.with_extension("rmeta"))
        .arg(&source)
        .output()
        .unwrap();
    std::fs::remove_file(&source).unwrap();
    let _ = std::fs::remove_file(source.with_extension("rmeta"));
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.success(), said.is_empty(), "{said}");
    said
}

fn names(mesh: &str, bound: &str, parts: &[&str]) {
    let said = compile(mesh, bound);
    for part in parts {
        assert!(said.contains(part), "no {part:?} where {mesh} is asked for {bound}:\n{said}");
    }
}

#[test]
fn what_is_there_compiles() {
    assert_eq!(compile("CheL3", "Boundaries"), "");
    assert_eq!(compile("Searched<onering::CheL0>", "Incidence"), "");
}

#[test]
fn adjacency() {
    let remedy = [
        "what lies across an edge",
        "`WithOpposites::new(mesh)`",
        "`CheL1`",
        "`DirectedEdgesSmall`",
        "feature `adjacency`",
    ];
    names("CheL0", "Adjacency", &remedy);
}

#[test]
fn incidence() {
    let remedy = [
        "cannot start from a vertex",
        "`WithOutgoing::new(mesh)`",
        "`Searched::new(mesh)`",
        "`CheL2`",
        "feature `incidence`",
    ];
    names("CheL1", "Incidence", &remedy);
}

#[test]
fn edge_map() {
    names(
        "DirectedEdgesFull",
        "EdgeMap",
        &["no names for edges", "`edges::edge_map(&mesh)`", "`CheL2EdgeTable`", "feature `edge-map`"],
    );
}

#[test]
fn boundaries() {
    names(
        "CheL2",
        "Boundaries",
        &[
            "no names for boundary curves",
            "`boundary::curves(&mesh)`",
            "`CheL3`",
            "feature `boundary-curves`",
        ],
    );
}

//! Every seed through its target, and what fuzzing left in the corpus where there is one.
use onering_fuzz::{TARGETS, Target, format_of};
use std::collections::BTreeSet;
use std::fs;
use std::io::ErrorKind;
use std::path::{Path, PathBuf};

/// The files of a target below `seeds` or `corpus`.
fn files(under: &str, target: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(under).join(target);
    let mut files: Vec<_> = fs::read_dir(folder)
        .map(|entries| entries.map(|entry| entry.expect("a readable folder").path()).collect())
        .unwrap_or_default();
    files.sort();
    files
}

fn replay(files: &[PathBuf], target: Target) {
    for path in files {
        // Shown where it fails.
        println!("{}", path.display());
        match fs::read(path) {
            Ok(bytes) => target(&bytes),
            // A fuzzer at work replaces files of the corpus by smaller ones.
            Err(error) => assert_eq!(error.kind(), ErrorKind::NotFound, "{error}"),
        }
    }
}

#[test]
fn seeds_pass() {
    for (name, target) in TARGETS {
        let seeds = files("seeds", name);
        assert!(!seeds.is_empty(), "{name} has no seeds");
        replay(&seeds, target);
    }
}

#[test]
fn the_corpus_passes() {
    TARGETS.iter().for_each(|&(name, target)| replay(&files("corpus", name), target));
}

/// A seed that is refused by mistake would teach the fuzzer nothing.
#[test]
fn seeds_are_read_or_refused_as_named() {
    for (target, _) in
        TARGETS.iter().filter(|(target, _)| !["index_buffer", "ring", "written"].contains(target))
    {
        for path in files("seeds", target) {
            let name = path.file_name().expect("a file").to_string_lossy();
            let bytes = fs::read(&path).expect("a readable file");
            let read = match format_of(target) {
                Some(format) => onering_io::read_as(&bytes, format),
                None => onering_io::read(&bytes),
            };
            let read = read.map(|mesh| mesh.faces.len());
            if !name.starts_with("found-") {
                assert_eq!(read.is_err(), name.starts_with("bad-"), "{target}/{name}: {read:?}");
            }
        }
    }
}

#[test]
fn every_target_is_built() {
    let manifest = include_str!("../Cargo.toml");
    let built: BTreeSet<_> =
        manifest.lines().filter_map(|line| line.strip_prefix("path = \"targets/")).collect();
    let listed: BTreeSet<_> = TARGETS.iter().map(|(name, _)| format!("{name}.rs\"")).collect();
    assert!(listed.iter().eq(built), "{listed:?}");
}

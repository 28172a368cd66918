//! The real meshes, and what an independent program counted of each.
use onering_io::Triangles;
use serde_json::Value;
use std::sync::LazyLock;
use std::{env, fs, path::PathBuf};

/// A mesh of the folder, and its `figures` in the manifest.
pub(crate) struct Real {
    pub(crate) name: String,
    pub(crate) mesh: Triangles,
    pub(crate) figures: Value,
}

/// The meshes of the manifest; none, with a note, where the folder is missing.
pub(crate) static MESHES: LazyLock<Vec<Real>> = LazyLock::new(|| folder().map_or(Vec::new(), load));

/// `ONERING_MESHES`, else `shared/meshes` beside the repository. That it is missing is a failure with
/// `ONERING_REQUIRE_MESHES=1`.
fn folder() -> Option<PathBuf> {
    let beside = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../shared/meshes"));
    let folder = env::var_os("ONERING_MESHES").map_or(beside, PathBuf::from);
    if folder.join("MANIFEST.json").exists() {
        return Some(folder);
    }
    let required = env::var_os("ONERING_REQUIRE_MESHES").is_some_and(|value| value == "1");
    assert!(!required, "no meshes in {}", folder.display());
    println!("skipped: no meshes in {}", folder.display());
    None
}

fn load(folder: PathBuf) -> Vec<Real> {
    let text = fs::read_to_string(folder.join("MANIFEST.json")).unwrap();
    let manifest: Value = serde_json::from_str(&text).unwrap();
    let read = |entry: &Value| {
        let name = entry["file"].as_str().unwrap();
        let mesh = onering_io::load(folder.join(name)).unwrap_or_else(|error| panic!("{error}"));
        Real { name: name.into(), mesh, figures: entry["figures"].clone() }
    };
    let meshes: Vec<Real> = manifest["files"].as_array().unwrap().iter().map(read).collect();
    assert!(meshes.len() >= 56, "only {} meshes", meshes.len());
    meshes
}

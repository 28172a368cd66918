//! Where the real files are, and what their manifest says.
#![allow(dead_code, reason = "each test uses a part of it")]

use std::path::{Path, PathBuf};

use serde_json::Value;

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

/// The name of a manifest entry and its path.
pub(crate) fn path_of(folder: &Path, entry: &Value) -> (String, PathBuf) {
    let name = entry["file"].as_str().unwrap().to_owned();
    let path = folder.join(&name);
    (name, path)
}

/// A glTF document of these members, as JSON text.
pub(crate) fn document(members: &str) -> String {
    format!(r#"{{"asset": {{"version": "2.0"}}, {members}}}"#)
}

/// A GLB with these two chunks, each padded to 4 bytes.
pub(crate) fn glb(json: &str, bin: &[u8]) -> Vec<u8> {
    let mut json = json.as_bytes().to_vec();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut bin = bin.to_vec();
    bin.resize(bin.len().next_multiple_of(4), 0);
    let mut file = b"glTF\x02\0\0\0".to_vec();
    file.extend((28 + json.len() as u32 + bin.len() as u32).to_le_bytes());
    for (kind, chunk) in [(b"JSON", &json), (b"BIN\0", &bin)] {
        file.extend((chunk.len() as u32).to_le_bytes());
        file.extend(kind);
        file.extend(chunk);
    }
    file
}

/// The bytes of numbers, as glTF stores them.
pub(crate) fn le_bytes(numbers: &[f32]) -> Vec<u8> {
    numbers.iter().flat_map(|number| number.to_le_bytes()).collect()
}

/// What tobj makes of an OBJ file, polygons cut into triangles; `None` where it gives up.
pub(crate) fn tobj_models(bytes: &[u8]) -> Option<Vec<tobj::Model>> {
    let options = tobj::LoadOptions {
        triangulate: true,
        ignore_points: true,
        ignore_lines: true,
        ..Default::default()
    };
    let loaded = tobj::load_obj_buf(&mut &bytes[..], &options, |_| Ok(Default::default()));
    loaded.ok().map(|(models, _)| models)
}

//! The few lines of OBJ that the real meshes need, and where they are.
use std::{env, fs, path::PathBuf};

/// The folder of real meshes: `ONERING_MESHES`, else `shared/meshes` beside the repository. `None`, with a note,
/// where it is missing; with `ONERING_REQUIRE_MESHES=1` that is a failure.
pub fn folder() -> Option<PathBuf> {
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

/// Number of vertices, and polygons as fans from their first corner; faces that repeat a vertex are left out,
/// as the figures of the manifest do.
pub fn read(text: &str) -> (usize, Vec<[u32; 3]>) {
    let text = text.replace("\\\r\n", " ").replace("\\\n", " ");
    let (mut vertex_count, mut faces) = (0, Vec::new());
    for line in text.lines() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => vertex_count += 1,
            Some("f") => {
                let words = words.take_while(|word| !word.starts_with('#'));
                let polygon: Vec<u32> = words.map(|word| vertex(word, vertex_count)).collect();
                faces.extend(polygon.windows(2).skip(1).map(|w| [polygon[0], w[0], w[1]]));
            }
            _ => {}
        }
    }
    faces.retain(|[a, b, c]| a != b && b != c && c != a);
    (vertex_count, faces)
}

/// The vertex of a face corner such as `7/1/3`, or `-2` for the last but one.
fn vertex(corner: &str, vertex_count: usize) -> u32 {
    let index: i64 = corner.split('/').next().unwrap().parse().unwrap();
    (if index > 0 { index - 1 } else { vertex_count as i64 + index }) as u32
}

/// A mesh of the folder, and the `topology` that the oracle counted for it.
pub struct Real {
    pub name: String,
    pub vertex_count: usize,
    pub faces: Vec<[u32; 3]>,
    pub figures: serde_json::Value,
}

/// The OBJ files of the manifest that `wanted` takes by name.
pub fn meshes(wanted: fn(&str) -> bool) -> Vec<Real> {
    let Some(folder) = folder() else { return Vec::new() };
    let text = fs::read_to_string(folder.join("MANIFEST.json")).unwrap();
    let manifest: serde_json::Value = serde_json::from_str(&text).unwrap();
    let entries = manifest["files"].as_array().unwrap().iter();
    let named = entries.map(|entry| (entry["file"].as_str().unwrap(), &entry["figures"]["topology"]));
    let load = |(name, figures): (&str, &serde_json::Value)| {
        let (vertex_count, faces) = read(&fs::read_to_string(folder.join(name)).unwrap());
        Real { name: name.to_owned(), vertex_count, faces, figures: figures.clone() }
    };
    named.filter(|(name, _)| name.ends_with(".obj") && wanted(name)).map(load).collect()
}

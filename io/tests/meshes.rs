//! Every real OBJ, glTF, STL and OFF file gives the figures of the manifest, which come from an independent reader.

mod common;

use std::collections::BTreeMap;

use onering_io::Triangles;
use serde_json::Value;
use sha2::{Digest, Sha256};

#[test]
fn real_files_give_the_figures_of_the_manifest() {
    let Some((folder, entries)) = common::meshes() else { return };
    let mut read = 0;
    for entry in entries.iter().filter(|entry| is_read(entry)) {
        let (name, path) = common::path_of(&folder, entry);
        let mesh = onering_io::load(&path).unwrap_or_else(|error| panic!("{error}"));
        check(&name, &mesh, &entry["figures"]);
        read += 1;
    }
    assert!(read >= 40, "only {read} files of formats that are read");
}

fn is_read(entry: &Value) -> bool {
    ["OBJ", "glTF", "GLB", "STL ascii", "STL binary", "OFF"].contains(&entry["format"].as_str().unwrap())
}

fn check(name: &str, mesh: &Triangles, figures: &Value) {
    assert_eq!(Some(mesh.positions.len() as u64), figures["vertices"].as_u64(), "{name}");
    assert_eq!(Some(mesh.faces.len() as u64), figures["triangles"].as_u64(), "{name}");
    assert_eq!(Some(mesh.polygon_count() as u64), figures["polygons"].as_u64(), "{name}");
    assert_eq!(mesh.polygon_sizes, sizes(figures), "{name}");
    assert_eq!(faces_sha256(mesh), figures["tri_sha256"].as_str().unwrap(), "{name}");
    assert_eq!(bounds(mesh, f32::min, f32::INFINITY), corner(&figures["bbox_min"]), "{name}");
    assert_eq!(bounds(mesh, f32::max, f32::NEG_INFINITY), corner(&figures["bbox_max"]), "{name}");
}

fn sizes(figures: &Value) -> BTreeMap<usize, usize> {
    let sizes = figures["polygon_sizes"].as_object().unwrap();
    sizes.iter().map(|(size, count)| (size.parse().unwrap(), count.as_u64().unwrap() as usize)).collect()
}

fn faces_sha256(mesh: &Triangles) -> String {
    let bytes: Vec<u8> = mesh.faces.iter().flatten().flat_map(|corner| corner.to_le_bytes()).collect();
    Sha256::digest(&bytes).iter().map(|byte| format!("{byte:02x}")).collect()
}

fn bounds(mesh: &Triangles, choose: fn(f32, f32) -> f32, start: f32) -> [f32; 3] {
    mesh.positions.iter().fold([start; 3], |bound, p| std::array::from_fn(|i| choose(bound[i], p[i])))
}

/// A corner of the bounding box, which the manifest gives in `f64`.
fn corner(value: &Value) -> [f32; 3] {
    std::array::from_fn(|i| value[i].as_f64().unwrap() as f32)
}

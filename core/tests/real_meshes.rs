//! Real meshes against the figures that an independent program counted: the OBJ files of the set, whose
//! corners and positions a few lines can read. The set is in `ONERING_MESHES`, else in `shared/meshes` beside the
//! repository; where it is missing the test passes with a note, unless `ONERING_REQUIRE_MESHES=1`.

use onering_core::defects::Defects;
use onering_core::repair::{RepairOptions, Repaired, repair, weld};
use serde_json::Value;
use std::collections::HashMap;
use std::env;
use std::fs;
use std::path::{Path, PathBuf};

struct Mesh {
    positions: Vec<[f64; 3]>,
    faces: Vec<[u32; 3]>,
}

/// Positions, and polygons as fans from their first corner; corners by position alone.
fn read_obj(path: &Path) -> Mesh {
    let text = fs::read_to_string(path).expect("a readable file").replace("\\\n", " ");
    let mut mesh = Mesh { positions: vec![], faces: vec![] };
    for line in text.lines().map(|line| line.split('#').next().unwrap_or_default()) {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("v") => mesh.positions.push([(); 3].map(|()| words.next().unwrap().parse().unwrap())),
            Some("f") => {
                let count = mesh.positions.len() as i64;
                let index = |word: &str| word.split('/').next().unwrap().parse::<i64>().unwrap();
                let vertex = |i: i64| if i > 0 { i - 1 } else { count + i };
                let polygon: Vec<u32> = words.map(|word| vertex(index(word)) as u32).collect();
                let fan = polygon.windows(2).skip(1).map(|two| [polygon[0], two[0], two[1]]);
                mesh.faces.extend(fan);
            }
            _ => {}
        }
    }
    mesh
}

impl Mesh {
    fn single_precision(&self) -> Vec<[f32; 3]> {
        self.positions.iter().map(|p| p.map(|x| x as f32)).collect()
    }

    fn area(&self, faces: impl IntoIterator<Item = u32>) -> f64 {
        faces.into_iter().map(|f| area(self.faces[f as usize].map(|v| self.positions[v as usize]))).sum()
    }
}

fn area([a, b, c]: [[f64; 3]; 3]) -> f64 {
    let to = |p: [f64; 3]| [p[0] - a[0], p[1] - a[1], p[2] - a[2]];
    let (u, v) = (to(b), to(c));
    let cross = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    cross.map(|x| x * x).iter().sum::<f64>().sqrt() / 2.0
}

fn folder() -> PathBuf {
    let beside = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../shared/meshes");
    env::var_os("ONERING_MESHES").map_or(beside, PathBuf::from)
}

fn manifest(folder: &Path) -> Option<Value> {
    let path = folder.join("MANIFEST.json");
    match fs::read_to_string(&path) {
        Ok(text) => Some(serde_json::from_str(&text).expect("a manifest in JSON")),
        Err(error) => {
            assert!(
                env::var_os("ONERING_REQUIRE_MESHES").is_none_or(|x| x != "1"),
                "{}: {error}",
                path.display()
            );
            println!("skipped, {}: {error}", path.display());
            None
        }
    }
}

/// Every figure of the manifest must be there, and equal.
fn compare(name: &str, defects: &Defects, want: &Value) {
    let got: HashMap<_, _> = defects.figures().map(|(figure, value)| (figure, value.to_string())).collect();
    for (figure, value) in want.as_object().expect("figures by name").iter().filter(|(k, _)| *k != "vertices")
    {
        assert_eq!(got.get(figure.as_str()), Some(&value.to_string()), "{figure} of {name}");
    }
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * a.abs().max(b.abs())
}

fn check_repaired(name: &str, mesh: &Mesh, repaired: &Repaired, total: f64) {
    let after = Defects::of(repaired.vertex_count, &repaired.faces);
    assert!(after.manifold && after.is_clean() && after.duplicate_faces == 0, "{name}: {after}");
    let positions = repaired.carry_vertices(&mesh.positions);
    let kept: f64 = repaired.faces.iter().map(|face| area(face.map(|v| positions[v as usize]))).sum();
    let dropped = &repaired.dropped;
    assert_eq!(repaired.faces.len() + dropped.count(), mesh.faces.len(), "{name}");
    let gone = [&dropped.out_of_range, &dropped.degenerate, &dropped.duplicate];
    let gone = mesh.area(gone.into_iter().flatten().copied());
    assert!(close(kept + gone, total), "{name}: area {kept} + {gone} dropped, of {total}");
}

fn check(name: &str, mesh: &Mesh, figures: &Value) {
    let count = mesh.positions.len();
    assert_eq!(
        (count, mesh.faces.len()),
        (number(&figures["vertices"]), number(&figures["triangles"])),
        "{name}"
    );
    compare(name, &Defects::of(count, &mesh.faces), &figures["topology"]);

    let positions = mesh.single_precision();
    let welded = weld(&positions);
    let faces: Vec<_> = mesh.faces.iter().map(|face| face.map(|v| welded.target[v as usize])).collect();
    if figures["welded"].is_object() {
        assert_eq!(welded.source.len(), number(&figures["welded"]["vertices"]), "{name}");
        compare(name, &Defects::of(welded.source.len(), &faces), &figures["welded"]);
    } else {
        assert_eq!(welded.source.len(), count, "{name}: no two vertices share a position");
    }

    let total = figures["area"].as_f64().expect("an area");
    for weld in [None, Some(&positions[..])] {
        let repaired = repair(count, &mesh.faces, &RepairOptions { weld }).expect("no list is beyond repair");
        println!("{name}{}: {repaired}", if weld.is_some() { ", welded" } else { "" });
        check_repaired(name, mesh, &repaired, total);
    }
}

fn number(value: &Value) -> usize {
    value.as_u64().expect("a number").try_into().expect("a small one")
}

#[test]
fn obj_files_have_their_figures_and_are_repaired() {
    let folder = folder();
    let Some(manifest) = manifest(&folder) else { return };
    let mut checked = 0;
    for entry in manifest["files"].as_array().expect("a list of files") {
        let name = entry["file"].as_str().expect("a name");
        if name.ends_with(".obj") {
            check(name, &read_obj(&folder.join(name)), &entry["figures"]);
            checked += 1;
        }
    }
    assert!(checked > 0, "no OBJ file in {}", folder.display());
}

//! Every real file gives the figures of the manifest, which come from an independent reader; every
//! broken one ends as its manifest asks.

mod common;

use serde_json::Value;

#[test]
fn real_files_give_the_figures_of_the_manifest() {
    let Some((folder, entries)) = common::meshes() else { return };
    assert!(entries.len() >= 56, "only {} files", entries.len());
    let files = entries.iter().map(|entry| folder.join(entry["file"].as_str().unwrap()).into_os_string());
    let run = common::onering(["inspect".into(), "--json".into()].into_iter().chain(files));
    assert_eq!((run.code, run.err.as_str()), (Some(0), ""));
    let found = run.json_lines();
    assert_eq!(found.len(), entries.len());
    for (found, entry) in found.iter().zip(&entries) {
        let name = entry["file"].as_str().unwrap();
        // `PLY ascii`, `X3D XML`, `VRML97`.
        let format = found["format"].as_str().unwrap();
        assert!(entry["format"].as_str().unwrap().starts_with(format), "{name}: {format}");
        check(name, found, &entry["figures"]);
    }
}

fn check(name: &str, found: &Value, figures: &Value) {
    for (key, expected) in figures.as_object().unwrap() {
        match key.as_str() {
            "bbox_min" | "bbox_max" | "area" | "signed_volume" => {}
            // Of the inside of a file and not of the mesh in it.
            "stl_corners"
            | "stl_negzero_distinct_vertices"
            | "stl_f64_distinct_vertices"
            | "off_keyword"
            | "face_sets"
            | "tristrips" => {}
            "topology" | "welded" if expected.is_object() => {
                let expected = expected.as_object().unwrap();
                let found = found[key].as_object().unwrap();
                assert_eq!(found, expected, "{name} {key}");
            }
            _ => assert_eq!(&found[key], expected, "{name} {key}"),
        }
    }
    check_floats(name, found, figures);
}

/// The manifest has the file's decimals in 64 bits; here each coordinate was rounded to 32 bits, by at most 6e-8 of
/// itself. An area then differs by no more than its outline times that, a volume by the area times that.
fn check_floats(name: &str, found: &Value, figures: &Value) {
    let number = |value: &Value| value.as_f64().unwrap_or_else(|| panic!("{name}: {value}"));
    let mut extent = 0.0_f64;
    for key in ["bbox_min", "bbox_max"] {
        for i in 0..3 {
            let expected = number(&figures[key][i]);
            let tolerance = 1e-7 * expected.abs();
            assert!((number(&found[key][i]) - expected).abs() <= tolerance, "{name} {key}");
            extent = extent.max(expected.abs());
        }
    }
    let area = number(&figures["area"]);
    let tolerances = [("area", 1e-5 * area), ("signed_volume", 1e-6 * area * extent)];
    for (key, tolerance) in tolerances {
        let difference = (number(&found[key]) - number(&figures[key])).abs();
        assert!(difference <= tolerance, "{name} {key}: off by {difference}, more than {tolerance}");
    }
}

#[test]
fn broken_files_end_as_their_manifest_asks() {
    let Some((folder, entries)) = common::malformed() else { return };
    assert!(entries.len() >= 60, "only {} files", entries.len());
    for entry in &entries {
        let name = entry["file"].as_str().unwrap();
        let path = folder.join(name);
        let run = common::onering_in_little_memory(["inspect".as_ref(), "--json".as_ref(), path.as_os_str()]);
        match (run.code, entry["expect"].as_str().unwrap()) {
            (Some(0), "accept" | "either") => {
                let found = &run.json_lines()[0];
                for figure in ["vertices", "triangles"] {
                    let expected = entry[&format!("{figure}_if_accepted")].as_u64().unwrap_or_default();
                    assert_eq!(found[figure].as_u64(), Some(expected), "{name}");
                }
            }
            (Some(2), "error" | "either") => {
                let folder = path.parent().unwrap().display().to_string();
                assert!(run.err.starts_with(&format!("onering: {folder}")), "{name}: {run:?}");
                assert_eq!((run.err.lines().count(), run.out.as_str()), (1, ""), "{name}: {run:?}");
            }
            _ => panic!("{name}: {run:?}"),
        }
    }
}

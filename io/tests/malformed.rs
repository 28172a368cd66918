//! Broken and hostile files end as their manifest asks.

mod common;

use onering_io::{Error, load};
use serde_json::Value;

#[test]
fn broken_files_end_as_their_manifest_asks() {
    let Some((folder, entries)) = common::malformed() else { return };
    assert!(entries.len() >= 60, "only {} files", entries.len());
    for entry in &entries {
        let (name, path) = common::path_of(&folder, entry);
        let result = load(&path);
        match (&result, entry["expect"].as_str().unwrap()) {
            (Ok(_), "error") => panic!("{name} was accepted"),
            (Err(error), "accept") => panic!("{name} was refused: {error}"),
            (Ok(mesh), _) => check_counts(&name, [mesh.positions.len(), mesh.faces.len()], entry),
            (Err(error), _) => check_error(&name, error, path.to_str().unwrap()),
        }
    }
}

fn check_counts(name: &str, counts: [usize; 2], entry: &Value) {
    let expected = ["vertices_if_accepted", "triangles_if_accepted"].map(|key| entry[key].as_u64());
    // Where the manifest gives no count, the mesh is empty.
    assert_eq!(counts.map(|count| count as u64), expected.map(Option::unwrap_or_default), "{name}");
}

/// One line, which names the file or the one beside it.
fn check_error(name: &str, error: &Error, path: &str) {
    let text = error.to_string();
    let folder = path.rsplit_once('/').unwrap().0;
    assert!(text.starts_with(folder) && !text.contains('\n'), "{name}: {text}");
}

#[test]
fn errors_name_the_line_or_the_element() {
    let Some((folder, _)) = common::malformed() else { return };
    for (name, expected) in [
        ("obj/assimp_malformed.obj", ":23: face names vertex 12, but there are 8"),
        ("obj/tobj_invalid_index.obj", ": face names vertex 7, but there are 6"),
        ("obj/tinyobj_invalid_relative.obj", ":1: face names vertex -4, but there are 0"),
        ("obj/index_zero.obj", ":4: face names vertex 0, but vertices are counted from 1"),
        ("obj/huge_index.obj", "99999999999999999999999, but there are 3"),
        ("gltf/accessor_count_2e31.glb", "mesh 0 primitive 0: accessor 1 needs 25769803764 bytes"),
        ("gltf/index_out_of_range/IndexOutOfRange.gltf", "mesh 0 primitive 0: face names vertex"),
        ("gltf/draco_required.glb", "needs KHR_draco_mesh_compression"),
        ("gltf/missing_bin.gltf", "BoxTextured0.bin: "),
        ("gltf/uri_path_traversal.gltf", "etc/passwd` is not opened: it climbs out of the folder"),
        ("x3d/entity_bomb.x3d", ":2: needs entities of its own"),
        ("x3d/external_entity.x3d", ":2: needs entities of its own"),
        ("x3d/index_out_of_range.x3d", ":2: face names vertex 3, but there are 3"),
        ("x3d/truncated.x3d", ":2: bad XML: "),
        ("x3d/points_not_multiple_of_3.x3d", ":2: a vertex needs 3 coordinates, but has 2"),
        ("x3d/unknown_use.x3d", ":2: USE of `nowhere`, but no Coordinate of that name is defined"),
        ("stl/truncated_binary.stl", ": only 5 of 12 declared triangles are there"),
        ("stl/huge_count.stl", ": only 1 of 4294967295 declared triangles are there"),
        ("stl/ascii_truncated.stl", ":83: the file ends before face "),
        ("stl/short_83.stl", ": this is not an STL file"),
        ("off/index_out_of_range.off", ":6: face names vertex 3, but there are 3"),
        ("off/negative_count.off", ":2: `-3` is not a count"),
        ("off/face_of_1e9.off", ": only 3 of 1000000000 declared corners are there"),
        ("off/assimp_out_of_memory.off", ":2: the file needs 2121211412180 bytes, but there are 309"),
        ("gltf/khr_invalid_version.glb", "version \"0\" is not supported"),
        ("ply/assimp_crash.ply", "` is not a scalar type"),
        ("ply/bad_format_word.ply", ":2: `binary_middle_endian` is not `ascii`, `binary_little_endian` or"),
        ("ply/empty.ply", ":1: this is not a PLY file"),
        ("ply/huge_vertex_count.ply", "byte 214: vertex 3 needs 4 bytes, but there are 0"),
        ("ply/index_out_of_range_le.ply", "face 0 at byte 214: face names vertex 3, but there are 3"),
        ("ply/list_count_beyond_end.ply", "byte 206: face 0 needs 1020 bytes, but there are 12"),
        ("ply/lox_no_vertex_props.ply", ":3: `x` is missing: vertices need x, y and z"),
        ("ply/negative_count.ply", ":3: `-3` is not a count"),
        ("ply/speleo_short_ascii.ply", ":11: the file ends before vertex 2 does"),
    ] {
        let text = load(folder.join(name)).unwrap_err().to_string();
        assert!(text.contains(expected), "{name}: {text}");
    }
}

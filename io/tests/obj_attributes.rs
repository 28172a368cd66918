//! Attributes belong to the faces that `obj::read` gives, and agree with tobj where it reads the file.
#![cfg(feature = "tobj")]

use onering_io::obj_attributes::{Attributes, load, read};
use onering_io::{Error, Place, obj};

const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt .5\nvn 0 0 1\n";

#[test]
fn every_corner_has_its_own() {
    let text = format!(
        "{SQUARE}usemtl a\nf 1/1/1 2/2/1 3/3/1 4/-1/-1\nusemtl b b\nf 1//1 2/2 \\\n3\nf 1 2\nusemtl a\nf 1 2 3"
    );
    let attributes = read(text.as_bytes()).unwrap();
    assert_eq!(obj::read(text.as_bytes()).unwrap().faces.len(), 4);
    let some = |corners: [i64; 3]| corners.map(|index| u32::try_from(index).ok());
    assert_eq!(attributes.corner_texcoords, [[0, 1, 2], [0, 2, 3], [-1, 1, -1], [-1, -1, -1]].map(some));
    assert_eq!(attributes.corner_normals, [[0, 0, 0], [0, 0, 0], [0, -1, -1], [-1, -1, -1]].map(some));
    assert_eq!(attributes.texcoord(1, 2), Some([0.5, 0.0]));
    assert_eq!(attributes.normal(2, 0), Some([0.0, 0.0, 1.0]));
    assert_eq!(
        (attributes.normal(2, 1), attributes.texcoord(9, 0), attributes.normal(0, 3)),
        (None, None, None)
    );
    let names: Vec<_> = (0..4).map(|face| attributes.material(face).unwrap().name.as_str()).collect();
    assert_eq!(names, ["a", "a", "b b", "a"]);
}

#[test]
fn what_is_broken_is_named() {
    for (line, problem) in [
        ("f 1/5 2/1 3/1", "a corner names a texture coordinate or normal beyond the 4 of the file"),
        ("f 1/-5 2/1 3/1", "`1/-5` is not a vertex index"),
        ("f 1/0 2/1 3/1", "`1/0` is not a vertex index"),
        ("f 1/1/1/1 2 3", "`1/1/1/1` is not a vertex index"),
        ("vt", "only 0 numbers"),
        ("vn 1 x 1", "`x` is not a number"),
    ] {
        let error = read(format!("{SQUARE}{line}\n").as_bytes()).unwrap_err();
        assert!(matches!(error, Error::Malformed { place: Place::Line(10), .. }), "{error}");
        assert!(error.to_string().contains(problem), "{error}");
    }
}

#[test]
fn libraries_are_read_beside_the_file_and_nowhere_else() {
    let folder = std::env::temp_dir().join(format!("onering-attributes-{}", std::process::id()));
    std::fs::create_dir_all(&folder).unwrap();
    let path = folder.join("a.obj");
    std::fs::write(folder.join("my lib.mtl"), "newmtl red\nKd 1 0 0\nnewmtl unused\nKd 1 1 1\n").unwrap();
    let text = format!(
        "mtllib my lib.mtl\nmtllib ../x.mtl none.mtl\n{SQUARE}usemtl red\nf 1 2 3\nusemtl no\nf 1 2 3\n"
    );
    std::fs::write(&path, text).unwrap();
    let attributes = load(&path);
    std::fs::remove_dir_all(&folder).unwrap();
    let attributes = attributes.unwrap();
    assert_eq!(attributes.materials.len(), 2);
    assert_eq!(attributes.material(0).unwrap().diffuse, Some([1.0, 0.0, 0.0]));
    assert_eq!(attributes.material(1).unwrap().name, "no");
    let unread: Vec<_> = attributes.unread_libraries.iter().map(Error::to_string).collect();
    assert!(unread[0].contains("`../x.mtl` is not opened") && unread[1].contains("none.mtl: "), "{unread:?}");
}

mod common;

#[test]
fn real_files_agree_with_tobj() {
    let Some((folder, entries)) = common::meshes() else { return };
    let mut compared = 0;
    for entry in entries.iter().filter(|entry| entry["format"] == "OBJ") {
        let (name, path) = common::path_of(&folder, entry);
        let bytes = std::fs::read(path).unwrap();
        let attributes = read(&bytes).unwrap();
        assert_eq!(
            Some(attributes.face_materials.len() as u64),
            entry["figures"]["triangles"].as_u64(),
            "{name}"
        );
        compared += common::tobj_models(&bytes).map_or(0, |models| compare(&name, &attributes, &models));
    }
    assert!(compared > 0);
}

/// Compares corner by corner what tobj has not made up; gives the number of corners that have attributes.
fn compare(name: &str, attributes: &Attributes, models: &[tobj::Model]) -> usize {
    let corners =
        models.iter().flat_map(|model| (0..model.mesh.indices.len()).map(move |i| (&model.mesh, i)));
    let mut compared = 0;
    for (k, (mesh, i)) in corners.enumerate() {
        if let (Some(ours), Some(theirs)) = (attributes.texcoord(k / 3, k % 3), mesh.texcoord_indices.get(i))
        {
            assert_eq!(ours, std::array::from_fn(|c| mesh.texcoords[*theirs as usize * 2 + c]), "{name} {k}");
            compared += 1;
        }
        if let (Some(ours), Some(theirs)) = (attributes.normal(k / 3, k % 3), mesh.normal_indices.get(i)) {
            assert_eq!(ours, std::array::from_fn(|c| mesh.normals[*theirs as usize * 3 + c]), "{name} {k}");
            compared += 1;
        }
    }
    compared
}

//! Primitives to triangles: modes, what is left out, what the triangles come from.

use crate::{POINTS, PRIMITIVE, parse, refusal, square, with};
use onering_io::gltf::BufferKind;
use onering_io::{Reason, Skipped, Triangles};

/// The square's four positions with these faces, out of one primitive in the BIN chunk.
fn square_of(faces: Vec<[u32; 3]>) -> Triangles {
    let mut mesh = Triangles::new(POINTS.into(), faces);
    mesh.gltf = parse(&square(r#"{"attributes": {"POSITION": 0}}"#)).gltf;
    assert_eq!(origin(&mesh), (1, vec![BufferKind::Chunk]));
    mesh
}

/// How many primitives a mesh is from, and in what kinds of buffers they are.
fn origin(mesh: &Triangles) -> (usize, Vec<BufferKind>) {
    let origin = mesh.gltf.clone().unwrap();
    (origin.primitives, origin.buffers.into_iter().collect())
}

#[test]
fn lists_strips_and_fans_are_read() {
    let list = r#"{"attributes": {"POSITION": 0}, "indices": 1}"#;
    assert_eq!(parse(&square(list)), square_of(vec![[0, 1, 2], [2, 1, 3]]));
    for (mode, faces) in [(5, vec![[0, 1, 2], [1, 3, 2]]), (6, vec![[1, 2, 0], [2, 3, 0]])] {
        let mesh = parse(&square(&format!(r#"{{"attributes": {{"POSITION": 0}}, "mode": {mode}}}"#)));
        assert_eq!(mesh, square_of(faces));
    }
    let mesh = parse(&square(r#"{"attributes": {"POSITION": 0}, "indices": 1, "mode": 5}"#));
    assert_eq!(mesh.faces, [[0, 1, 2], [1, 2, 2], [2, 2, 1], [2, 3, 1]]);
}

#[test]
fn every_primitive_brings_its_own_vertices() {
    let list = r#"{"attributes": {"POSITION": 0}, "indices": 1}"#;
    let mesh = parse(&square(&[list; 3].join(",")));
    assert_eq!(mesh.positions.len(), 12);
    assert_eq!(mesh.faces[4..], [[8, 9, 10], [10, 9, 11]]);
    assert_eq!(mesh.polygon_sizes.get(&3), Some(&6));
    assert_eq!(origin(&mesh).0, 3);
}

#[test]
fn what_is_left_out_is_noted() {
    let mesh = parse(&square(
        r#"{"attributes": {"POSITION": 0}, "mode": 0}, {"attributes": {"POSITION": 0}, "mode": 0},
           {"attributes": {"POSITION": 0}, "mode": 9}, {"attributes": {"NORMAL": 0}},
           {"attributes": {"POSITION": 0}}"#,
    ));
    let notes: Vec<_> = mesh.notes.iter().map(|note| (note.what.clone(), note.count)).collect();
    let expected =
        [Skipped::PrimitiveMode(0), Skipped::UnknownModes, Skipped::NoPositions, Skipped::LooseCorners];
    assert_eq!(notes, expected.into_iter().zip([2, 1, 1, 1]).collect::<Vec<_>>());
    let text = "2 primitives of mode 0 (points) skipped, the first at mesh 0 primitive 0";
    assert_eq!(mesh.notes[0].to_string(), text);
    assert_eq!((mesh.positions.len(), mesh.faces.len()), (4, 1));
    // One of five is read.
    assert_eq!(origin(&mesh), (1, vec![BufferKind::Chunk]));
}

#[test]
fn corners_are_checked() {
    let list = r#"{"attributes": {"POSITION": 0}, "indices": 1}"#;
    let mut bytes = square(list);
    let last = bytes.len() - 2;
    bytes[last] = 4;
    assert_eq!(refusal(&bytes), (PRIMITIVE, Reason::IndexOutOfRange { index: "4".into(), vertices: 4 }));
}

#[test]
fn a_mesh_out_of_proportion_is_refused() {
    let zeros = r#"{"componentType": 5126, "count": 4000000000, "type": "VEC3"}"#;
    let (_, reason) = refusal(&with(r#"{"attributes": {"POSITION": 0}}"#, zeros));
    assert!(matches!(reason, Reason::OutOfProportion { .. }), "{reason}");
    // Many primitives on one accessor: their product is what a hostile file is after.
    let zeros = r#"{"componentType": 5126, "count": 500000, "type": "VEC3"}"#;
    let one = r#"{"attributes": {"POSITION": 0}}"#;
    assert_eq!(parse(&with(one, zeros)).positions.len(), 500_000);
    let (_, reason) = refusal(&with(&[one; 100].join(","), zeros));
    assert!(matches!(reason, Reason::OutOfProportion { .. }), "{reason}");
}

//! Primitives to triangles: modes, what is left out, what the triangles come from.

use crate::common::{document, glb};
use crate::{POINTS, PRIMITIVE, parse, refusal, square, with};
use onering_io::gltf::BufferKind;
use onering_io::{Item, Place, Reason, Skipped, Triangles};

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

const INDEXED: &str = r#"{"attributes": {"POSITION": 0}, "indices": 1}"#;

/// A GLB of `primitives` primitives on one list of `vertices` positions and one of `corners` indices, all zero;
/// there are no bytes for them, but `padding` that nothing uses.
fn sharing(primitives: usize, vertices: u64, corners: u64, padding: usize) -> Vec<u8> {
    let members = format!(
        r#""meshes": [{{"primitives": [{}]}}],
        "accessors": [{{"componentType": 5126, "count": {vertices:>9}, "type": "VEC3"}},
                      {{"componentType": 5125, "count": {corners:>9}, "type": "SCALAR"}}]"#,
        vec![INDEXED; primitives].join(",")
    );
    glb(&document(&members), &vec![0; padding])
}

#[test]
fn a_mesh_has_at_most_4_elements_for_each_byte() {
    let bytes = sharing(1, 1, 3, 100_000).len() as u64;
    let mesh = parse(&sharing(1, 3 * bytes, 3 * bytes, 100_000));
    assert_eq!([mesh.positions.len(), mesh.faces.len()], [3 * bytes as usize, bytes as usize]);
    let (place, reason) = refusal(&sharing(1, 3 * bytes + 1, 3 * bytes, 100_000));
    assert_eq!((place, reason), (Place::File, Reason::OutOfProportion { elements: 4 * bytes + 1, bytes }));
    let (_, reason) = refusal(&sharing(1, 3 * bytes, 3 * bytes + 3, 100_000));
    assert_eq!(reason, Reason::OutOfProportion { elements: 4 * bytes + 1, bytes });
}

#[test]
fn a_small_file_may_have_65536_elements() {
    assert_eq!(parse(&sharing(1, 65_536, 0, 0)).positions.len(), 65_536);
    assert!(matches!(refusal(&sharing(1, 65_537, 0, 0)).1, Reason::OutOfProportion { elements: 65_537, .. }));
    assert!(matches!(refusal(&sharing(1, 4_000_000_000, 0, 0)).1, Reason::OutOfProportion { .. }));
    assert_eq!(refusal(&sharing(2, 4_000_000_000, 0, 0)).1, Reason::TooMany);
    assert_eq!(refusal(&sharing(2, 1, 9_000_000_000, 0)).1, Reason::TooMany);
}

/// Many primitives on one accessor: the product is what a hostile file is after. It is told as a whole, so
/// nothing was decoded before.
#[test]
fn shared_accessors_count_as_often_as_they_are_used() {
    let mesh = parse(&sharing(64, 1_000, 30, 1_000));
    assert_eq!([mesh.positions.len(), mesh.faces.len()], [64_000, 640]);
    let (place, reason) = refusal(&sharing(95, 100_000, 300_000, 1_200_000));
    assert!(matches!(reason, Reason::OutOfProportion { elements: 19_000_000, .. }), "{reason}");
    assert_eq!(place, Place::File);
}

/// A sparse part that replaces one element a million times is work that no count of elements sees.
#[test]
fn a_sparse_part_has_no_more_elements_than_its_accessor() {
    let accessor = |count: usize| {
        format!(
            r#"{{"bufferView": 0, "componentType": 5126, "count": 1, "type": "VEC3", "sparse": {{"count": {count},
            "indices": {{"bufferView": 0, "componentType": 5121}}, "values": {{"bufferView": 0}}}}}}"#
        )
    };
    let one = r#"{"attributes": {"POSITION": 0}}"#;
    assert_eq!(parse(&with(one, &accessor(1))).positions.len(), 1);
    let problem = "it replaces more elements than there are";
    assert_eq!(
        refusal(&with(one, &accessor(2))),
        (PRIMITIVE, Reason::BadItem { item: Item::Sparse(0), problem })
    );
}

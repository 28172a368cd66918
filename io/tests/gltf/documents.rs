//! Documents as a whole: containers, extensions, and what has nothing to do with geometry.

use crate::common::document;
use crate::{POINTS, PRIMITIVE, parse, refusal, square, with};
use onering_io::{Error, Format, Item, Place, Reason, Triangles, gltf};

/// A document was read, and no primitive of it.
fn is_empty(mesh: &Triangles) -> bool {
    let origin = Some(gltf::Origin::default());
    *mesh == Triangles { gltf: origin, ..Triangles::default() }
}

#[test]
fn required_extensions_that_change_geometry_are_named() {
    for name in ["KHR_draco_mesh_compression", "EXT_meshopt_compression", "ACME_teapots"] {
        let text = document(&format!(r#""extensionsRequired": ["{name}"]"#));
        let error = gltf::read(text.as_bytes()).unwrap_err();
        assert!(matches!(&error, Error::Unsupported { feature, .. } if feature == name), "{error}");
    }
    let draco = r#"{"attributes": {"POSITION": 0}, "extensions": {"KHR_draco_mesh_compression": {}}}"#;
    assert_eq!(parse(&square(draco)).positions, POINTS);
    let error =
        gltf::read(&with(draco, r#"{"componentType": 5126, "count": 4, "type": "VEC3"}"#)).unwrap_err();
    assert!(matches!(error, Error::Unsupported { place: PRIMITIVE, .. }), "{error}");
}

/// What the model of the crate gltf does not know, or takes too strictly, does not make a file unreadable.
#[test]
fn what_is_not_geometry_may_be_anything() {
    let mesh = parse(&square(
        r#"{"attributes": {"POSITION": 0, "_HEAT": 0, "TEXCOORD_x": 0, "teapot": 0, "": 0}, "indices": 1,
            "extras": 5, "extensions": {"ACME_teapots": [{}]}}"#,
    ));
    assert_eq!((mesh.positions.len(), mesh.faces.len(), mesh.notes.len()), (4, 2, 0));
    let members = r#""scenes": [{}], "animations": [{"samplers": [], "channels": [
        {"sampler": 0, "target": {"path": "pointer"}}]}], "materials": [{"alphaMode": 7}], "extras": "text""#;
    assert!(is_empty(&parse(document(members).as_bytes())));
}

#[test]
fn broken_containers_are_refused() {
    let good = square(r#"{"attributes": {"POSITION": 0}, "indices": 1}"#);
    let patched = |at: usize, byte: u8| {
        let mut bytes = good.clone();
        bytes[at] = byte;
        refusal(&bytes)
    };
    assert_eq!(patched(4, 1), (Place::Byte(4), Reason::Version { version: "1".into() }));
    assert!(matches!(patched(10, 9).1, Reason::TooShort { item: Item::File, .. }));
    assert!(matches!(patched(14, 9).1, Reason::TooShort { item: Item::Chunk(0), .. }));
    assert!(matches!(patched(16, b'X').1, Reason::NotThisFormat { .. }));
    assert!(matches!(refusal(&good[..11]).1, Reason::TooShort { item: Item::Header, .. }));
    assert!(matches!(refusal(b"glTF\x02\0\0\0\x04\0\0\0").1, Reason::TooShort { item: Item::Header, .. }));
    for text in ["", "[]", "{", "{}", r#"{"asset": {}}"#] {
        assert!(matches!(refusal(text.as_bytes()), (Place::File, Reason::Json { .. })), "{text}");
    }
    let old = refusal(br#"{"asset": {"version": "1.0"}}"#);
    assert_eq!(old, (Place::File, Reason::Version { version: "1.0".into() }));
}

#[test]
fn depth_does_not_exhaust_the_stack() {
    let nested = format!("{}{}", "[".repeat(100_000), "]".repeat(100_000));
    assert!(is_empty(&parse(document(&format!(r#""extras": {nested}"#)).as_bytes())));
    let (place, reason) = refusal(document(&format!(r#""meshes": {nested}"#)).as_bytes());
    assert!(place == Place::File && matches!(reason, Reason::Json { .. }), "{reason}");
}

#[test]
fn nodes_are_not_followed() {
    let text = document(r#""scenes": [{"nodes": [0]}], "nodes": [{"children": [1]}, {"children": [0]}]"#);
    assert!(is_empty(&parse(text.as_bytes())));
    assert_eq!(Format::of_content(text.as_bytes()), Some(Format::Gltf));
}

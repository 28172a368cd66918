//! glTF documents and GLB files, written here, and the real ones as the crate gltf reads them.

mod common;

use common::{document, glb, le_bytes};
use onering_io::{Error, Format, Item, Place, Reason, Skipped, Triangles, gltf};

const SQUARE: [f32; 12] = [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 1.0, 1.0, 0.0];
const POINTS: [[f32; 3]; 4] = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [1.0, 1.0, 0.0]];
const PRIMITIVE: Place = Place::Primitive { mesh: 0, primitive: 0 };

/// The square's four positions, then six indices of 16 bits; `primitives` is JSON.
fn square(primitives: &str) -> Vec<u8> {
    with(
        primitives,
        r#"{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3"},
           {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}"#,
    )
}

fn with(primitives: &str, accessors: &str) -> Vec<u8> {
    let members = format!(
        r#""meshes": [{{"primitives": [{primitives}]}}], "accessors": [{accessors}],
           "buffers": [{{"byteLength": 60}}],
           "bufferViews": [{{"buffer": 0, "byteLength": 48}},
                           {{"buffer": 0, "byteOffset": 48, "byteLength": 12}}]"#
    );
    glb(&document(&members), &square_bytes())
}

fn square_bytes() -> Vec<u8> {
    let indices = [0u16, 1, 2, 2, 1, 3].map(u16::to_le_bytes);
    [le_bytes(&SQUARE), indices.concat()].concat()
}

fn parse(bytes: &[u8]) -> Triangles {
    gltf::read(bytes).unwrap_or_else(|error| panic!("{error}"))
}

fn refusal(bytes: &[u8]) -> (Place, Reason) {
    match gltf::read(bytes) {
        Err(Error::Malformed { place, reason, .. }) => (place, reason),
        other => panic!("{other:?}"),
    }
}

#[test]
fn lists_strips_and_fans_are_read() {
    let list = r#"{"attributes": {"POSITION": 0}, "indices": 1}"#;
    assert_eq!(parse(&square(list)), Triangles::new(POINTS.into(), vec![[0, 1, 2], [2, 1, 3]]));
    for (mode, faces) in [(5, vec![[0, 1, 2], [1, 3, 2]]), (6, vec![[1, 2, 0], [2, 3, 0]])] {
        let mesh = parse(&square(&format!(r#"{{"attributes": {{"POSITION": 0}}, "mode": {mode}}}"#)));
        assert_eq!(mesh, Triangles::new(POINTS.into(), faces));
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
}

#[test]
fn strides_offsets_and_sparse_accessors_are_read() {
    // Stride 24 takes every second position; the sparse part replaces the second of these two by the last.
    let members = r#""meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "buffers": [{"byteLength": 60}],
        "bufferViews": [{"buffer": 0, "byteLength": 48, "byteStride": 24}, {"buffer": 0, "byteLength": 60}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 2, "type": "VEC3", "sparse": {
            "count": 1, "indices": {"bufferView": 1, "byteOffset": 50, "componentType": 5123},
            "values": {"bufferView": 1, "byteOffset": 36}}}]"#;
    let mesh = parse(&glb(&document(members), &square_bytes()));
    assert_eq!(mesh.positions, [POINTS[0], POINTS[3]]);
    let mesh =
        parse(&glb(&document(&members.replace(r#""bufferView": 0, "comp"#, r#""comp"#)), &square_bytes()));
    assert_eq!(mesh.positions, [[0.0; 3], POINTS[3]]);
    let (_, reason) =
        refusal(&glb(&document(&members.replace(r#"Offset": 50"#, r#"Offset": 52"#)), &square_bytes()));
    let problem = "it replaces an element beyond the last";
    assert_eq!(reason, Reason::BadItem { item: Item::Sparse(0), problem });
}

#[test]
fn quantised_positions_are_read_where_the_extension_says_so() {
    let members = r#""extensionsRequired": ["KHR_mesh_quantization", "KHR_materials_unlit"],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "buffers": [{"byteLength": 8}], "bufferViews": [{"buffer": 0, "byteLength": 8, "byteStride": 4}],
        "accessors": [{"bufferView": 0, "componentType": 5120, "count": 2, "type": "VEC3"}]"#;
    let bytes = [127, 0, 0x80, 0, 1, 2, 3, 0];
    assert_eq!(parse(&glb(&document(members), &bytes)).positions, [[127.0, 0.0, -128.0], [1.0, 2.0, 3.0]]);
    let normalized = members.replace(r#""VEC3""#, r#""VEC3", "normalized": true"#);
    assert_eq!(parse(&glb(&document(&normalized), &bytes)).positions[0], [1.0, 0.0, -1.0]);
    let (place, reason) =
        refusal(&glb(&document(&members.replace("KHR_mesh_quantization", "KHR_materials_x")), &bytes));
    assert_eq!((place, reason.to_string().contains("KHR_mesh_quantization")), (PRIMITIVE, true));
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

#[test]
fn broken_accessors_are_refused_before_memory_is_taken() {
    let float = r#""componentType": 5126, "type": "VEC3""#;
    let short = |item, needed, available| Reason::TooShort { item, needed, available };
    let none = |item, count| Reason::NoSuchItem { item, count };
    let max = u64::MAX;
    for (accessor, reason) in [
        (format!(r#"{{"bufferView": 0, "count": 5, {float}}}"#), short(Item::Accessor(0), 60, 48)),
        (format!(r#"{{"bufferView": 0, "count": {max}, {float}}}"#), short(Item::Accessor(0), max, 48)),
        (
            format!(r#"{{"bufferView": 0, "count": 4, "byteOffset": {max}, {float}}}"#),
            short(Item::Accessor(0), max, 48),
        ),
        (format!(r#"{{"bufferView": 2, "count": 4, {float}}}"#), none(Item::BufferView(2), 2)),
        (
            format!(r#"{{"bufferView": 4294967295, "count": 4, {float}}}"#),
            none(Item::BufferView(0xFFFF_FFFF), 2),
        ),
    ] {
        let (place, got) = refusal(&with(r#"{"attributes": {"POSITION": 0}}"#, &accessor));
        // More than u32 can count is refused even before its bytes are looked for.
        let got_or_too_many = got == reason || got == Reason::TooMany && accessor.contains(&max.to_string());
        assert!(place == PRIMITIVE && got_or_too_many, "{accessor}: {got}");
    }
    let (_, reason) = refusal(&square(r#"{"attributes": {"POSITION": 7}}"#));
    assert_eq!(reason, none(Item::Accessor(7), 2));
    for accessor in [
        r#"{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC2"}"#,
        r#"{"bufferView": 0, "componentType": 5125, "count": 4, "type": "VEC3"}"#,
        r#"{"bufferView": 0, "componentType": 5130, "count": 4, "type": "VEC3"}"#,
        r#"{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC5"}"#,
    ] {
        let (_, reason) = refusal(&with(r#"{"attributes": {"POSITION": 0}}"#, accessor));
        assert!(matches!(reason, Reason::BadItem { item: Item::Accessor(0), .. }), "{reason}");
    }
}

/// The model of the crate gltf would take 2^32 + n for n. Each of these numbers, so raised, is refused, and
/// so is nothing else: sizes, bounds and extras may be large.
#[test]
fn numbers_beyond_32_bits_do_not_wrap_around() {
    let members = r#""meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "mode": 4}]}],
        "buffers": [{"byteLength": 60}],
        "bufferViews": [{"byteLength": 48, "buffer": 0}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
        "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "max": [4294967296],
            "extras": {"buffer": 4294967296}, "sparse": {
                "count": 1, "indices": {"componentType": 5123, "bufferView": 1}, "values": {"bufferView": 0 }}},
            {"bufferView": 1 , "componentType": 5123 , "count": 6, "type": "SCALAR"}]"#;
    assert_eq!(parse(&glb(&document(members), &square_bytes())).faces.len(), 2);
    for number in [
        r#""POSITION": 0"#,
        r#""indices": 1"#,
        r#""mode": 4"#,
        r#""buffer": 0}"#,
        r#""buffer": 0,"#,
        r#""bufferView": 0,"#,
        r#""bufferView": 1}"#,
        r#""bufferView": 0 "#,
        r#""bufferView": 1 "#,
        r#""componentType": 5126"#,
        r#""componentType": 5123,"#,
        r#""componentType": 5123 "#,
    ] {
        assert_eq!(members.matches(number).count(), 1, "{number}");
        let small: u64 = number.chars().filter(char::is_ascii_digit).collect::<String>().parse().unwrap();
        let raised = number.replace(&small.to_string(), &(small + (1 << 32)).to_string());
        let text = document(&members.replace(number, &raised));
        match refusal(&glb(&text, &square_bytes())) {
            (Place::File, Reason::Json { message }) => {
                assert!(message.contains(&format!("integer `{}`", small + (1 << 32))), "{number}: {message}");
            }
            other => panic!("{number}: {other:?}"),
        }
    }
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
    assert_eq!(parse(document(members).as_bytes()), Triangles::default());
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

/// A document whose one buffer, of 36 bytes, is where `uri` says.
fn triangle_at(uri: &str) -> String {
    document(&format!(
        r#""meshes": [{{"primitives": [{{"attributes": {{"POSITION": 0}}}}]}}],
           "buffers": [{{"byteLength": 36, "uri": "{uri}"}}], "bufferViews": [{{"buffer": 0, "byteLength": 36}}],
           "accessors": [{{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3"}}]"#
    ))
}

#[test]
fn buffers_come_from_data_uris() {
    let zeros = "A".repeat(48);
    let read = |uri: String| gltf::read(triangle_at(&uri).as_bytes());
    assert_eq!(read(format!("data:application/octet-stream;base64,{zeros}")).unwrap().faces, [[0, 1, 2]]);
    assert!(read(format!("data:;base64,{zeros}AA==")).is_ok());
    for (uri, problem) in [
        (format!("data:;base64,{}", &zeros[..44]), "buffer 0 needs 36 bytes, but there are 33"),
        (format!("data:;base64,{}*", &zeros[..47]), "the data URI is not base64"),
        (format!("data:,{zeros}"), "only data URIs in base64 are read"),
        ("data:".into(), "the data URI has no comma"),
        ("a.bin".into(), "bytes in memory have no folder"),
    ] {
        let error = read(uri).unwrap_err();
        assert!(matches!(error, Error::Malformed { place: Place::Buffer(0), .. }), "{error}");
        assert!(error.to_string().contains(problem), "{error}");
    }
}

#[test]
fn buffers_come_from_files_of_the_same_folder_only() {
    let folder = std::env::temp_dir().join(format!("onering-gltf-{}", std::process::id()));
    std::fs::create_dir_all(folder.join("inner/sub dir")).unwrap();
    std::fs::write(folder.join("inner/sub dir/a.bin"), [0; 40]).unwrap();
    std::fs::write(folder.join("outside.bin"), [0; 40]).unwrap();
    let inner = folder.join("inner");
    #[cfg(unix)]
    std::os::unix::fs::symlink("../outside.bin", inner.join("link.bin")).unwrap();
    let read = |uri: &str| gltf::read_beside(triangle_at(uri).as_bytes(), &inner);
    let good = read("sub%20dir/a.bin");
    let bad = [
        "../outside.bin",
        "%2e%2e/outside.bin",
        "/etc/passwd",
        "file:///etc/passwd",
        "http://a/b",
        "link.bin",
    ];
    let bad = bad.map(|uri| (uri, read(uri)));
    let (folder_itself, absent) = (read("sub%20dir"), read("absent.bin"));
    std::fs::remove_dir_all(&folder).unwrap();
    assert_eq!(good.unwrap().positions.len(), 3);
    for (uri, result) in bad {
        let error = result.unwrap_err();
        let refused = matches!(error, Error::Malformed { reason: Reason::Uri { .. }, .. });
        assert!(refused || cfg!(not(unix)) && uri == "link.bin", "{uri}: {error}");
    }
    assert!(folder_itself.unwrap_err().to_string().contains("not a regular file"));
    assert!(matches!(absent.unwrap_err(), Error::Io { path, .. } if path.ends_with("absent.bin")));
}

#[test]
fn depth_does_not_exhaust_the_stack() {
    let nested = format!("{}{}", "[".repeat(100_000), "]".repeat(100_000));
    assert_eq!(parse(document(&format!(r#""extras": {nested}"#)).as_bytes()), Triangles::default());
    let (place, reason) = refusal(document(&format!(r#""meshes": {nested}"#)).as_bytes());
    assert!(place == Place::File && matches!(reason, Reason::Json { .. }), "{reason}");
}

#[test]
fn nodes_are_not_followed() {
    let text = document(r#""scenes": [{"nodes": [0]}], "nodes": [{"children": [1]}, {"children": [0]}]"#);
    assert_eq!(gltf::read(text.as_bytes()).unwrap(), Triangles::default());
    assert_eq!(Format::of_content(text.as_bytes()), Some(Format::Gltf));
}

#[test]
fn real_files_agree_with_the_crate_gltf() {
    let Some((folder, entries)) = common::meshes() else { return };
    let read = entries.iter().filter(|entry| ["glTF", "GLB"].contains(&entry["format"].as_str().unwrap()));
    for entry in read {
        let (name, path) = common::path_of(&folder, entry);
        let (theirs, ours) = (their_positions(&path), onering_io::load(&path).unwrap().positions);
        if let Some(theirs) = theirs {
            assert!(ours == theirs, "{name}");
        }
    }
}

/// The positions by the crate gltf; `None` where a buffer is neither the BIN chunk nor a plain file.
fn their_positions(path: &std::path::Path) -> Option<Vec<[f32; 3]>> {
    let theirs = ::gltf::Gltf::open(path).unwrap();
    let buffer = |buffer: ::gltf::Buffer<'_>| match buffer.source() {
        ::gltf::buffer::Source::Bin => theirs.blob.clone(),
        ::gltf::buffer::Source::Uri(uri) => std::fs::read(path.with_file_name(uri)).ok(),
    };
    let buffers: Vec<Vec<u8>> = theirs.buffers().map(buffer).collect::<Option<_>>()?;
    let primitives = theirs.meshes().flat_map(|mesh| mesh.primitives());
    let positions = primitives.flat_map(|primitive| {
        let reader = primitive.reader(|buffer| buffers.get(buffer.index()).map(Vec::as_slice));
        reader.read_positions().unwrap().collect::<Vec<_>>()
    });
    Some(positions.collect())
}

//! Accessors: strides, sparse parts, quantised positions, and those that leave their buffers.

use crate::common::{document, glb};
use crate::{POINTS, PRIMITIVE, parse, refusal, square, square_bytes, with};
use onering_io::{Item, Place, Reason};

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

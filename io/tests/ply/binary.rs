//! Binary: both byte orders, many rows at a time, and the byte of an error.

use onering_io::{Item, Place, Reason, Skipped};

use super::{FACES, POINTS, VERTICES, binary, point_bytes, read, refused};

fn file(count: usize, faces: &[u8]) -> Vec<u8> {
    binary(&format!("{VERTICES}element face {count}\n{FACES}"), &[point_bytes(), faces.to_vec()].concat())
}

fn face(corners: &[i32]) -> Vec<u8> {
    let bytes = corners.iter().flat_map(|corner| corner.to_le_bytes());
    std::iter::once(corners.len() as u8).chain(bytes).collect()
}

/// Long runs of triangles with others between them: whatever is read at once, nothing is lost.
#[test]
fn triangles_among_other_polygons() {
    let sizes: Vec<usize> = (0..9000).map(|i| if i % 2500 == 1700 || i > 8950 { i % 6 } else { 3 }).collect();
    let polygons: Vec<Vec<i32>> = sizes
        .iter()
        .enumerate()
        .map(|(i, size)| (0..*size).map(|k| ((i + k) % 4) as i32).collect())
        .collect();
    let bytes: Vec<u8> = polygons.iter().flat_map(|polygon| face(polygon)).collect();
    let mesh = read(file(sizes.len(), &bytes));
    let expected: Vec<[u32; 3]> = polygons
        .iter()
        .flat_map(|p| (2..p.len()).map(|k| [p[0], p[k - 1], p[k]].map(|corner| corner as u32)))
        .collect();
    assert_eq!(mesh.positions, POINTS);
    assert_eq!(mesh.faces, expected);
    assert_eq!(mesh.polygon_count(), sizes.iter().filter(|size| **size >= 3).count());
    let counted: Vec<usize> = mesh.polygons().map(|faces| faces.len() + 2).collect();
    assert!(counted.iter().eq(sizes.iter().filter(|size| **size >= 3)));
    let short = sizes.iter().filter(|size| **size < 3).count();
    assert_eq!((mesh.notes[0].what.clone(), mesh.notes[0].count), (Skipped::ShortFaces, short));
}

#[test]
fn the_byte_and_the_face_of_a_bad_index_are_named() {
    let good = face(&[0, 1, 2]).repeat(5000);
    for bad in [4, -1, i32::MIN, i32::MAX] {
        let bytes = [good.clone(), face(&[0, bad, 2]), good.clone()].concat();
        let file = file(10001, &bytes);
        let byte = file.len() - good.len() - 8;
        let expected = Reason::IndexOutOfRange { index: bad.to_string(), vertices: 4 };
        assert_eq!(refused(&file), (Place::ByteIn { item: Item::Face(5000), byte }, expected));
    }
}

#[test]
fn what_ends_too_early_is_named() {
    let whole = file(2, &face(&[0, 1, 2]).repeat(2));
    let start = whole.len() - 13;
    for length in start..whole.len() {
        let (place, reason) = refused(&whole[..length]);
        assert!(matches!(place, Place::Byte(byte) if byte >= start && byte <= length), "{place}");
        assert!(matches!(reason, Reason::TooShort { item: Item::Face(1), .. }), "{reason}");
    }
    let huge = binary(&VERTICES.replace('4', "4000000000"), &point_bytes());
    assert!(matches!(refused(&huge).1, Reason::TooShort { item: Item::Vertex(4), .. }));
    let other = binary("element a 18446744073709551615\nproperty double b\n", &[0; 20]);
    assert!(matches!(refused(&other).1, Reason::TooShort { item: Item::Row { element: 0, row: 2 }, .. }));
}

#[test]
fn a_list_of_negative_length_is_refused() {
    let declarations = format!("{VERTICES}element face 1\nproperty list char int vertex_index\n");
    let file = binary(&declarations, &[point_bytes(), vec![0xFF; 13]].concat());
    let (place, reason) = refused(&file);
    assert_eq!(place, Place::ByteIn { item: Item::Face(0), byte: file.len() - 13 });
    assert_eq!(reason.to_string(), "`-1` is not the length of a list");
}

#[test]
fn doubles_and_large_integers_are_rounded_once() {
    let declarations = "element vertex 1\nproperty double x\nproperty uint y\nproperty int z\n";
    let x = 1.000_000_178_813_934_3_f64;
    let body = [&x.to_le_bytes()[..], &u32::MAX.to_le_bytes(), &i32::MIN.to_le_bytes()].concat();
    assert_eq!(read(binary(declarations, &body)).positions, [[x as f32, 4_294_967_295.0, -2_147_483_648.0]]);
}

#[test]
fn nan_and_infinity_are_kept() {
    let body = [f32::NAN, f32::INFINITY, f32::NEG_INFINITY].map(f32::to_le_bytes).concat();
    let [[x, y, z]] = read(binary(&VERTICES.replace('4', "1"), &body)).positions[..] else { panic!() };
    assert!(x.is_nan() && y == f32::INFINITY && z == f32::NEG_INFINITY);
}

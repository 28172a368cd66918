//! PLY files as they are written, and as the crate ply-rs-bw reads them.

mod arbitrary;

use arbitrary::{AllKinds, Mesh, any_mesh, any_number, bits, finite_number, square};
use onering_io::{Attribute, Format, MeshRef, SaveOptions, Values, write};
use ply_rs_bw::parser::Parser;
use ply_rs_bw::ply::{DefaultElement, Property};
use proptest::prelude::*;

fn ply(mesh: MeshRef<'_>, ascii: bool) -> Vec<u8> {
    let mut options = SaveOptions::default();
    options.ascii = ascii;
    let mut file = Vec::new();
    options.write(&mut file, mesh, Format::Ply).unwrap();
    file
}

fn text(mesh: MeshRef<'_>) -> String {
    String::from_utf8(ply(mesh, true)).unwrap()
}

/// The vertices and faces of the file, by a reader that is not ours.
fn elements(file: &[u8]) -> [Vec<DefaultElement>; 2] {
    let mut payload = Parser::<DefaultElement>::new().read_ply(&mut &file[..]).unwrap().payload;
    ["vertex", "face"].map(|name| payload.swap_remove(name).unwrap_or_default())
}

fn float(element: &DefaultElement, name: &str) -> f32 {
    match element[name] {
        Property::Float(value) => value,
        ref other => panic!("{name}: {other:?}"),
    }
}

fn uchar(element: &DefaultElement, name: &str) -> u8 {
    match element[name] {
        Property::UChar(value) => value,
        ref other => panic!("{name}: {other:?}"),
    }
}

fn rgb(element: &DefaultElement) -> [u8; 3] {
    ["red", "green", "blue"].map(|name| uchar(element, name))
}

/// Polygons and positions agree, so the faces do: each is a fan of its polygon.
fn assert_holds(file: &[u8], mesh: &Mesh) {
    let [vertices, faces] = elements(file);
    let positions: Vec<_> = vertices.iter().map(|v| ["x", "y", "z"].map(|name| float(v, name))).collect();
    assert_eq!(bits(&positions), bits(&mesh.positions));
    let mut triangles = Vec::new();
    let mut starts = Vec::new();
    for face in &faces {
        let corners = face["vertex_indices"].to_u32_list().unwrap();
        starts.push(triangles.len() as u32);
        triangles.extend((2..corners.len()).map(|i| [corners[0], corners[i - 1], corners[i]]));
    }
    assert_eq!(triangles, mesh.faces);
    assert_eq!((starts.len() < triangles.len()).then_some(starts), mesh.polygon_starts);
}

fn assert_has_values(element: &DefaultElement, values: &AllKinds, i: usize) {
    assert_eq!(bits(&[[float(element, "height"); 3]]), bits(&[[values.scalars[i]; 3]]));
    assert_eq!(element["component"], Property::UInt(values.labels[i]));
    assert_eq!(uchar(element, "on_boundary"), u8::from(values.flags[i]));
}

#[test]
fn text_is_what_the_eye_expects() {
    let flags = [true, false, false, true];
    let attributes = [Attribute { name: "odd", values: Values::Flags(&flags) }];
    let expected = "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
        property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar odd\n\
        element face 1\nproperty list uchar int vertex_indices\nend_header\n\
        0.0 0.0 0.0 213 94 0 1\n1.0 0.0 0.0 204 204 204 0\n1.0 1.0 0.0 204 204 204 0\n0.0 1.0 0.0 213 94 0 1\n\
        4 0 1 2 3\n";
    assert_eq!(text(square().as_ref().with_vertex_attributes(&attributes)), expected);
}

#[test]
fn binary_is_bytes_after_the_header() {
    let file = ply(square().as_ref(), false);
    let header = b"ply\nformat binary_little_endian 1.0\nelement vertex 4\n";
    assert!(file.starts_with(header));
    let end = file.windows(11).position(|bytes| bytes == b"end_header\n").unwrap() + 11;
    let numbers = square().positions.into_iter().flatten().flat_map(f32::to_le_bytes);
    let corners = [0u32, 1, 2, 3].into_iter().flat_map(u32::to_le_bytes);
    assert_eq!(file[end..], numbers.chain([4]).chain(corners).collect::<Vec<u8>>());
}

#[test]
fn nothing_is_a_file_too() {
    for ascii in [true, false] {
        assert_holds(&ply(MeshRef::default(), ascii), &Mesh::default());
    }
}

#[test]
fn polygons_of_more_than_255_corners_have_a_longer_count() {
    for (corners, size) in [(255, "uchar"), (256, "int")] {
        let positions = vec![[0.5; 3]; corners];
        let faces: Vec<_> = (2..corners as u32).map(|i| [0, i - 1, i]).collect();
        let mesh = Mesh { positions, faces, polygon_starts: Some(vec![0]) };
        let declared = format!("property list {size} int vertex_indices");
        assert!(text(mesh.as_ref()).contains(&declared));
        assert_holds(&ply(mesh.as_ref(), true), &mesh);
        assert_holds(&ply(mesh.as_ref(), false), &mesh);
    }
}

#[test]
fn faces_with_values_are_triangles() {
    let labels = [7, 8];
    let attributes = [Attribute { name: "component", values: Values::Labels(&labels) }];
    let file = ply(square().as_ref().with_face_attributes(&attributes), false);
    assert_holds(&file, &Mesh { polygon_starts: None, ..square() });
    let [_, faces] = elements(&file);
    assert_eq!([&faces[0]["component"], &faces[1]["component"]], [&Property::UInt(7), &Property::UInt(8)]);
    assert_ne!(rgb(&faces[0]), rgb(&faces[1]));
}

#[test]
fn names_that_are_taken_get_a_number() {
    let scalars = [0.0; 4];
    let values = Values::Scalars(&scalars);
    let attributes = ["x", "red", "a b", "a_b"].map(|name| Attribute { name, values });
    let text = text(square().as_ref().with_vertex_attributes(&attributes));
    for name in ["x_2", "red_2", "a_b", "a_b_2"] {
        assert!(text.contains(&format!("property float {name}\n")), "{text}");
    }
}

#[test]
fn colours_follow_the_first_attribute() {
    let (scalars, flags) = ([0.0, 1.0, f32::NAN, 0.5], [true; 4]);
    let attributes = [
        Attribute { name: "height", values: Values::Scalars(&scalars) },
        Attribute { name: "set", values: Values::Flags(&flags) },
    ];
    let [vertices, _] = elements(&ply(square().as_ref().with_vertex_attributes(&attributes), false));
    let colours: Vec<_> = vertices.iter().map(rgb).collect();
    assert_eq!(colours, [[68, 1, 84], [253, 231, 37], [128; 3], [33, 144, 140]]);
}

#[test]
fn numbers_that_are_none_are_words() {
    let positions = [[f32::NAN, f32::INFINITY, f32::NEG_INFINITY], [-0.0, f32::from_bits(1), f32::MAX]];
    assert!(text(MeshRef::new(&positions, &[])).ends_with("\nNaN inf -inf\n-0.0 1e-45 3.4028235e+38\n"));
}

fn check_another_reader(mesh: Mesh, numbers: &[u32], number: fn(u32) -> f32, ascii: bool) {
    let vertices = AllKinds::of(numbers, mesh.positions.len(), number);
    let with_values = vertices.attributes();
    let file = ply(mesh.as_ref().with_vertex_attributes(&with_values), ascii);
    assert_holds(&file, &mesh);
    elements(&file)[0].iter().enumerate().for_each(|(v, vertex)| assert_has_values(vertex, &vertices, v));

    let faces = AllKinds::of(numbers, mesh.faces.len(), number);
    let with_values = faces.attributes();
    let file = ply(mesh.as_ref().with_face_attributes(&with_values), ascii);
    assert_holds(&file, &Mesh { polygon_starts: None, ..mesh });
    elements(&file)[1].iter().enumerate().for_each(|(f, face)| assert_has_values(face, &faces, f));
}

proptest! {
    #[test]
    fn another_reader_finds_the_same_mesh_in_bytes(
        mesh in any_mesh(any_number().boxed()),
        numbers in prop::collection::vec(any::<u32>(), 1..9),
    ) {
        check_another_reader(mesh, &numbers, f32::from_bits, false);
    }

    /// That reader knows no `inf` and no `nan` in text.
    #[test]
    fn another_reader_finds_the_same_mesh_in_text(
        mesh in any_mesh(finite_number().boxed()),
        numbers in prop::collection::vec(any::<u32>(), 1..9),
    ) {
        check_another_reader(mesh, &numbers, |n| f32::from_bits(n >> 2), true);
    }

    #[test]
    fn obj_is_read_as_it_was_written(mesh in any_mesh(any_number().boxed())) {
        let mut file = Vec::new();
        write(&mut file, mesh.as_ref(), Format::Obj).unwrap();
        let read = onering_io::read_as(&file, Format::Obj).unwrap();
        mesh.assert_eq(&read);
        prop_assert!(mesh.positions.is_empty() || onering_io::read(&file).unwrap().faces == read.faces);
    }
}

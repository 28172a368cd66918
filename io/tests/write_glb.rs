//! GLB files as they are written, and as the crate gltf reads and checks them.

mod arbitrary;

use arbitrary::{AllKinds, Mesh, any_mesh, bits, finite_number, square};
use gltf::{Gltf, Semantic};
use onering_io::{Attribute, Error, Format, MeshRef, Place, Reason, Skipped, Triangles, Values, write};
use proptest::prelude::*;

fn glb(mesh: MeshRef<'_>) -> Vec<u8> {
    let mut file = Vec::new();
    write(&mut file, mesh, Format::Glb).unwrap();
    file
}

fn refusal(mesh: MeshRef<'_>) -> (Place, Reason, usize) {
    let mut file = Vec::new();
    match write(&mut file, mesh, Format::Glb) {
        Err(Error::Malformed { format: Format::Glb, place, reason, .. }) => (place, reason, file.len()),
        other => panic!("{other:?}"),
    }
}

fn load(file: &[u8]) -> Triangles {
    onering_io::read(file).unwrap()
}

/// What the crate gltf finds in the one primitive; it checks the whole document first.
struct Primitive {
    positions: Vec<[f32; 3]>,
    bounds: [[f32; 3]; 2],
    indices: Option<Vec<u32>>,
    colours: Vec<[u16; 4]>,
    custom: Vec<(String, Vec<f32>)>,
}

fn primitive(file: &[u8]) -> Primitive {
    let Gltf { document, blob } = Gltf::from_slice(file).unwrap();
    let blob = blob.unwrap();
    let mesh = document.meshes().next().unwrap();
    let primitive = mesh.primitives().next().unwrap();
    let reader = primitive.reader(|_| Some(&blob));
    let box_ = primitive.bounding_box();
    let custom = primitive.attributes().filter_map(|(semantic, accessor)| {
        let Semantic::Extras(name) = semantic else { return None };
        let start = accessor.view().unwrap().offset();
        let bytes = blob[start..].as_chunks::<4>().0.iter().take(accessor.count());
        // The crate takes off the underscore.
        Some((name, bytes.map(|bytes| f32::from_le_bytes(*bytes)).collect()))
    });
    Primitive {
        positions: reader.read_positions().unwrap().collect(),
        bounds: [box_.min, box_.max],
        indices: reader.read_indices().map(|indices| indices.into_u32().collect()),
        colours: reader.read_colors(0).map(|all| all.into_rgba_u16().collect()).unwrap_or_default(),
        custom: custom.collect(),
    }
}

/// The least and the largest of each coordinate.
fn bounds(positions: &[[f32; 3]]) -> [[f32; 3]; 2] {
    let of = |start: f32, choose: fn(f32, f32) -> f32| {
        std::array::from_fn(|c| positions.iter().map(|position| position[c]).fold(start, choose))
    };
    [of(f32::INFINITY, f32::min), of(f32::NEG_INFINITY, f32::max)]
}

fn custom<'a>(primitive: &'a Primitive, name: &str) -> &'a [f32] {
    let found = primitive.custom.iter().find(|(other, _)| other == name);
    &found.unwrap_or_else(|| panic!("no {name} in {:?}", primitive.custom)).1
}

#[test]
fn the_container_is_aligned_and_its_lengths_are_true() {
    // Three indices of two bytes: the buffer has to be filled up.
    let file = glb(MeshRef::new(&[[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], &[[0, 1, 2]]));
    let number = |at: usize| u32::from_le_bytes(file[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!((&file[..4], number(4), number(8)), (&b"glTF"[..], 2, file.len()));
    let json = number(12);
    assert_eq!((json % 4, &file[16..20]), (0, &b"JSON"[..]));
    let bin = number(20 + json);
    assert_eq!((bin, &file[24 + json..28 + json]), (36 + 6 + 2, &b"BIN\0"[..]));
    assert_eq!(file.len(), 28 + json + bin);
    assert_eq!(file[file.len() - 8..], [0, 0, 1, 0, 2, 0, 0, 0]);
}

#[test]
fn indices_are_as_short_as_they_can_be_and_never_restart() {
    for (count, kind) in [(65_535, "U16"), (65_536, "U32")] {
        let positions = vec![[0.5; 3]; count];
        let faces = [[0, 1, count as u32 - 1]];
        let file = glb(MeshRef::new(&positions, &faces));
        let document = Gltf::from_slice(&file).unwrap().document;
        let indices = document.accessors().last().unwrap();
        assert_eq!(format!("{:?}", indices.data_type()), kind);
        assert_eq!(load(&file).faces, faces);
    }
}

#[test]
fn a_mesh_without_vertices_is_a_document_without_meshes() {
    let file = glb(MeshRef::default());
    assert_eq!(load(&file).positions.len(), 0);
    assert_eq!(Gltf::from_slice(&file).unwrap().meshes().len(), 0);
}

#[test]
fn a_mesh_without_faces_is_points() {
    let values = AllKinds::of(&[1, 2], 4, |n| n as f32);
    let none = AllKinds::of(&[], 0, |n| n as f32);
    let (vertices, faces) = (values.attributes(), none.attributes());
    let points = Mesh { faces: Vec::new(), polygon_starts: None, ..square() };
    let mesh = points.as_ref().with_vertex_attributes(&vertices).with_face_attributes(&faces);
    let file = glb(mesh);
    let found = primitive(&file);
    assert_eq!((&found.positions, found.indices), (&points.positions, None));
    assert_eq!(found.custom.len(), 3);
    assert_eq!(load(&file).notes[0].what, Skipped::PrimitiveMode(0));
}

#[test]
fn what_is_not_finite_is_refused_before_anything_is_written() {
    let face = [[0, 1, 2]];
    for bad in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY] {
        let positions = [[0.0; 3], [1.0; 3], [2.0; 3], [0.0, bad, 0.0]];
        let reason = Reason::NotFinite { what: "position".into() };
        assert_eq!(refusal(MeshRef::new(&positions, &face)), (Place::Vertex(3), reason, 0));

        let finite = [[0.0; 3]; 4];
        let scalars = [0.0, bad, 0.0, 0.0];
        let attributes = [Attribute { name: "height", values: Values::Scalars(&scalars) }];
        let reason = Reason::NotFinite { what: "_HEIGHT".into() };
        let mesh = MeshRef::new(&finite, &face).with_vertex_attributes(&attributes);
        assert_eq!(refusal(mesh), (Place::Vertex(1), reason.clone(), 0));

        let scalars = [bad];
        let attributes = [Attribute { name: "height", values: Values::Scalars(&scalars) }];
        let mesh = MeshRef::new(&positions, &face).with_face_attributes(&attributes);
        // The vertex that is in no face is not written, so it may be what it likes.
        assert_eq!(refusal(mesh), (Place::Face(0), reason, 0));
    }
    let mut none = Vec::new();
    let error = write(&mut none, MeshRef::new(&[[f32::NAN; 3]], &[]), Format::Glb).unwrap_err();
    assert_eq!(error.to_string(), "GLB vertex 0: position is not finite, which the format does not allow");
}

#[test]
fn colours_are_linear_light() {
    let flags = [true, false, false, true];
    let attributes = [Attribute { name: "set", values: Values::Flags(&flags) }];
    let found = primitive(&glb(square().as_ref().with_vertex_attributes(&attributes)));
    // Of sRGB 213, 94, 0 and 204: by hand, ((x / 255 + 0.055) / 1.055)^2.4 of 65535.
    let (set, unset) = ([43_545, 7_339, 0, 65_535], [39_575, 39_575, 39_575, 65_535]);
    let near = |a: &[u16; 4], b: &[u16; 4]| a.iter().zip(b).all(|(a, b)| a.abs_diff(*b) <= 64);
    let colours = &found.colours;
    assert!(near(&colours[0], &set) && near(&colours[1], &unset), "{colours:?}");
    assert_eq!((colours[2], colours[3]), (colours[1], colours[0]));
    assert_eq!(custom(&found, "SET"), [1.0, 0.0, 0.0, 1.0]);
}

#[test]
fn faces_with_values_have_vertices_of_their_own() {
    let (labels, heights) = ([3, 4], [0.0, 1.0, 2.0, 3.0]);
    let of_faces = [Attribute { name: "part", values: Values::Labels(&labels) }];
    let of_vertices = [Attribute { name: "Part", values: Values::Scalars(&heights) }];
    let mesh = square();
    let file = glb(mesh.as_ref().with_face_attributes(&of_faces));
    let found = primitive(&file);
    let corners: Vec<_> = mesh.faces.as_flattened().iter().map(|c| mesh.positions[*c as usize]).collect();
    assert_eq!((&found.positions, &found.indices), (&corners, &None));
    assert_eq!(custom(&found, "PART"), [3.0, 3.0, 3.0, 4.0, 4.0, 4.0]);
    let colours = &found.colours;
    assert!(colours[0] == colours[2] && colours[2] != colours[3] && colours[3] == colours[5]);
    assert_eq!(load(&file).faces, [[0, 1, 2], [3, 4, 5]]);

    // The colours are those of the vertices where both have values.
    let both = mesh.as_ref().with_face_attributes(&of_faces).with_vertex_attributes(&of_vertices);
    let found = primitive(&glb(both));
    assert_eq!(custom(&found, "PART"), [0.0, 1.0, 2.0, 0.0, 2.0, 3.0]);
    assert_eq!(custom(&found, "PART_2"), [3.0, 3.0, 3.0, 4.0, 4.0, 4.0]);
    let colours = &found.colours;
    assert!(colours[0] == colours[3] && colours[0] != colours[1] && colours[2] == colours[4]);
}

proptest! {
    #[test]
    fn what_is_written_is_read_and_valid(
        mesh in any_mesh(finite_number().boxed()),
        numbers in prop::collection::vec(any::<u32>(), 1..9),
    ) {
        prop_assume!(!mesh.faces.is_empty());
        let values = AllKinds::of(&numbers, mesh.positions.len(), |n| n as f32);
        let attributes = values.attributes();
        let file = glb(mesh.as_ref().with_vertex_attributes(&attributes));
        mesh.assert_eq_but_polygons(&load(&file));
        let found = primitive(&file);
        prop_assert_eq!(bits(&found.positions), bits(&mesh.positions));
        prop_assert_eq!(found.bounds, bounds(&mesh.positions));
        prop_assert_eq!(found.indices.as_deref(), Some(mesh.faces.as_flattened()));
        prop_assert_eq!(custom(&found, "HEIGHT"), &values.scalars);
        prop_assert!(custom(&found, "COMPONENT").iter().zip(&values.labels).all(|(a, b)| *a == *b as f32));
        prop_assert!(custom(&found, "ON_BOUNDARY").iter().zip(&values.flags).all(|(a, b)| (*a == 1.0) == *b));
    }
}

//! STL files by topic, read and written.

use onering_io::{
    Error, Format, Item, MeshRef, Options, Place, Reason, Skipped, Triangles, read, read_as, write,
};
use proptest::prelude::*;

/// A binary file of these triangles, under this header.
fn binary(header: &str, triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
    let mut file = header.as_bytes().to_vec();
    file.resize(80, 0);
    file.extend((triangles.len() as u32).to_le_bytes());
    for triangle in triangles {
        file.extend([0xFF; 12]);
        triangle.as_flattened().iter().for_each(|x| file.extend(x.to_le_bytes()));
        file.extend([0xAB, 0xCD]);
    }
    file
}

const SQUARE: [[[f32; 3]; 3]; 2] =
    [[[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]], [[0.0; 3], [1.0, 1.0, 0.0], [0.0, 1.0, -0.0]]];

fn unwelded(file: &[u8]) -> Triangles {
    let mut options = Options::default();
    options.weld_stl = false;
    options.read(file).unwrap()
}

fn refused(file: &[u8]) -> (Place, Reason) {
    match read_as(file, Format::Stl) {
        Err(Error::Malformed { format: Format::Stl, place, reason, .. }) => (place, reason),
        other => panic!("{other:?}"),
    }
}

#[test]
fn corners_are_welded_unless_told_otherwise() {
    let file = binary("", &SQUARE);
    let mesh = read(&file).unwrap();
    assert_eq!(mesh.positions, [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]]);
    assert_eq!((mesh.faces, mesh.notes), (vec![[0, 1, 2], [0, 2, 3]], vec![]));
    let soup = unwelded(&file);
    assert_eq!((&soup.positions[..], &soup.faces[..]), (SQUARE.as_flattened(), &[[0, 1, 2], [3, 4, 5]][..]));
}

#[test]
fn both_zeros_are_one_and_nan_is_none() {
    let nan = [f32::NAN, 0.0, 0.0];
    let mesh = read(&binary("", &[[[0.0; 3], [-0.0, 0.0, 0.0], nan], [[0.0; 3], nan, [1.0; 3]]])).unwrap();
    assert_eq!(mesh.faces, [[0, 0, 1], [0, 2, 3]]);
}

/// The length decides, whatever the header looks like.
#[test]
fn headers_that_look_like_other_formats() {
    for header in [
        "solid a",
        "v 1 2 3\n",
        "o cube\n",
        "{\"asset\": 1}",
        "OFF\n",
        "# OBJ\n",
        "  \n",
        "ply\n",
        "\u{FEFF}",
    ] {
        let file = binary(header, &SQUARE);
        assert_eq!(Format::of_content(&file), Some(Format::Stl), "{header}");
        assert_eq!(read(&file).unwrap().faces.len(), 2, "{header}");
    }
    // A GLB is one even where its last bytes, all zero, would make an STL file of no triangle.
    let mut glb = b"glTF\x02\0\0\0\x54\0\0\0".to_vec();
    glb.resize(84, 0);
    assert_eq!(Format::of_content(&glb), Some(Format::Glb));
}

#[test]
fn bytes_behind_the_last_triangle_are_skipped_with_a_note() {
    for header in ["", "solid"] {
        let mut file = binary(header, &SQUARE);
        file.extend([1; 51]);
        let mesh = read_as(&file, Format::Stl).unwrap();
        assert_eq!(mesh.faces.len(), 2);
        let [note] = &mesh.notes[..] else { panic!("{:?}", mesh.notes) };
        assert_eq!((&note.what, note.count, note.first), (&Skipped::TrailingBytes, 51, Place::Byte(184)));
        assert_eq!(note.to_string(), "51 bytes behind the last element skipped, the first at byte 184");
    }
}

#[test]
fn missing_triangles_are_counted() {
    for header in ["", "solid"] {
        let file = binary(header, &SQUARE);
        for length in 84..file.len() {
            let missing = Reason::Missing { what: "triangles", declared: 2, present: (length - 84) / 50 };
            assert_eq!(refused(&file[..length]), (Place::File, missing), "{length}");
        }
    }
    assert!(matches!(refused(&binary("", &SQUARE)[..83]), (Place::File, Reason::NotThisFormat { .. })));
    assert!(matches!(refused(b""), (Place::File, Reason::NotThisFormat { .. })));
}

const FACET: &str =
    "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nendloop\nendfacet\n";

#[test]
fn ascii_in_any_case_and_shape() {
    let file = format!("solid facet vertex\n{FACET}endsolid facet vertex\n");
    for text in [
        file.clone(),
        file.to_uppercase(),
        file.replace('\n', "\r\n"),
        file.replace('\n', "\r"),
        file.replace('\n', "\n\n \t"),
        format!("\u{FEFF} \n{file}"),
        format!("solid\n{}", FACET.replace([' ', '\n'], "\n\t")),
        format!("Solid\n{}", FACET.replace('\n', " ")),
        format!("solid\n{}", FACET.replace("0 0 1\n", "-nan(ind) -1.#IND 1\n")),
        format!("solid\n{}", FACET.replace("normal 0 0 1", "normal")),
        format!("solid\n{}", FACET.replace("facet normal 0 0 1", "")),
        format!("solid\nendsolid\nsolid vertex\n{FACET}endsolid\nsolid\n"),
    ] {
        let mesh = read(text.as_bytes()).unwrap_or_else(|error| panic!("{error}: {text}"));
        assert_eq!(mesh.positions, [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]], "{text}");
        assert_eq!((mesh.faces, mesh.notes), (vec![[0, 1, 2]], vec![]), "{text}");
    }
    assert_eq!(read(b"solid\nendsolid").unwrap(), Triangles::default());
}

#[test]
fn several_solids_are_one_mesh() {
    let other = FACET.replace("1 0 0", "0 1 0");
    let text = format!("solid a\n{FACET}endsolid a\nsolid b c\n{other}endsolid\n");
    assert_eq!(read(text.as_bytes()).unwrap().faces, [[0, 1, 2], [0, 3, 2]]);
    assert_eq!(unwelded(text.as_bytes()).faces, [[0, 1, 2], [3, 4, 5]]);
}

#[test]
fn unknown_lines_are_skipped_with_a_note() {
    let text = format!("solid\ncolor vertex 1\n{FACET}# vertex\n");
    let mesh = read(text.as_bytes()).unwrap();
    assert_eq!(mesh.faces.len(), 1);
    assert_eq!((&mesh.notes[0].what, mesh.notes[0].count), (&Skipped::UnknownStatements, 2));
    assert!(matches!(refused(b"solid\nrock\n"), (Place::Line(2), Reason::NotThisFormat { .. })));
}

#[test]
fn ascii_errors_name_the_line() {
    let solid = |facet: String| format!("solid\n{facet}");
    for (text, line, reason) in [
        (FACET.replace("vertex 1 1 0\n", ""), 6, Reason::LoopSize { found: 2 }),
        (FACET.replace("endloop", "vertex 2 2 2\nendloop"), 8, Reason::LoopSize { found: 4 }),
        (FACET.replace("1 1 0", "1 x 0"), 6, Reason::BadNumber { word: "x".into() }),
        (FACET.replace("endloop\nendfacet\n", ""), 6, Reason::Ends { item: Item::Face(0) }),
        (FACET.replace(" 1 0\nendloop\nendfacet\n", ""), 6, Reason::TooFewCoordinates { found: 1 }),
    ] {
        let (place, found) = refused(solid(text.clone()).as_bytes());
        assert_eq!(found, reason, "{text}");
        assert!(matches!(place, Place::Line(l) if l.abs_diff(line) <= 1), "{text}: {place}");
    }
}

#[test]
fn normals_are_computed() {
    let positions = [[0.0; 3], [2e-30, 0.0, 0.0], [0.0, 3e-30, 0.0], [3e38, 0.0, 0.0], [0.0, 0.0, 3e38]];
    let mut file = Vec::new();
    write(&mut file, MeshRef::new(&positions, &[[0, 1, 2], [0, 3, 4], [0, 1, 1]]), Format::Stl).unwrap();
    assert_eq!(file.len(), 84 + 3 * 50);
    assert!(!file.starts_with(b"solid"));
    let normal = |f: usize| -> Vec<f32> {
        let bytes = file[84 + 50 * f..].as_chunks().0;
        bytes[..3].iter().map(|bytes| f32::from_le_bytes(*bytes)).collect()
    };
    assert_eq!([normal(0), normal(1), normal(2)], [[0.0, 0.0, 1.0], [0.0, -1.0, 0.0], [0.0; 3]]);
}

fn bits(positions: impl IntoIterator<Item = [f32; 3]>) -> Vec<[u32; 3]> {
    positions.into_iter().map(|p| p.map(f32::to_bits)).collect()
}

proptest! {
    /// Any bits of any float, and faces with all kinds of defects.
    #[test]
    fn corners_come_back_to_the_bit(
        positions in prop::collection::vec(prop::array::uniform3(any::<u32>().prop_map(f32::from_bits)), 1..20),
        corners in prop::collection::vec(prop::array::uniform3(any::<prop::sample::Index>()), 0..40),
    ) {
        let faces: Vec<_> = corners.iter().map(|face| face.map(|i| i.index(positions.len()) as u32)).collect();
        let mut file = Vec::new();
        write(&mut file, MeshRef::new(&positions, &faces), Format::Stl).unwrap();
        let corners = bits(faces.as_flattened().iter().map(|v| positions[*v as usize]));
        prop_assert_eq!(bits(unwelded(&file).positions), corners);
        let welded = read(&file).unwrap();
        for (corner, v) in welded.faces.as_flattened().iter().zip(faces.as_flattened()) {
            let (read, written) = (welded.positions[*corner as usize], positions[*v as usize]);
            prop_assert!(read == written || bits([read]) == bits([written]));
        }
    }

    #[test]
    fn no_bytes_make_a_reader_panic(bytes: Vec<u8>, ascii in r"solid( |\n|facet|normal|outer|loop|vertex|endloop|-?[0-9.]{1,3}){0,40}") {
        let _ = (read_as(&bytes, Format::Stl), read_as(ascii.as_bytes(), Format::Stl));
    }
}

//! `OFF BINARY`: variants, counts that lie, and cuts.

use onering_io::{Error, Format, Item, Place, Reason, Skipped, read, read_as};
use proptest::prelude::*;

const SQUARE: [[f32; 3]; 4] = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.5]];

/// A header, integers, then vertices of these numbers, then faces.
fn file(header: &str, counts: &[i32], vertices: &[f32], faces: &[i32]) -> Vec<u8> {
    let numbers = counts.iter().map(|i| i.to_be_bytes());
    let numbers = numbers.chain(vertices.iter().map(|x| x.to_be_bytes()));
    let numbers = numbers.chain(faces.iter().map(|i| i.to_be_bytes()));
    [header.as_bytes(), &numbers.flatten().collect::<Vec<u8>>()].concat()
}

fn square(header: &str, extra: usize) -> Vec<u8> {
    let vertices: Vec<f32> = SQUARE.iter().flat_map(|p| [p.to_vec(), vec![9.0; extra]].concat()).collect();
    file(header, &[4, 1, -7], &vertices, &[4, 0, 1, 2, 3, 0])
}

fn check_square(bytes: &[u8], header: &str) {
    let mesh = read(bytes).unwrap_or_else(|error| panic!("{error}: {header}"));
    assert_eq!((mesh.positions, mesh.faces), (SQUARE.to_vec(), vec![[0, 1, 2], [0, 2, 3]]), "{header}");
    assert_eq!((mesh.polygon_sizes, mesh.notes), ([(4, 1)].into(), vec![]), "{header}");
}

fn refused(bytes: &[u8]) -> (Place, Reason) {
    match read_as(bytes, Format::Off) {
        Err(Error::Malformed { format: Format::Off, place, reason, .. }) => (place, reason),
        other => panic!("{other:?}"),
    }
}

#[test]
fn headers() {
    for (keyword, extra) in [("", 0), ("N", 3), ("C", 4), ("ST", 2), ("CN", 7), ("STCN", 9), ("NCST", 9)] {
        for end in ["OFF BINARY\n", "OFF BINARY\r\n", "OFF  BINARY \t\n"] {
            let header = format!("# c\n{keyword}{end}");
            check_square(&square(&header, extra), &header);
            assert_eq!(Format::of_content(header.as_bytes()), Some(Format::Off));
        }
    }
    for end in ["", " ", "x", " # c\n", "\r"] {
        let (place, reason) = refused(format!("OFF BINARY{end}").as_bytes());
        let is_word = matches!(reason, Reason::BadWord { .. }) && matches!(place, Place::Byte(_));
        assert!(is_word || end == "x", "{end}: {reason}");
    }
}

#[test]
fn homogeneous_coordinates_and_dimensions() {
    let last = SQUARE.map(|[x, y, z]| [2.0 * x, 2.0 * y, 2.0 * z, 2.0]);
    let first = SQUARE.map(|[x, y, z]| [-4.0, -4.0 * x, -4.0 * y, -4.0 * z]);
    let face = [4, 0, 1, 2, 3, 0];
    check_square(&file("4OFF BINARY\n", &[4, 1, 0], last.as_flattened(), &face), "4OFF");
    check_square(&file("4nOFF BINARY\n", &[3, 4, 1, 0], first.as_flattened(), &face), "4nOFF");
    check_square(&file("4nOFF 3 BINARY\n", &[4, 1, 0], first.as_flattened(), &face), "4nOFF 3");
    check_square(&file("nOFF BINARY\n", &[3, 4, 1, 0], SQUARE.as_flattened(), &face), "nOFF");
    check_square(&file("nOFF\n3 BINARY\n", &[4, 1, 0], SQUARE.as_flattened(), &face), "nOFF 3");
    let error = read(&file("nOFF BINARY\n", &[5, 4, 1, 0], SQUARE.as_flattened(), &face)).unwrap_err();
    assert_eq!(error.to_string(), "OFF byte 12: needs nOFF of dimension 5, not 3, which is not supported");
}

#[test]
fn faces_have_colours_and_sizes() {
    let red = 1.0f32.to_bits() as i32;
    let faces = [3, 0, 1, 2, 1, 7, 2, 0, 99, 0, 0, 4, red, 0, 0, red, 4, 3, 2, 1, 0, 3, red, 0, 0];
    let mut bytes = file("OFF BINARY\n", &[4, 4, 0], SQUARE.as_flattened(), &faces);
    let mesh = read(&bytes).unwrap();
    assert_eq!(mesh.faces, [[0, 1, 2], [3, 2, 1], [3, 1, 0]]);
    assert!(mesh.polygons().eq([0..1, 1..3]));
    let [note] = &mesh.notes[..] else { panic!("{:?}", mesh.notes) };
    assert_eq!(
        (&note.what, note.count, note.first),
        (&Skipped::ShortFaces, 2, Place::Byte(11 + 12 + 48 + 24))
    );
    bytes.extend(b"ab");
    let note = &read(&bytes).unwrap().notes[1];
    assert_eq!((&note.what, note.count), (&Skipped::TrailingBytes, 2));
}

#[test]
fn errors_name_the_byte() {
    let with = |counts: &[i32], face: &[i32]| file("OFF BINARY\n", counts, SQUARE.as_flattened(), face);
    let face = [3, 0, 1, 2, 0];
    for counts in [[-1, 1, 0], [4, -1, 0]] {
        let (place, reason) = refused(&with(&counts, &face));
        assert!(matches!(place, Place::ByteIn { item: Item::Header, .. }));
        assert_eq!(reason, Reason::BadWord { word: "-1".into(), expected: "a count" });
    }
    for counts in [[i32::MAX, 1, 0], [4, i32::MAX, 0], [i32::MAX, i32::MAX, 0], [6, 1, 0], [4, 4, 0]] {
        let (place, reason) = refused(&with(&counts, &face));
        assert!(
            place == Place::Byte(11) && matches!(reason, Reason::TooShort { .. }),
            "{counts:?}: {reason}"
        );
    }
    let at = |byte| Place::ByteIn { item: Item::Face(0), byte };
    for (face, place, reason) in [
        ([3, 0, 1, 4, 0], at(83), Reason::IndexOutOfRange { index: "4".into(), vertices: 4 }),
        ([3, -1, 1, 2, 0], at(75), Reason::IndexOutOfRange { index: "-1".into(), vertices: 4 }),
        ([-3, 0, 1, 2, 0], at(71), Reason::BadWord { word: "-3".into(), expected: "a count" }),
        (
            [i32::MAX, 0, 1, 2, 0],
            Place::Byte(71),
            Reason::TooShort { item: Item::Face(0), needed: 4 * 2147483647, available: 16 },
        ),
        ([4, 0, 1, 2, 3], Place::Byte(91), Reason::Ends { item: Item::Face(0) }),
        (
            [3, 0, 1, 2, 5],
            at(87),
            Reason::BadWord { word: "5".into(), expected: "a number of colour components, 0 to 4" },
        ),
        (
            [3, 0, 1, 2, 4],
            Place::Byte(87),
            Reason::TooShort { item: Item::Face(0), needed: 16, available: 0 },
        ),
    ] {
        assert_eq!(refused(&with(&[4, 1, 0], &face)), (place, reason), "{face:?}");
    }
}

#[test]
fn truncation_anywhere() {
    for whole in [square("OFF BINARY\n", 0), square("STCNOFF BINARY\n", 9)] {
        for length in 0..whole.len() {
            assert!(read_as(&whole[..length], Format::Off).is_err(), "{length}");
        }
    }
}

proptest! {
    #[test]
    fn no_bytes_make_a_reader_panic(
        header in r"(ST)?C?N?4?n?OFF( 3)? BINARY\n", counts in prop::array::uniform3(0i32..6), rest: Vec<u8>,
    ) {
        let _ = read_as(&[&file(&header, &counts, &[], &[])[..], &rest].concat(), Format::Off);
    }
}

//! Headers: what they may hold, and where they are refused.

use onering_io::{Format, Place, Skipped, read_as};

use super::{FACES, POINT_LINES, POINTS, VERTICES, binary, faces, point_bytes, read, refused, text};

#[test]
fn comments_and_line_ends_of_every_kind() {
    let file =
        faces(1, "3 0 1 2\n").replace("element face", "comment end_header\nobj_info a b\n\nelement face");
    for end in ["\n", "\r\n", "\r"] {
        let mesh = read(file.replace('\n', end));
        assert_eq!(
            (mesh.positions.as_slice(), mesh.faces.as_slice()),
            (&POINTS[..], &[[0, 1, 2]][..]),
            "{end:?}"
        );
        assert_eq!(mesh.notes, []);
    }
}

#[test]
fn data_may_begin_with_the_byte_of_a_line_end() {
    let points: Vec<u8> = [10u32, 0, 0].iter().flat_map(|bits| bits.to_le_bytes()).collect();
    let header = "ply\nformat binary_little_endian 1.0\nelement vertex 1\nproperty float x\nproperty float y\n\
                  property float z\nend_header\n";
    for end in ["\n", "\r\n", "\r"] {
        let file = [header.replace('\n', end).into_bytes(), points.clone()].concat();
        assert_eq!(read(&file).positions[0][0].to_bits(), 10, "{end:?}");
    }
}

#[test]
fn the_first_line_shows_the_format() {
    for start in ["ply\n", "ply\r\n", "ply\r", "ply \n"] {
        assert_eq!(Format::of_content(start.as_bytes()), Some(Format::Ply), "{start:?}");
    }
    for start in ["ply", "plyx\n", "ply x\n", "PLY\n", ""] {
        assert_eq!(Format::of_content(start.as_bytes()), None, "{start:?}");
    }
}

#[test]
fn unknown_lines_and_elements_are_noted() {
    let declarations = format!(
        "whatever 1\n{VERTICES}element edge 2\nproperty int a\nproperty list int double b\nelement nothing 4000000000\n\
         element none 0\nproperty int a\n"
    );
    let mesh = read(text(&declarations, &format!("{POINT_LINES}7 2 x y\n8 0\n\n")));
    let notes: Vec<_> = mesh.notes.iter().map(|note| (note.what.clone(), note.count, note.first)).collect();
    assert_eq!(
        notes,
        [
            (Skipped::UnknownStatements, 1, Place::Line(3)),
            (Skipped::Elements("edge".into()), 2, Place::Line(8)),
            (Skipped::Elements("nothing".into()), 4_000_000_000, Place::Line(11)),
        ]
    );
    assert_eq!(mesh.notes[1].to_string(), "2 elements of kind `edge` skipped, the first at line 8");
}

#[test]
fn bytes_behind_the_end_are_noted() {
    let mesh = read(faces(1, "3 0 1 2\n3 2\n"));
    assert_eq!((mesh.notes[0].what.clone(), mesh.notes[0].count), (Skipped::TrailingBytes, 3));
    assert_eq!(mesh.notes[0].first, Place::Line(15));
    let file = binary(VERTICES, &[point_bytes(), vec![0; 5]].concat());
    let mesh = read(&file);
    assert_eq!((mesh.notes[0].count, mesh.notes[0].first), (5, Place::Byte(file.len() - 5)));
}

#[test]
fn bad_headers_are_refused_at_their_line() {
    let good = faces(0, "");
    for (from, to, line, reason) in [
        ("ply\n", "plx\n", 1, "this is not a PLY file: it does not begin with `ply`"),
        ("format ascii 1.0\n", "", 10, "`format` is missing"),
        ("ascii", "utf8", 2, "`utf8` is not `ascii`, `binary_little_endian` or `binary_big_endian`"),
        ("format ascii 1.0\n", "format ascii 1.0\nformat ascii 1.0\n", 3, "`format` is declared twice"),
        ("ascii 1.0", "", 2, "`format` lacks a word"),
        ("vertex 4", "vertex", 3, "`element` lacks a word"),
        ("vertex 4", "vertex 4.0", 3, "`4.0` is not a count"),
        ("vertex 4", "vertex -4", 3, "`-4` is not a count"),
        ("vertex 4", "vertex 99999999999999999999999", 3, "more than 4294967295 vertices or faces"),
        ("element face", "element vertex", 7, "`vertex` is declared twice"),
        ("float z", "float x", 6, "`x` is declared twice"),
        ("float z", "float w", 3, "`z` is missing: vertices need x, y and z"),
        ("float z", "float128 z", 6, "`float128` is not a scalar type"),
        ("float z", "float", 6, "`property` lacks a word"),
        ("float z", "list uchar float z", 3, "`z` is a list, but a coordinate is a number"),
        ("element vertex 4\n", "", 3, "`x` belongs to no element"),
        ("list uchar", "list float", 8, "`float` is not an integer type, as the length of a list needs"),
        (
            "uchar int",
            "uchar float",
            7,
            "`vertex_indices` is a list of floats, but vertices are named by integers",
        ),
        ("list uchar int", "int", 7, "`vertex_indices` is a number, but a face is a list of vertices"),
        ("end_header", "end_headers", 15, "`end_header` is missing"),
        ("end_header", "end_header 1", 9, "`end_header` is followed by something on its line"),
    ] {
        assert!(good.contains(from), "{from}");
        let file = good.replacen(from, to, 1);
        let (place, why) = refused(&file);
        let line = if from == "end_header" && line == 15 { file.lines().count() + 1 } else { line };
        let line = if from.starts_with("format ascii 1.0") && to.is_empty() { 8 } else { line };
        assert_eq!((place, why.to_string().as_str()), (Place::Line(line), reason), "{file}");
    }
}

#[test]
fn a_file_without_vertices_is_empty() {
    assert_eq!(read("ply\nformat ascii 1.0\nend_header"), Default::default());
    let (_, reason) = refused(text(&format!("element face 1\n{FACES}"), "3 0 0 0\n"));
    assert_eq!(reason.to_string(), "face names vertex 0, but there are 0");
    assert!(read_as(b"", Format::Ply).is_err());
}

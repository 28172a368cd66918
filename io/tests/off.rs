//! OFF files by topic, read and written.

use onering_io::{Error, Format, Place, Reason, Skipped, Triangles, read, read_as, write};
use proptest::prelude::*;

const SQUARE: [[f32; 3]; 4] = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.5]];

fn check_square(text: &str) {
    let mesh = read_as(text.as_bytes(), Format::Off).unwrap_or_else(|error| panic!("{error}: {text}"));
    assert_eq!(mesh.positions, SQUARE, "{text}");
    assert_eq!((mesh.faces, mesh.notes), (vec![[0, 1, 2], [0, 2, 3]], vec![]), "{text}");
    assert_eq!(mesh.polygon_sizes, [(4, 1)].into(), "{text}");
}

fn not_a_count(word: &str) -> Reason {
    Reason::BadWord { word: word.into(), expected: "a count" }
}

fn refused(text: &str) -> (Place, Reason) {
    match read_as(text.as_bytes(), Format::Off) {
        Err(Error::Malformed { format: Format::Off, place, reason, .. }) => (place, reason),
        other => panic!("{other:?}: {text}"),
    }
}

const PLAIN: &str = "OFF\n4 1 4\n0 0 0\n1 0 0\n1 1 0\n0 1 .5\n4 0 1 2 3\n";

#[test]
fn headers() {
    for header in
        ["OFF 4 1 4", "OFF\n4 1", "OFF # a\n# b\n\n4 1 4 # c", " \n# a\n  OFF\t4 1", "4 1 4", "# a\n4 1"]
    {
        check_square(&PLAIN.replace("OFF\n4 1 4", header));
        check_square(&PLAIN.replace("OFF\n4 1 4", header).replace('\n', "\r\n"));
        check_square(&PLAIN.replace("OFF\n4 1 4", header).replace('\n', "\r"));
    }
    for keyword in ["OFF", "COFF", "NOFF", "STOFF", "STCNOFF", "NCSTOFF", "CNOFF"] {
        let text = PLAIN.replace("OFF", keyword);
        check_square(&text);
        assert_eq!(Format::of_content(text.as_bytes()), Some(Format::Off));
    }
    for word in ["CCOFF", "off", "xOFF", "OFFC", "4"] {
        assert_eq!(Format::of_content(PLAIN.replace("OFF", word).as_bytes()), None, "{word}");
    }
}

#[test]
fn what_stands_behind_is_ignored() {
    for colour in [" 3", " 255 0 0", " 1.0 0.5 0 0.3", " red", "# red", "\t"] {
        check_square(&PLAIN.replace("1 2 3", &format!("1 2 3{colour}")));
        check_square(&PLAIN.replace("1 1 0", &format!("1 1 0{colour}")));
        check_square(&PLAIN.replace("OFF", "COFF").replace("1 1 0", &format!("1 1 0{colour}")));
    }
    check_square(&format!("{PLAIN}3 9 9 9\n???\n"));
    check_square(&PLAIN.replace('\n', " # 1 2 3\n\n#\n"));
}

#[test]
fn lines_may_be_broken_anywhere_where_there_is_nothing_else() {
    check_square(&PLAIN.replace([' ', '\n'], "\n").replace("OFF\n4\n1\n4", "OFF\n4 1 4"));
    check_square("OFF\n4 1\n0 0 0 1 0 0\n1 1 0 0 1 .5\n4 0 1\n2 3\n");
    check_square("OFF\n4 1\n0 0 0 1 0 0 1 1 0 0 1 .5 4 0 1 2 3");
    let coloured = refused("COFF\n4 1\n0 0 0 1 0 0\n1 1 0 0 1 .5\n4 0 1 2 3\n");
    assert!(matches!(
        coloured,
        (Place::Line(_), Reason::Missing { what: "vertices", declared: 4, present: 3 })
    ));
}

#[test]
fn polygons_of_any_size() {
    let text = "OFF\n5 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 2 2\n2 0 99\n5 0 1 2 3 4\n3 2 1 0\n0\n";
    let mesh = read(text.as_bytes()).unwrap();
    assert_eq!(mesh.faces, [[0, 1, 2], [0, 2, 3], [0, 3, 4], [2, 1, 0]]);
    assert!(mesh.polygons().eq([0..3, 3..4]));
    let [note] = &mesh.notes[..] else { panic!("{:?}", mesh.notes) };
    assert_eq!((&note.what, note.count, note.first), (&Skipped::ShortFaces, 2, Place::Line(8)));
}

#[test]
fn errors_name_the_line() {
    let no_header = |text| matches!(refused(text).1, Reason::NotThisFormat { .. });
    assert!(no_header("") && no_header("OFF\n") && no_header("OFF\n4\n1\n"));
    for (from, to, line, reason) in [
        ("4 1 4", "4 -1 4", 2, not_a_count("-1")),
        ("4 1 4", "4.0 1 4", 2, not_a_count("4.0")),
        ("1 1 0", "1 y 0", 5, Reason::BadNumber { word: "y".into() }),
        ("4 0", "x 0", 7, not_a_count("x")),
        ("1 2 3", "1 2 4", 7, Reason::IndexOutOfRange { index: "4".into(), vertices: 4 }),
        ("1 2 3", "1 2 -1", 7, Reason::IndexOutOfRange { index: "-1".into(), vertices: 4 }),
        ("1 2 3", "1 2 1.5", 7, Reason::BadIndex { word: "1.5".into() }),
    ] {
        assert_eq!(refused(&PLAIN.replace(from, to)), (Place::Line(line), reason), "{to}");
    }
    for counts in ["9 1 4", "4 99 4", "4294967296 1 0", "99999999999999999999 99999999999999999999 1"] {
        let (place, reason) = refused(&PLAIN.replace("4 1 4", counts));
        assert_eq!(place, Place::Line(2));
        assert!(matches!(reason, Reason::TooShort { .. }), "{counts}: {reason}");
    }
}

#[test]
fn homogeneous_coordinates_are_divided() {
    let text = "4OFF\n4 1 4\n0 0 0 7\n2 0 0 2 # c\n-3 -3 0 -3\n0 1e39 .5e39 1e39\n4 0 1 2 3 255 0 0\n";
    check_square(text);
    check_square(&text.replace("# c", ""));
    check_square("4OFF 4 1\n0 0 0 7 2 0 0\n2 -3 -3 0 -3 0 1 .5 1 4 0\n1 2 3");
    check_square("C4OFF\n4 1\n0 0 0 1 9\n1 0 0 1 9 9\n1 1 0 1 9\n0 2 1 2 9\n4 0 1 2 3\n");
    check_square("4nOFF\n3\n4 1\n1 0 0 0\n2 2 0 0\n1 1 1 0\n2 0 2 1\n4 0 1 2 3\n");
    // 16777217 is no f32: rounded before the division, the quotient would be 3355443.25.
    let fifths = read(b"4OFF\n1 0 0\n16777217 1 -1 5\n").unwrap();
    assert_eq!(
        fifths.positions,
        [[(16777217.0f64 / 5.0) as f32, (1.0f64 / 5.0) as f32, (-1.0f64 / 5.0) as f32]]
    );
    let infinite = read(b"4OFF\n1 0 0\n1 -1 0 0\n").unwrap().positions[0];
    assert!(infinite[..2] == [f32::INFINITY, f32::NEG_INFINITY] && infinite[2].is_nan());
    let short = Reason::Missing { what: "components of a vertex", declared: 4, present: 3 };
    assert_eq!(refused("C4OFF\n2 0 0\n0 0 0 1\n1 1 1\n"), (Place::Line(4), short));
    let word = Reason::BadNumber { word: "w".into() };
    assert_eq!(refused("4OFF\n1 0 0\n0 0 0 w\n"), (Place::Line(3), word));
}

#[test]
fn a_dimension_is_three() {
    for dimension in ["\n3\n", " 3\n", " # c\n3 # d\n"] {
        check_square(&PLAIN.replace("OFF\n", &format!("nOFF{dimension}")));
    }
    for (dimension, line) in [("4", 2), ("2", 2), ("99999999999999999999", 2)] {
        let error = read(PLAIN.replace("OFF", &format!("nOFF\n{dimension}")).as_bytes()).unwrap_err();
        assert!(matches!(error, Error::Unsupported { place: Place::Line(l), .. } if l == line), "{error}");
    }
    let error = read(b"nOFF\n4\n1 0 0\n0 0 0 0\n").unwrap_err().to_string();
    assert_eq!(error, "OFF line 2: needs nOFF of dimension 4, not 3, which is not supported");
    let bad = (Place::Line(2), Reason::BadWord { word: "-3".into(), expected: "a count" });
    assert_eq!(refused(&PLAIN.replace("OFF", "nOFF\n-3")), bad);
    assert!(matches!(refused("nOFF\n").1, Reason::NotThisFormat { .. }));
}

/// Data may begin behind the counts; whatever else stands there is an error, never a vertex that is lost.
#[test]
fn words_behind_the_counts() {
    check_square("OFF\n4 1 4 0 0 0\n1 0 0\n1 1 0\n0 1 .5\n4 0 1 2 3\n");
    check_square("OFF 4 1 4 0\n0 0 1 0 0 1 1 0\n0 1 .5\n4 0 1 2 3\n");
    check_square("4 1 4 0 0 0 1 0 0 1 1 0 0 1 .5 4 0 1 2 3");
    let tetrahedron = "OFF\n4 4 6 0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
    let mesh = read(tetrahedron.as_bytes()).unwrap();
    assert_eq!((mesh.positions[3], &mesh.faces[..2]), ([0.0, 0.0, 1.0], &[[0, 2, 1], [0, 1, 3]][..]));
    let expected = "the end of the line behind the counts";
    for text in [PLAIN.replace("4 1 4", "4 1 4 9"), PLAIN.replace("OFF\n4 1 4", "COFF\n4 1 4 9")] {
        assert_eq!(refused(&text), (Place::Line(2), Reason::BadWord { word: "9".into(), expected }));
    }
    // Line by line a vertex is missing, and in one stream a word is left.
    let broken = refused("OFF\n4 1 4 7 0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n");
    assert!(matches!(broken, (Place::Line(_), Reason::BadWord { .. })), "{broken:?}");
}

/// A cut file is an error, or the same mesh with its last number cut.
#[test]
fn truncation_anywhere() {
    for text in [PLAIN.to_owned(), PLAIN.replace("OFF", "COFF"), PLAIN.replace(' ', "\n")] {
        for length in 0..text.len() - 1 {
            let result = read_as(&text.as_bytes()[..length], Format::Off);
            assert!(result.is_err(), "{length}: {result:?}");
        }
    }
}

fn bits(mesh: &Triangles) -> Vec<[u32; 3]> {
    mesh.positions.iter().map(|p| p.map(|x| if x.is_nan() { f32::NAN } else { x }.to_bits())).collect()
}

proptest! {
    /// Any floats but for the payload of a NaN, and polygons of three to nine corners.
    #[test]
    fn what_is_written_is_read(
        positions in prop::collection::vec(prop::array::uniform3(any::<u32>().prop_map(f32::from_bits)), 1..20),
        polygons in prop::collection::vec(prop::collection::vec(any::<prop::sample::Index>(), 3..10), 0..20),
    ) {
        let mut mesh = Triangles::new(positions, vec![]);
        let mut starts = Vec::new();
        for polygon in &polygons {
            let corners: Vec<u32> = polygon.iter().map(|i| i.index(mesh.positions.len()) as u32).collect();
            starts.push(mesh.faces.len() as u32);
            mesh.faces.extend(corners[1..].windows(2).map(|two| [corners[0], two[0], two[1]]));
            *mesh.polygon_sizes.entry(corners.len()).or_default() += 1;
        }
        mesh.polygon_starts = polygons.iter().any(|polygon| polygon.len() > 3).then_some(starts);
        let mut file = Vec::new();
        write(&mut file, &mesh, Format::Off).unwrap();
        let again = read(&file).unwrap();
        prop_assert_eq!(bits(&again), bits(&mesh));
        prop_assert_eq!((again.faces, again.polygon_starts, again.polygon_sizes), (mesh.faces, mesh.polygon_starts, mesh.polygon_sizes));
    }

    #[test]
    fn no_bytes_make_a_reader_panic(bytes: Vec<u8>, text in r"(ST)?C?4?(n)?OFF( 3)? [0-9] [0-9]( |\n|#|-?[0-9.]{1,3}){0,60}") {
        let _ = (read_as(&bytes, Format::Off), read_as(text.as_bytes(), Format::Off));
    }
}

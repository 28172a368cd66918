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
fn variants_that_are_not_read_are_named() {
    for (keyword, expected) in [
        ("4OFF", "OFF line 1: needs 4OFF (homogeneous coordinates), which is not supported"),
        ("C4nOFF", "OFF line 1: needs 4OFF (homogeneous coordinates), which is not supported"),
        ("nOFF\n3", "OFF line 1: needs nOFF (any number of dimensions), which is not supported"),
        ("CNOFF BINARY", "OFF line 1: needs OFF BINARY, which is not supported"),
    ] {
        assert_eq!(read(PLAIN.replace("OFF", keyword).as_bytes()).unwrap_err().to_string(), expected);
    }
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
    fn no_bytes_make_a_reader_panic(bytes: Vec<u8>, text in r"(ST)?C?OFF [0-9] [0-9]( |\n|#|-?[0-9.]{1,3}){0,60}") {
        let _ = (read_as(&bytes, Format::Off), read_as(text.as_bytes(), Format::Off));
    }
}

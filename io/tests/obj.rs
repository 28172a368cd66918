//! OBJ as it is written in the world, and as tobj reads it.

mod common;

use std::collections::BTreeMap;

use onering_io::{Error, Place, Reason, Skipped, Triangles, obj, read};
use proptest::prelude::*;

const CORNERS: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

fn parse(text: &str) -> Triangles {
    obj::read(text.as_bytes()).unwrap_or_else(|error| panic!("{error} in {text:?}"))
}

/// The faces of a file that has four vertices before this text.
fn faces(text: &str) -> Vec<[u32; 3]> {
    parse(&format!("{CORNERS}{text}")).faces
}

/// The line and the reason for which the text is refused.
fn refusal(text: &str) -> (usize, Reason) {
    match obj::read(text.as_bytes()) {
        Err(Error::Malformed { place: Place::Line(line), reason, .. }) => (line, reason),
        other => panic!("{other:?} for {text:?}"),
    }
}

#[test]
fn corners_are_written_in_many_ways() {
    for text in [
        "f 1 2 3",
        "f 1/9 2/9 3/9",
        "f 1//7 2//7 3//7",
        "f 1/1/1 2/2/2 3/-3/-3",
        "f +1 2/ 3//",
        "f -4 -3 -2",
        "fo 1 2 3",
        "\t f\t1\t2\t3 ",
        "f 1 2 3#comment",
        "f 1 \\\n 2 \\ \t\r\n 3",
        "f 1 2 3 \\",
        "f 1 2 3\\ ",
        "f 1 2 3 \\\n",
        "f 0001 00000000000000002 3",
        "g a\nf 1 2 3\ng b",
    ] {
        assert_eq!(faces(text), [[0, 1, 2]], "{text:?}");
    }
}

#[test]
fn polygons_become_fans_and_are_counted() {
    let mesh = parse(&format!("{CORNERS}v 2 2 2\nf 1 2 3 4\nf 1 2 3 4 5\nf 3 2 1\nf 4 3 2 1\n"));
    let fans = [[0, 1, 2], [0, 2, 3], [0, 1, 2], [0, 2, 3], [0, 3, 4], [2, 1, 0], [3, 2, 1], [3, 1, 0]];
    assert_eq!(mesh.faces, fans);
    assert_eq!(mesh.polygon_sizes, BTreeMap::from([(3, 1), (4, 2), (5, 1)]));
    assert_eq!(mesh.polygon_count(), 4);
    let large: String = (0..20).map(|i| format!("v {i} 0 0\n")).collect();
    let mesh = parse(&format!("{large}f {}", (1..=20).map(|i| format!("{i} ")).collect::<String>()));
    assert_eq!((mesh.faces.len(), mesh.polygon_sizes), (18, BTreeMap::from([(20, 1)])));
}

#[test]
fn lines_end_in_three_ways_and_need_not_end() {
    for end in ["\n", "\r\n", "\r"] {
        let text = format!("{CORNERS}f 1 2 3\n\n# end").replace('\n', end);
        assert_eq!(parse(&text), parse(&format!("{CORNERS}f 1 2 3")));
        assert_eq!(refusal(&format!("{CORNERS}f 1 2 9").replace('\n', end)).0, 5);
    }
}

#[test]
fn names_may_be_in_any_encoding() {
    let mesh = obj::read(b"\xEF\xBB\xBF# caf\xE9\no \xFF\xFE\nv 1 2 3\n").unwrap();
    assert_eq!((mesh.positions, mesh.notes), (vec![[1.0, 2.0, 3.0]], vec![]));
}

#[test]
fn faces_may_come_before_their_vertices() {
    let mesh = parse("f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n");
    assert_eq!(mesh.faces, [[0, 1, 2]]);
    let beyond = Reason::IndexOutOfRange { index: "4".into(), vertices: 3 };
    assert_eq!(refusal("\nf 1 4 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n"), (2, beyond));
}

#[test]
fn coordinates_may_be_followed_by_anything_and_infinite() {
    let mesh = parse("v 1 2 3 0.5\nv 1 2 3 x y z\nv inf -Inf 1e99\nv 1e-3 .5 5.");
    assert_eq!(mesh.positions[..2], [[1.0, 2.0, 3.0]; 2]);
    assert_eq!(mesh.positions[2..], [[f32::INFINITY, f32::NEG_INFINITY, f32::INFINITY], [0.001, 0.5, 5.0]]);
    assert!(parse("v nan 0 0").positions[0][0].is_nan());
}

#[test]
fn what_is_left_out_is_noted() {
    let mesh =
        parse(&format!("{CORNERS}f 1 2\np 1\nl 1 2\nwhat 1\nl 2 3\nvn 0 0 1\nf\nvt 0 0\ns off\nf 1 2 3"));
    let notes: Vec<_> = mesh.notes.iter().map(|note| (note.what.clone(), note.count, note.first)).collect();
    assert_eq!(
        notes,
        [
            (Skipped::ShortFaces, 2, Place::Line(5)),
            (Skipped::Elements("p".into()), 1, Place::Line(6)),
            (Skipped::Elements("l".into()), 2, Place::Line(7)),
            (Skipped::UnknownStatements, 1, Place::Line(8)),
        ]
    );
    assert_eq!(mesh.notes[0].to_string(), "2 faces with fewer than 3 corners skipped, the first at line 5");
    assert_eq!(mesh.faces.len(), 1);
}

#[test]
fn the_first_line_at_fault_is_named() {
    let beyond = |index: &str, vertices| Reason::IndexOutOfRange { index: index.into(), vertices };
    for (text, reason) in [
        ("f 1 2 5", beyond("5", 4)),
        ("f 1 2 -5", beyond("-5", 4)),
        ("f 1 2 3 5/1/1\nf 0 0 0", beyond("5", 4)),
        ("f 1 2 4294967296", beyond("4294967296", 4)),
        ("f 1 2 4294967297", beyond("4294967297", 4)),
        ("f 1 2 18446744073709551617", beyond("18446744073709551617", 4)),
        ("f 1 2 -18446744073709551617", beyond("-18446744073709551617", 4)),
        ("f 1 2 0\nf 1 2 9", Reason::IndexZero),
        ("f -0 1 2", Reason::IndexZero),
        ("f 1x 2 3", Reason::BadIndex { word: "1x".into() }),
        ("f 1 2 3/x", Reason::BadIndex { word: "3/x".into() }),
        ("f /1 2 3", Reason::BadIndex { word: "/1".into() }),
        ("f 1.0 2 3", Reason::BadIndex { word: "1.0".into() }),
        ("f a\\b 2 3", Reason::BadIndex { word: "a\\b".into() }),
        ("v 1 2", Reason::TooFewCoordinates { found: 2 }),
        ("v", Reason::TooFewCoordinates { found: 0 }),
        ("v 1 2 #3", Reason::TooFewCoordinates { found: 2 }),
        ("v 1,5 2 3", Reason::BadNumber { word: "1,5".into() }),
    ] {
        assert_eq!(refusal(&format!("{CORNERS}{text}\nf 1 2 3")), (5, reason), "{text}");
    }
}

#[test]
fn words_in_errors_are_short_and_printable() {
    let Reason::BadNumber { word } = refusal(&format!("v {}", "x".repeat(1 << 20))).1 else { panic!() };
    assert_eq!(word, format!("{}...", "x".repeat(60)));
    assert_eq!(refusal("v \x1b[2J\0").1, Reason::BadNumber { word: "\u{FFFD}[2J\u{FFFD}".into() });
}

#[test]
fn other_text_is_no_obj() {
    assert_eq!(parse(""), Triangles::default());
    assert_eq!(parse("# only a comment\n\n"), Triangles::default());
    let (line, reason) = refusal("\n<html>\n<body>");
    assert_eq!((line, matches!(reason, Reason::NotThisFormat { .. })), (2, true));
    assert!(matches!(read(b"ISO-10303-21;"), Err(Error::UnknownFormat { path: None })));
    assert_eq!(read(CORNERS.as_bytes()).unwrap().positions.len(), 4);
}

#[test]
fn junk_that_hits_a_keyword_by_chance_is_no_obj() {
    let (line, reason) = refusal("\u{1}\u{2}\nl\0 7\nl 7\ng\nqq");
    assert_eq!((line, matches!(reason, Reason::NotThisFormat { .. })), (1, true));
    // As many lines that are known as are not, or a vertex: it is an OBJ.
    assert_eq!(parse("what\nvn 0 0 1\ng a\nhow").notes[0].count, 2);
    assert_eq!(parse("what\nhow\nv 0 0 0").positions.len(), 1);
}

/// What the ranges of faces and `polygon` say agrees with the counts.
fn check_polygons(mesh: &Triangles) {
    let mut sizes = BTreeMap::new();
    let mut end = 0;
    for (p, faces) in mesh.polygons().enumerate() {
        assert_eq!(faces.start, end);
        assert!(faces.clone().all(|face| mesh.polygon(face) == Some(p)));
        *sizes.entry(faces.len() + 2).or_default() += 1;
        end = faces.end;
    }
    assert_eq!((end, mesh.polygon(end)), (mesh.faces.len(), None));
    assert_eq!(sizes, mesh.polygon_sizes);
    assert_eq!(mesh.polygon_starts.is_some(), sizes.keys().any(|size| *size > 3));
}

#[test]
fn faces_know_their_polygon() {
    let mesh = parse(&format!("{CORNERS}f 1 2 3\nf 1 2\nf 1 2 3 4\nf 3 2 1\nf 4 3 2 1\n"));
    assert_eq!(mesh.polygon_starts, Some(vec![0, 1, 3, 4]));
    assert!(mesh.polygons().eq([0..1, 1..3, 3..4, 4..6]));
    for text in ["", "f 1 2 3\nf 3 2 1", "f 1 2 3 4", "f 1 2 3 4 1 2 3 4 1\nf 1 2 3"] {
        check_polygons(&parse(&format!("{CORNERS}{text}")));
    }
}

/// The position of every corner of every face, as bits: tobj renumbers the vertices, but not these.
fn our_corners(mesh: &Triangles) -> Vec<[u32; 3]> {
    mesh.faces.iter().flatten().map(|corner| mesh.positions[*corner as usize].map(f32::to_bits)).collect()
}

fn tobj_corners(models: &[tobj::Model]) -> Vec<[u32; 3]> {
    let meshes = models.iter().map(|model| &model.mesh);
    let corners = meshes.flat_map(|mesh| mesh.indices.iter().map(move |i| (mesh, *i as usize)));
    corners.map(|(mesh, i)| std::array::from_fn(|c| mesh.positions[3 * i + c].to_bits())).collect()
}

#[test]
fn real_files_agree_with_tobj() {
    let Some((folder, entries)) = common::meshes() else { return };
    let mut compared = 0;
    for entry in entries.iter().filter(|entry| entry["format"] == "OBJ") {
        let (name, path) = common::path_of(&folder, entry);
        let bytes = std::fs::read(path).unwrap();
        let Some(models) = common::tobj_models(&bytes) else { continue };
        assert!(our_corners(&obj::read(&bytes).unwrap()) == tobj_corners(&models), "{name}");
        compared += 1;
    }
    assert!(compared >= 15, "tobj reads only {compared} files");
}

prop_compose! {
    /// An OBJ file of up to 12 vertices, with faces, groups, comments and blank lines between them.
    fn any_obj()(
        positions in prop::collection::vec(any::<[f32; 3]>().prop_filter("finite", |p| p.iter().all(|x| x.is_finite())), 3..12),
        lines in prop::collection::vec((0..6, prop::collection::vec(any::<prop::sample::Index>(), 3..8)), 0..20),
        end in prop::sample::select(vec!["\n", "\r\n", " \n"]),
    ) -> String {
        let count = positions.len();
        let mut text: String = positions.iter().map(|[x, y, z]| format!("v {x} {y:e} {z}{end}")).collect();
        for (kind, corners) in lines {
            let corners = corners.iter().map(|corner| corner.index(count) + 1);
            text += &match kind {
                0 => "g group\n".to_owned(),
                1 => format!("# comment{end}"),
                2 => format!("f{}{end}", corners.map(|i| format!(" {}", i as i64 - count as i64 - 1)).collect::<String>()),
                _ => format!("f{}{end}", corners.map(|i| format!("  {i}")).collect::<String>()),
            };
        }
        text
    }
}

proptest! {
    #[test]
    fn generated_files_agree_with_tobj(text in any_obj()) {
        let models = common::tobj_models(text.as_bytes()).expect("tobj reads the plain parts of OBJ");
        prop_assert_eq!(our_corners(&parse(&text)), tobj_corners(&models));
    }

    #[test]
    fn ranges_of_polygons_give_back_their_sizes(text in any_obj()) {
        check_polygons(&parse(&text));
    }

    #[test]
    fn any_words_are_read_without_panic(text in "([vf#lp\\\\ ]|-?[0-9]{1,3}|/|\r|\n|\t){0,80}") {
        let _ = obj::read(text.as_bytes());
    }
}

//! Text: polygons, properties to step over, and the line of an error.

use std::collections::BTreeMap;

use onering_io::{Item, Place, Reason, Skipped};

use super::{FACES, POINT_LINES, POINTS, VERTICES, faces, read, refused, text};

#[test]
fn polygons_are_cut_into_fans() {
    let mesh = read(faces(3, "3 0 1 2\n4 0 1 2 3\n3 3 2 1\n"));
    assert_eq!(mesh.positions, POINTS);
    assert_eq!(mesh.faces, [[0, 1, 2], [0, 1, 2], [0, 2, 3], [3, 2, 1]]);
    assert_eq!(mesh.polygon_sizes, BTreeMap::from([(3, 2), (4, 1)]));
    assert_eq!(mesh.polygon_starts, Some(vec![0, 1, 3]));
}

#[test]
fn elements_and_properties_come_in_any_order() {
    let declarations = "element face 2\nproperty int a\nproperty list ushort uint vertex_index\nproperty list char char b\n\
                        element vertex 3\nproperty double z\nproperty list uchar uchar c\nproperty short x\n\
                        property uchar red\nproperty float y\n";
    let body = "9 3 0 1 2 2 7 7\n9 3 2 1 0 0\n3 2 8 8 1 255 2e0\n6 0 4 255 5\n9 1 8 7 255 nan\n";
    let mesh = read(text(declarations, body));
    assert_eq!(mesh.faces, [[0, 1, 2], [2, 1, 0]]);
    assert_eq!(mesh.positions[..2], [[1.0, 2.0, 3.0], [4.0, 5.0, 6.0]]);
    assert!(mesh.positions[2][1].is_nan());
}

#[test]
fn vertex_indices_go_before_vertex_index() {
    let list = "property list uchar int vertex_index\n";
    let file =
        text(&format!("{VERTICES}element face 1\n{list}{FACES}"), &format!("{POINT_LINES}3 0 1 2 3 2 1 0\n"));
    assert_eq!(read(file).faces, [[2, 1, 0]]);
}

#[test]
fn line_ends_are_blanks() {
    let mesh = read(faces(1, "3 0 1 2\n").replace("0 0 0\n1 0 0\n", "0 0 0 1\n\n0\t0 "));
    assert_eq!((mesh.positions.as_slice(), mesh.faces.as_slice()), (&POINTS[..], &[[0, 1, 2]][..]));
}

#[test]
fn short_faces_are_noted() {
    let mesh = read(faces(4, "2 0 1\n3 0 1 2\n0\n1 99\n"));
    assert_eq!(mesh.faces, [[0, 1, 2]]);
    assert_eq!((mesh.notes[0].what.clone(), mesh.notes[0].count), (Skipped::ShortFaces, 3));
    assert_eq!(mesh.notes[0].first, Place::Line(14));
}

#[test]
fn faces_without_indices_are_another_element() {
    let mesh =
        read(text(&format!("{VERTICES}element face 1\nproperty int a\n"), &format!("{POINT_LINES}7\n")));
    assert_eq!(mesh.notes[0].what, Skipped::Elements("face".into()));
}

#[test]
fn errors_name_the_line() {
    for (lines, line, reason) in [
        ("3 0 1 4\n3 0 1 2\n", 14, "face names vertex 4, but there are 4"),
        ("3 0 1 2\n3 0 1 -1\n", 15, "face names vertex -1, but there are 4"),
        ("3 0 1 99999999999999999999\n", 14, "face names vertex 99999999999999999999, but there are 4"),
        ("3 0 1 2.0\n", 14, "`2.0` is not a vertex index"),
        ("3.0 0 1 2\n", 14, "`3.0` is not the length of a list"),
        ("-3 0 1 2\n", 14, "`-3` is not the length of a list"),
        ("4000000000 0 1 2\n", 15, "the file ends before face 0 does"),
        ("3 0 1 2\n", 15, "the file ends before face 1 does"),
    ] {
        // The file ends where its last line would begin.
        let line = if reason.starts_with("the file ends") { 14 + lines.lines().count() } else { line };
        let (place, why) = refused(faces(2, lines).replace("1 0 0\n", "1 0 0\n\n"));
        assert_eq!((place, why.to_string().as_str()), (Place::Line(line + 1), reason), "{lines}");
    }
    let (place, reason) = refused(faces(0, "").replace("1 0 0", "1 O 0"));
    assert_eq!((place, reason), (Place::Line(11), Reason::BadNumber { word: "O".into() }));
    let (_, reason) = refused(text(&VERTICES.replace('4', "4000000000"), POINT_LINES));
    assert_eq!(reason, Reason::Ends { item: Item::Vertex(4) });
}

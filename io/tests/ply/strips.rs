//! Triangle strips.

use std::collections::BTreeMap;

use onering_io::{Place, Skipped};

use super::{FACES, POINT_LINES, VERTICES, binary, point_bytes, read, refused, text};

const STRIPS: &str = "element tristrips 1\nproperty list int int vertex_indices\n";

#[test]
fn every_other_triangle_is_turned_and_negative_indices_end_strips() {
    let file = text(&format!("{VERTICES}{STRIPS}"), &format!("{POINT_LINES}9 0 1 2 3 -1 3 2 1 -1\n"));
    let mesh = read(file);
    assert_eq!(mesh.faces, [[0, 1, 2], [2, 1, 3], [3, 2, 1]]);
    assert_eq!(mesh.polygon_sizes, BTreeMap::from([(3, 3)]));
    assert_eq!(mesh.notes, []);
}

#[test]
fn strips_come_after_faces_wherever_they_stand() {
    let declarations = format!("{STRIPS}{VERTICES}element face 1\n{FACES}");
    let mesh = read(text(&declarations, &format!("3 0 1 2\n{POINT_LINES}4 3 2 1 0\n")));
    assert_eq!(mesh.faces, [[3, 2, 1], [3, 1, 0], [0, 1, 2]]);
    assert_eq!(mesh.polygon_starts, Some(vec![0, 2]));
    let mut body: Vec<u8> = [3i32, 0, 1, 2].iter().flat_map(|number| number.to_le_bytes()).collect();
    body.extend(point_bytes());
    body.extend([vec![3], [1i32, 2, 3].iter().flat_map(|number| number.to_le_bytes()).collect()].concat());
    assert_eq!(read(binary(&declarations, &body)).faces, [[1, 2, 3], [0, 1, 2]]);
}

#[test]
fn corners_that_make_no_triangle_are_noted() {
    let file = text(&format!("{VERTICES}{STRIPS}"), &format!("{POINT_LINES}8 0 1 -1 -1 2 -1 0 1\n"));
    let mesh = read(file);
    assert!(mesh.faces.is_empty());
    assert_eq!((mesh.notes[0].what.clone(), mesh.notes[0].count), (Skipped::LooseCorners, 5));
}

#[test]
fn the_list_may_have_any_name_but_holds_integers() {
    let file = text(&format!("{VERTICES}{STRIPS}"), &format!("{POINT_LINES}3 0 1 2\n"));
    assert_eq!(read(file.replace("vertex_indices", "strip")).faces, [[0, 1, 2]]);
    let (place, reason) = refused(file.replace("int int", "int float"));
    assert_eq!(place, Place::Line(7));
    assert!(reason.to_string().contains("list of floats"));
    let (place, reason) = refused(file.replace("3 0 1 2", "3 0 1 4"));
    assert_eq!(
        (place, reason.to_string().as_str()),
        (Place::Line(14), "face names vertex 4, but there are 4")
    );
}

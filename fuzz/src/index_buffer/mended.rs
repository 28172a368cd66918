//! Repair: after it every backend accepts the mesh, and every face that went in is accounted for.
use super::{List, backends};
use onering::{Defects, RepairOptions, Repaired, repair};
use std::collections::HashSet;

pub(super) fn mended(list: &List, before: &Defects) {
    let repaired =
        repair(list.vertices, &list.faces, &RepairOptions::default()).expect("nothing is beyond repair");
    is_sound(&repaired);
    faces_are_accounted_for(list, &repaired);
    assert_eq!(repaired.vertex_count, list.vertices + repaired.vertices_added);
    assert_eq!(repaired.dropped.out_of_range, before.lists.out_of_range_faces);
    assert_eq!(repaired.dropped.degenerate, before.lists.degenerate_faces);
    assert_eq!(repaired.dropped.duplicate, before.lists.duplicate_faces);
    assert_eq!(repaired.is_unchanged(), before.is_clean() && before.duplicate_faces == 0);
    if repaired.is_unchanged() {
        return;
    }
    let positions = repaired.carry_vertices(&list.positions);
    let mended = List { vertices: repaired.vertex_count, faces: repaired.faces, positions };
    backends::every(&mended, &Defects::of(mended.vertices, &mended.faces).expect("few faces"));
}

/// Vertices at equal positions become one first.
pub(super) fn welded(list: &List, choices: u8) {
    let places = u32::from(choices % 16 + 1);
    let at = |v: usize| [0.0, if v.is_multiple_of(2) { 0.0 } else { -0.0 }, (v as u32 * 7 % places) as f32];
    let positions: Vec<_> = (0..list.vertices).map(at).collect();
    let options = RepairOptions { weld: Some(&positions) };
    let repaired = repair(list.vertices, &list.faces, &options).expect("as many positions as vertices");
    is_sound(&repaired);
    let kept = repaired.carry_vertices(&positions);
    let distinct: HashSet<_> = kept.iter().map(|p| p[2].to_bits()).collect();
    assert_eq!(distinct.len() + repaired.vertices_added, kept.len());
    assert_eq!(repaired.face_source.len() + repaired.dropped.count(), list.faces.len());
}

fn is_sound(repaired: &Repaired) {
    let (vertices, faces) = (repaired.vertex_count, &repaired.faces);
    let after = Defects::of(vertices, faces).expect("few faces");
    assert!(after.is_clean() && after.duplicate_faces == 0, "{after}");
    backends::all_accept(vertices, faces);
    let again = repair(vertices, faces, &RepairOptions::default()).expect("nothing is beyond repair");
    assert!(again.is_unchanged() && again.faces == *faces, "{again}");
    assert_eq!((repaired.vertex_source.len(), repaired.face_source.len()), (vertices, faces.len()));
    assert!(!repaired.to_string().contains('\n'));
}

/// The maps back lead to the faces that went in, and each of those is kept or named as dropped.
fn faces_are_accounted_for(list: &List, repaired: &Repaired) {
    let flipped: HashSet<u32> = repaired.flipped.iter().copied().collect();
    for (face, f) in repaired.faces.iter().zip(&repaired.face_source) {
        let [a, b, c] = face.map(|v| repaired.vertex_source[v as usize]);
        let back = if flipped.contains(f) { [a, c, b] } else { [a, b, c] };
        assert_eq!(back, list.faces[*f as usize], "f{f}");
    }
    let dropped = &repaired.dropped;
    let all = [&repaired.face_source, &dropped.out_of_range, &dropped.degenerate, &dropped.duplicate];
    let mut all: Vec<u32> = all.into_iter().flatten().copied().collect();
    all.sort_unstable();
    assert!(all.into_iter().eq(0..list.faces.len() as u32), "every face is in one list");
}

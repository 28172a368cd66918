//! What `--reorder` and `--fill-holes` make of a mesh.
use super::*;

/// The faces as sets of corner positions: what no order of vertices and faces changes.
fn shape(path: &Path) -> Vec<[[u32; 3]; 3]> {
    let mesh = onering_io::load(path).unwrap();
    let place = |v: u32| mesh.positions[v as usize].map(f32::to_bits);
    let mut faces: Vec<_> = mesh.faces.iter().map(|face| face.map(place)).collect();
    faces.iter_mut().for_each(|face| face.sort_unstable());
    faces.sort_unstable();
    faces
}

#[test]
fn reordering_changes_nothing_but_the_order() {
    let start = fresh("reorder", "torus.obj", &torus(9));
    let (out, expected) = (start.with_file_name("out.ply"), inspect(&start));
    let methods = [
        ("--reorder", "along a Hilbert curve"),
        ("--reorder=morton", "along a Morton curve"),
        ("--reorder=breadth-first", "breadth first"),
        ("--reorder=cuthill-mckee", "by reverse Cuthill-McKee"),
    ];
    for (option, words) in methods {
        let said = converted(&start, &out, &[option]);
        assert!(said.contains(&format!("reordered  {words}\n")), "{said}");
        assert_eq!(shape(&out), shape(&start), "{option}");
        let found = inspect(&out);
        assert_eq!(found["verdict"], expected["verdict"], "{option}");
        assert_ne!(found["tri_sha256"], expected["tri_sha256"], "{option}");
    }
    let refused = convert(&start, &out, &["--reorder=rhyme"]);
    assert_eq!(refused.code, Some(2), "{refused:?}");
}

#[test]
fn reordering_keeps_polygons() {
    let text = "v 9 9 9\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 1 1\nf 3 4 6\nf 4 5 6\nf 5 2 6\nf 5 4 3 2\nf 2 3 6\n";
    let start = fresh("reorder-polygons", "pyramid.obj", text);
    let out = start.with_file_name("out.obj");
    converted(&start, &out, &["--reorder"]);
    assert_eq!(inspect(&out)["polygon_sizes"], inspect(&start)["polygon_sizes"]);
    assert_eq!(shape(&out), shape(&start));
    assert!(fs::read_to_string(&out).unwrap().lines().any(|line| line.split(' ').count() == 5));
}

#[test]
fn holes_are_filled_up_to_a_length() {
    let torus = torus(7);
    let open = torus.lines().take(49 + 98 - 2).map(|line| format!("{line}\n")).collect::<String>();
    let start = fresh("holes", "open.obj", &open);
    let out = start.with_file_name("out.obj");
    assert_eq!(inspect(&start)["verdict"], "open manifold: 4 boundary edges in 1 loop");
    let said = converted(&start, &out, &["--fill-holes=3"]);
    assert!(said.contains("holes      0 curves filled with 0 faces, 1 left: longer than asked\n"), "{said}");
    let said = converted(&start, &out, &["--fill-holes"]);
    assert!(said.contains("holes      1 curve filled with 2 faces\n"), "{said}");
    assert_eq!(inspect(&out)["verdict"], "closed manifold");
}

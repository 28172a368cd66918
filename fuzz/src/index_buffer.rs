//! Any list of triangles: what is said of it, what every backend makes of it, and what repair makes of it.
mod algorithms;
mod backends;
mod encoded;
mod fields;
mod mended;
#[allow(dead_code, reason = "shared with tests that use more of it")]
#[path = "../../tests/common/naive.rs"]
mod naive;
mod orders;
mod placed;
mod rebuilt;
mod relations;

use onering::Defects;

/// A list of triangles, and a position for each vertex.
struct List {
    vertices: usize,
    faces: Vec<[u32; 3]>,
    positions: Vec<[f32; 3]>,
}

/// Faces beyond these are ignored, so that a run takes milliseconds.
const MOST_FACES: usize = 96;

/// Up to so many vertices and faces, answers are compared with those of searches, which take the square or more.
const SEARCHED: usize = 10;

impl List {
    fn is_searched(&self) -> bool {
        self.vertices.max(self.faces.len()) <= SEARCHED
    }
}

/// One byte for the number of vertices, one for choices, and one for each corner.
///
/// The highest bit of the choices leaves corners as they are; without it they come into range.
pub fn index_buffer(bytes: &[u8]) {
    let &[vertices, choices, ref corners @ ..] = bytes else { return };
    let vertices = vertices % 64;
    let in_range = |corner: u8| if choices < 128 && vertices > 0 { corner % vertices } else { corner };
    let faces = corners.as_chunks::<3>().0.iter().take(MOST_FACES);
    let faces = faces.map(|face| face.map(|corner| in_range(corner).into())).collect();
    let positions = (0..vertices.into()).map(|v| position(v, choices, corners)).collect();
    let list = List { vertices: vertices.into(), faces, positions };
    let defects = Defects::of(list.vertices, &list.faces).expect("few faces");
    lists_are_counted(&list, &defects);
    far_apart(&list, &defects, (1 << (choices % 25)) + 1);
    backends::pairings(&list);
    backends::every(&list, &defects);
    backends::adaptors(&list, &defects);
    encoded::encoded(&list, &defects);
    rebuilt::rebuilt(&list);
    mended::mended(&list, &defects);
    mended::welded(&list, choices);
}

/// Coordinates: few, so that points coincide, are level, and lie in one plane; then those at the ends of what there is.
const COORDINATES: [f32; 16] = [
    0.0,
    1.0,
    -1.0,
    2.0,
    0.5,
    -0.0,
    3.0,
    0.1,
    f32::MAX,
    f32::MIN,
    f32::MIN_POSITIVE,
    1e-45,
    -1e-45,
    1e19,
    -1e-30,
    7e5,
];

/// Where a vertex is: the bytes of the corners tell that too, or else most positions of a short list would be the same.
/// One of the choices is whether coordinates may be extreme, or infinite or no number at all.
fn position(v: usize, choices: u8, corners: &[u8]) -> [f32; 3] {
    [0, 1, 2].map(|axis| {
        let byte = corners.get((5 * v + 3 * axis + usize::from(choices)) % corners.len().max(1));
        let byte = byte.copied().unwrap_or(choices).wrapping_add((v as u8).wrapping_mul(37)) ^ axis as u8;
        match (choices & 64 != 0, byte) {
            (true, 250) => f32::INFINITY,
            (true, 251) => f32::NAN,
            (true, _) => COORDINATES[usize::from(byte % 16)],
            (false, _) => f32::from(byte % 8) / 2.0 - 1.0,
        }
    })
}

/// The lists of the elements are as long as the figures say.
fn lists_are_counted(list: &List, defects: &Defects) {
    let lists = &defects.lists;
    assert_eq!(lists.out_of_range_faces.len(), defects.out_of_range_faces);
    assert_eq!(lists.degenerate_faces.len(), defects.degenerate_faces);
    assert_eq!(lists.isolated_vertices.iter().map(|run| run.len()).sum::<usize>(), defects.isolated_vertices);
    assert_eq!(defects.degrees.used() + defects.isolated_vertices, list.vertices);
    assert!(!defects.to_string().contains('\n'));
    if defects.is_clean() {
        assert!(defects.manifold && defects.orientable && defects.min_flips == 0, "{defects}");
    }
}

/// Numbers far apart go another way; what they name does not matter.
fn far_apart(list: &List, near: &Defects, step: u32) {
    let far: Vec<_> = list.faces.iter().map(|face| face.map(|v| v * step)).collect();
    let vertices = list.vertices.checked_sub(1).map_or(0, |last| last * step as usize + 1);
    let far = Defects::of(vertices, &far).expect("few faces");
    assert_eq!(far.isolated_vertices, near.isolated_vertices + vertices - list.vertices);
    let figures = |defects: &Defects| -> Vec<_> {
        defects.figures().filter(|(name, _)| *name != "isolated_vertices").collect()
    };
    assert_eq!(figures(&far), figures(near), "{step} apart");
}

//! Meshes to compare on where no file is named: one small enough for what is quadratic, one closed, one with boundary,
//! so that every part of every structure has something to do. Positions are there to put vertices in order by.

use onering::{CheL1, FromFaces, Map, subdivision};
use onering_io::Triangles;
use std::collections::HashMap;

/// Meshes by name: 2,106 triangles, then 81,920 and 82,080: more than the caches next to a core hold of most structures, and quick to
/// build.
pub(crate) fn all() -> [(&'static str, Triangles); 3] {
    [
        ("small terrain with nine holes (made here)", terrain(33, 2)),
        ("sphere (made here)", sphere(6)),
        ("terrain with nine holes (made here)", terrain(204, 8)),
    ]
}

#[rustfmt::skip]
const ICOSAHEDRON: [[u32; 3]; 20] = [
    [0, 11, 5], [0, 5, 1], [0, 1, 7], [0, 7, 10], [0, 10, 11],
    [1, 5, 9], [5, 11, 4], [11, 10, 2], [10, 7, 6], [7, 1, 8],
    [3, 9, 4], [3, 4, 2], [3, 2, 6], [3, 6, 8], [3, 8, 9],
    [4, 9, 5], [2, 4, 11], [6, 2, 10], [8, 6, 7], [9, 8, 1],
];

/// Its vertices, on three rectangles whose sides are in the golden ratio.
fn corners() -> Vec<[f32; 3]> {
    let t = f32::midpoint(1.0, 5.0_f32.sqrt());
    let on_first = [[-1.0, t, 0.0], [1.0, t, 0.0], [-1.0, -t, 0.0], [1.0, -t, 0.0]];
    let turned = |turns: usize| {
        on_first.map(|mut corner| {
            corner.rotate_right(turns);
            corner
        })
    };
    [0, 1, 2].map(turned).concat()
}

/// An icosahedron with each triangle cut into four, `levels` times.
pub(crate) fn sphere(levels: usize) -> Triangles {
    let (mut positions, mut faces) = (corners(), ICOSAHEDRON.to_vec());
    for _ in 0..levels {
        let mesh = CheL1::from_faces(positions.len(), &faces).expect("a sphere");
        let finer = subdivision::midpoint(&mesh, &Map::from(positions)).expect("not many");
        (positions, faces) = (finer.positions, finer.faces);
    }
    Triangles::new(positions, faces)
}

/// A square of `side` x `side` cells of two triangles, without nine square holes of `hole` x `hole` cells.
fn terrain(side: usize, hole: usize) -> Triangles {
    let in_hole = |x: usize| [1, 2, 3].iter().any(|k| (k * side / 4..k * side / 4 + hole).contains(&x));
    let (mut numbers, mut positions, mut faces) = (HashMap::new(), Vec::new(), Vec::new());
    let mut number = |x: usize, y: usize| {
        *numbers.entry((x, y)).or_insert_with(|| {
            positions.push([x as f32, y as f32, 0.0]);
            positions.len() as u32 - 1
        })
    };
    for y in 0..side {
        for x in (0..side).filter(|&x| !(in_hole(x) && in_hole(y))) {
            let [a, b, c, d] = [number(x, y), number(x + 1, y), number(x + 1, y + 1), number(x, y + 1)];
            faces.extend([[a, b, c], [a, c, d]]);
        }
    }
    Triangles::new(positions, faces)
}

#[cfg(test)]
mod tests {
    use super::*;
    use onering::defects::Defects;

    #[test]
    fn one_is_closed_and_two_have_ten_boundaries() {
        let [small, sphere, terrain] = all().map(|(_, mesh)| mesh);
        let figures = |made: &Triangles| Defects::of(made.positions.len(), &made.faces).unwrap();
        assert_eq!((sphere.positions.len(), sphere.faces.len()), (40_962, 81_920));
        assert_eq!(terrain.faces.len(), 2 * (204 * 204 - 9 * 64));
        assert_eq!(small.faces.len(), 2 * (33 * 33 - 9 * 4));
        let sphere = figures(&sphere);
        assert!(
            sphere.is_clean() && sphere.closed && sphere.genus == Some(0) && sphere.isolated_vertices == 0
        );
        for terrain in [figures(&small), figures(&terrain)] {
            assert!(terrain.is_clean() && terrain.genus == Some(0) && terrain.boundary_loops == Some(10));
            assert_eq!((terrain.components, terrain.isolated_vertices), (1, 0));
        }
    }
}

//! The roof of a cave, with stalactites.

use onering_io::Triangles;

/// Cells along each side, and how long one is, in metres.
const SIDE: u32 = 80;
const CELL: f64 = 0.05;

/// Where stalactites hang, how long they are, and how thick, in metres.
const STALACTITES: [[f64; 4]; 7] = [
    [1.0, 1.1, 1.1, 0.16],
    [1.6, 1.5, 0.7, 0.13],
    [2.1, 2.0, 1.4, 0.2],
    [2.5, 2.2, 0.5, 0.12],
    [2.9, 2.7, 0.9, 0.15],
    [0.8, 3.0, 0.6, 0.14],
    [3.2, 0.9, 0.8, 0.17],
];

/// A vaulted roof, z up, its faces counter-clockwise as seen from below.
pub(crate) fn mesh() -> Triangles {
    let row = SIDE + 1;
    let position = |i: u32| {
        let [x, y] = [i % row, i / row].map(|k| CELL * f64::from(k));
        [x, y, height(x, y)].map(|x| x as f32)
    };
    let cell = |i: u32| {
        let a = i / SIDE * row + i % SIDE;
        [[a, a + row + 1, a + 1], [a, a + row, a + row + 1]]
    };
    Triangles::new((0..row * row).map(position).collect(), (0..SIDE * SIDE).flat_map(cell).collect())
}

/// Only sums, products and quotients, so that every machine makes the same roof.
fn height(x: f64, y: f64) -> f64 {
    let [u, v] = [x, y].map(|x| x / (CELL * f64::from(SIDE)) - 0.5);
    let vault = 3.0 - 2.0 * (u * u + v * v);
    let hang = |[at_x, at_y, length, width]: [f64; 4]| {
        let [dx, dy] = [(x - at_x) / width, (y - at_y) / width];
        let square = dx * dx + dy * dy;
        length / (1.0 + square * square)
    };
    vault - STALACTITES.into_iter().map(hang).sum::<f64>()
}

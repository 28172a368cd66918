//! Hills and hollows.

use onering_io::Triangles;

/// Cells along each side.
const SIDE: u32 = 64;

/// A square of terrain, z up.
pub(crate) fn mesh() -> Triangles {
    let at = |i: u32| f64::from(i % (SIDE + 1)) / f64::from(SIDE);
    let position = |i: u32| {
        let [x, y] = [at(i), at(i / (SIDE + 1))];
        [x, y, 0.1 * (9.0 * x).sin() * (7.0 * y).cos()].map(|x| x as f32)
    };
    let cell = |i: u32| {
        let a = i / SIDE * (SIDE + 1) + i % SIDE;
        [[a, a + 1, a + SIDE + 2], [a, a + SIDE + 2, a + SIDE + 1]]
    };
    Triangles::new(
        (0..(SIDE + 1) * (SIDE + 1)).map(position).collect(),
        (0..SIDE * SIDE).flat_map(cell).collect(),
    )
}

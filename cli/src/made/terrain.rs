//! Hills and hollows.

use onering_io::Triangles;

/// Cells along each side, and how long one is, in metres.
const COLUMNS: u32 = 96;
const ROWS: u32 = 72;
const CELL: f64 = 25.0;

/// Waves of the noise along the longer side, and how much higher than the next finer noise it is.
const WAVES: [(f64, f64); 4] = [(2.6, 190.0), (5.2, 78.0), (10.4, 26.0), (20.8, 7.0)];

/// Terrain of 2.4 by 1.8 km, z up: 13,824 triangles.
pub(crate) fn mesh() -> Triangles {
    let row = COLUMNS + 1;
    let position = |i: u32| {
        let [x, y] = [i % row, i / row].map(|k| CELL * f64::from(k));
        [x, y, height(x, y)].map(|x| x as f32)
    };
    let cell = |i: u32| {
        let a = i / COLUMNS * row + i % COLUMNS;
        [[a, a + 1, a + row + 1], [a, a + row + 1, a + row]]
    };
    Triangles::new(
        (0..row * (ROWS + 1)).map(position).collect(),
        (0..COLUMNS * ROWS).flat_map(cell).collect(),
    )
}

/// Only sums and products, so that every machine makes the same terrain.
fn height(x: f64, y: f64) -> f64 {
    let length = CELL * f64::from(COLUMNS);
    let noise = |(seed, (waves, height)): (u32, (f64, f64))| {
        height * noise(seed as u32, x / length * waves, y / length * waves)
    };
    120.0 + (0..).zip(WAVES).map(noise).sum::<f64>()
}

/// Random values from 0 to 1 at whole coordinates, with a smooth surface between them.
fn noise(seed: u32, x: f64, y: f64) -> f64 {
    let [i, j] = [x, y].map(|x| x as u32);
    let [s, t] = [smooth(x - f64::from(i)), smooth(y - f64::from(j))];
    let between = |a: f64, b: f64, s: f64| a + s * (b - a);
    let along = |j: u32| between(random(seed, i, j), random(seed, i + 1, j), s);
    between(along(j), along(j + 1), t)
}

/// From 0 to 1 with neither slope nor curvature at both ends.
fn smooth(t: f64) -> f64 {
    t * t * t * (t * (6.0 * t - 15.0) + 10.0)
}

/// A number from 0 to 1 for each place, by mixing its bits.
fn random(seed: u32, i: u32, j: u32) -> f64 {
    let mut bits = seed.wrapping_mul(0x9E37_79B9) ^ i.wrapping_mul(0x85EB_CA6B) ^ j.wrapping_mul(0xC2B2_AE35);
    for (shift, factor) in [(16, 0x7FEB_352D), (15, 0x846C_A68B)] {
        bits = (bits ^ bits >> shift).wrapping_mul(factor);
    }
    f64::from(bits ^ bits >> 16) / f64::from(u32::MAX)
}

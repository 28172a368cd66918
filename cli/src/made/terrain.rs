//! Hills and hollows.

use onering_io::Triangles;

/// Cells along each side, and how long one is, in metres.
const COLUMNS: u32 = 96;
const ROWS: u32 = 72;
const CELL: f64 = 25.0;

/// The noise is a sum, from the coarsest to the finest: waves along the longer side, and how high they are.
const WAVES: [(f64, f64); 4] = [(2.4, 210.0), (4.9, 80.0), (10.3, 26.0), (21.7, 5.0)];
/// Of all tried, the one with the best view.
const SEED: u32 = 31;

/// Directions in which the noise rises at whole coordinates.
const SLOPES: [[f64; 2]; 8] =
    [[1.0, 0.0], [0.7, 0.7], [0.0, 1.0], [-0.7, 0.7], [-1.0, 0.0], [-0.7, -0.7], [0.0, -1.0], [0.7, -0.7]];

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
        height * noise(seed, x / length * waves, y / length * waves)
    };
    300.0 + (SEED..).zip(WAVES).map(noise).sum::<f64>()
}

/// Zero at whole coordinates, where it has random slopes, and smooth between them: the noise of Perlin (2002).
fn noise(seed: u32, x: f64, y: f64) -> f64 {
    let [i, j] = [x, y].map(|x| x as u32);
    let [x, y] = [x - f64::from(i), y - f64::from(j)];
    let plane = |right: u32, away: u32| {
        let [a, b] = SLOPES[(random(seed, i + right, j + away) >> 29) as usize];
        a * (x - f64::from(right)) + b * (y - f64::from(away))
    };
    let between = |a: f64, b: f64, t: f64| a + smooth(t) * (b - a);
    between(between(plane(0, 0), plane(1, 0), x), between(plane(0, 1), plane(1, 1), x), y)
}

/// From 0 to 1 with neither slope nor curvature at both ends.
fn smooth(t: f64) -> f64 {
    t * t * t * (t * (6.0 * t - 15.0) + 10.0)
}

/// A number for each place, by mixing its bits.
fn random(seed: u32, i: u32, j: u32) -> u32 {
    let mut bits = seed.wrapping_mul(0x9E37_79B9) ^ i.wrapping_mul(0x85EB_CA6B) ^ j.wrapping_mul(0xC2B2_AE35);
    for (shift, factor) in [(16, 0x7FEB_352D), (15, 0x846C_A68B)] {
        bits = (bits ^ bits >> shift).wrapping_mul(factor);
    }
    bits ^ bits >> 16
}

#[cfg(test)]
mod tests {
    use super::*;
    use onering::defects::Defects;

    #[test]
    fn the_terrain_is_a_disc_with_hills_and_hollows() {
        let mesh = mesh();
        let defects = Defects::of(mesh.positions.len(), &mesh.faces).unwrap();
        assert!(defects.is_clean() && defects.isolated_vertices == 0 && defects.boundary_loops == Some(1));
        assert_eq!((mesh.positions.len(), mesh.faces.len()), (97 * 73, 13_824));
        let heights = mesh.positions.iter().map(|p| p[2]);
        let [least, most] = [f32::min, f32::max].map(|of| heights.clone().reduce(of).unwrap());
        assert!(most - least > 200.0 && least > 0.0, "{least} {most}");
    }

    /// Steps of the coarsest noise alone are no more than its slopes allow.
    #[test]
    fn the_noise_is_smooth_across_whole_coordinates() {
        for (x, y) in [(1.0, 0.5), (2.0, 1.7), (0.3, 1.0)] {
            let [below, above] = [noise(7, x - 1e-7, y - 1e-7), noise(7, x, y)];
            assert!((below - above).abs() < 1e-6, "{below} {above}");
        }
        assert_eq!(noise(7, 3.0, 2.0), 0.0);
    }
}

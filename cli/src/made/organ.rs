//! Something soft to press: a smooth closed surface in the shape of a liver.
//!
//! An octahedron whose faces are cut finely enough, drawn out to a sphere, and the sphere to an organ: a thick right
//! lobe, a left lobe that tapers, a notch in the sharp lower edge between them, and a hollow underside.

use onering::vector::{self, Vector};
use onering_io::Triangles;
use std::f64::consts::FRAC_PI_2;

/// Vertices of the mesh where no size is named.
const VERTICES: usize = 6_000;

/// The organ where no file is named.
pub(crate) fn mesh() -> Triangles {
    of_size(VERTICES)
}

/// The organ in about so many vertices: 4 n^2 + 2 for the whole number n that comes nearest.
pub(crate) fn of_size(vertices: usize) -> Triangles {
    let cuts = (vertices as f64 / 4.0).sqrt().round().clamp(2.0, 10_000.0) as u32;
    let grid = Grid { cuts };
    let places = (0..=2 * cuts).flat_map(|ring| (0..grid.length(ring)).map(move |step| (ring, step)));
    let positions = places.map(|(ring, step)| vector::rounded(organ(grid.direction(ring, step))));
    Triangles::new(positions.collect(), grid.faces())
}

/// The vertices of a cut octahedron, in rings from the pole above to the pole below.
#[derive(Clone, Copy, Debug)]
struct Grid {
    /// Into how many pieces each of its edges is cut.
    cuts: u32,
}

impl Grid {
    /// Rings from the nearer pole.
    fn height(self, ring: u32) -> u32 {
        ring.min(2 * self.cuts - ring)
    }

    /// How many vertices a ring has: the poles are rings of one.
    fn length(self, ring: u32) -> u32 {
        (4 * self.height(ring)).max(1)
    }

    fn vertex(self, ring: u32, step: u32) -> u32 {
        let before = |ring: u32| if ring == 0 { 0 } else { 1 + 2 * ring * (ring - 1) };
        let start = if ring <= self.cuts {
            before(ring)
        } else {
            4 * self.cuts * self.cuts + 2 - before(self.height(ring)) - self.length(ring)
        };
        start + step % self.length(ring)
    }

    fn faces(self) -> Vec<[u32; 3]> {
        let mut faces = Vec::with_capacity(8 * (self.cuts * self.cuts) as usize);
        for (ring, side) in (0..self.cuts).flat_map(|ring| (0..4).map(move |side| (ring, side))) {
            let below = 2 * self.cuts - ring;
            for step in 0..=ring {
                // One of the ring above, between two of the ring below; and the other way round.
                let [near, far] = [side * ring + step, side * (ring + 1) + step];
                let up = |ring: u32, next: u32| [[ring, near], [next, far], [next, far + 1]];
                let down = |ring: u32, next: u32| [[ring, near], [next, far + 1], [ring, near + 1]];
                let number = |face: [[u32; 2]; 3]| face.map(|[ring, step]| self.vertex(ring, step));
                let turned = |[a, b, c]: [u32; 3]| [a, c, b];
                faces.extend([number(up(ring, ring + 1)), turned(number(up(below, below - 1)))]);
                if step < ring {
                    faces.extend([number(down(ring, ring + 1)), turned(number(down(below, below - 1)))]);
                }
            }
        }
        faces
    }

    /// From the centre to the vertex, of length 1. Along edges of the octahedron the steps are equal angles.
    fn direction(self, ring: u32, step: u32) -> Vector {
        let height = self.height(ring);
        // A pole is the first step of every side.
        let (side, along) = (step / height.max(1), step % height.max(1));
        let [a, b, up] = [height - along, along, self.cuts - height]
            .map(|part| (f64::from(part) / f64::from(self.cuts) * FRAC_PI_2).sin());
        // Counter-clockwise, seen from above.
        let [x, z] = [[a, -b], [-b, -a], [-a, b], [b, a]][side as usize];
        let y = if ring <= self.cuts { up } else { -up };
        let length = vector::length([x, y, z]);
        vector::times(1.0 / length, [x, y, z])
    }
}

/// Where the organ has the point of the unit sphere: about 3 wide (x, the right lobe at negative x), 2 high (y), 1.5
/// deep (z, to the front).
fn organ([x, y, z]: Vector) -> Vector {
    // 0 at the tip of the left lobe, 1 in the right one.
    let right = smooth((0.8 - x) / 1.5);
    let thick = 0.34 + 0.66 * right;
    let bell = |centre: f64, width: f64| (-((x - centre) / width).powi(2)).exp();
    // Ends less pointed than those of an ellipsoid.
    let blunt = (1.05 - x * x).powf(-0.22);
    // 0 at the top, 1 at the bottom.
    let low = (0.5 - 0.5 * y).powi(2);
    // The lower edge rises from the right lobe to the left one, with a notch between them.
    let edge = 0.62 * x * low + 0.17 * bell(0.16, 0.12) * low * low;
    // Below, the back is drawn in to the front.
    let hollow = 0.20 * low * smooth(0.3 - z) * bell(-0.2, 0.8);
    let swell = 0.025 * (3.1 * x + 0.4).sin() * (2.3 * y - 0.7).cos();
    [
        1.45 * x + 0.06 * y,
        0.84 * y * blunt * (0.40 + 0.60 * thick) + 0.30 * (1.0 - right) + edge + swell,
        0.70 * z * blunt * thick * (1.0 - 0.5 * low) + hollow - 0.22 * x * x + swell,
    ]
}

/// From 0 at 0 and below to 1 at 1 and above, without a kink.
fn smooth(t: f64) -> f64 {
    let t = t.clamp(0.0, 1.0);
    t * t * (3.0 - 2.0 * t)
}

#[cfg(test)]
mod tests {
    use super::*;
    use onering::defects::Defects;

    #[test]
    fn it_is_closed_at_every_size() {
        for (asked, vertices) in [(0, 18), (200, 198), (1_000, 1_026), (20_000, 20_166)] {
            let mesh = of_size(asked);
            assert_eq!((mesh.positions.len(), mesh.faces.len()), (vertices, 2 * vertices - 4));
            let defects = Defects::of(vertices, &mesh.faces).unwrap();
            assert!(defects.is_clean() && defects.closed && defects.genus == Some(0), "{defects}");
            assert_eq!(defects.isolated_vertices, 0);
        }
    }

    #[test]
    fn its_faces_look_outwards() {
        let mesh = mesh();
        let at = |v: u32| vector::of(mesh.positions[v as usize]);
        let sixths = mesh.faces.iter().map(|&[a, b, c]| vector::dot(at(a), vector::cross(at(b), at(c))));
        let volume = sixths.sum::<f64>() / 6.0;
        assert!((1.0..6.0).contains(&volume), "{volume}");
        // As a sphere it has no face that looks inwards.
        let grid = Grid { cuts: 7 };
        let places = (0..=14).flat_map(|ring| (0..grid.length(ring)).map(move |step| (ring, step)));
        let sphere: Vec<_> = places.map(|(ring, step)| grid.direction(ring, step)).collect();
        let outwards = |[a, b, c]: [u32; 3]| {
            let [a, b, c] = [a, b, c].map(|v| sphere[v as usize]);
            vector::dot(a, vector::cross(b, c)) > 0.0
        };
        assert!(grid.faces().into_iter().all(outwards));
    }
}

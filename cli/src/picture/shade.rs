//! The colour of what is seen.

use super::Surface;
use super::normals;
use onering::vector::{self, Vector};
use onering_io::colour::{Rgb, linear_table, viridis};

/// Red, green and blue in linear light.
pub(crate) type Linear = [f32; 3];

/// Something between clay and tissue.
const SKIN: Rgb = [214, 158, 140];
const TOP: Rgb = [250, 251, 252];
const BOTTOM: Rgb = [222, 227, 233];

/// A lamp far away: where it is (right, up, to who looks), and how strong.
struct Lamp {
    towards: Vector,
    strength: f64,
}

/// The key light from the upper left, a weak one from the right against dark shadows.
const LAMPS: [Lamp; 2] = [
    Lamp { towards: [-0.48, 0.64, 0.60], strength: 0.75 },
    Lamp { towards: [0.82, 0.05, 0.57], strength: 0.20 },
];
/// Light from all around, more of it from above.
const AMBIENT: f64 = 0.21;
/// Halfway between the key light and the eye.
const SHINE: Vector = [-0.268, 0.358, 0.894];
const SHINE_STRENGTH: f64 = 0.10;
const SHINE_POWER: i32 = 24;

/// What the light falls on, as the camera sees it.
pub(crate) struct Shading<'a> {
    faces: &'a [[u32; 3]],
    shares: Option<&'a [f32]>,
    seen: &'a [[f32; 3]],
    normals: &'a [[f32; 3]],
    linear: [f32; 256],
}

impl<'a> Shading<'a> {
    pub(crate) fn new(surface: &Surface<'a>, seen: &'a [[f32; 3]], normals: &'a [[f32; 3]]) -> Self {
        Self { faces: surface.faces, shares: surface.shares, seen, normals, linear: linear() }
    }

    /// The colour of face `f` where the picture has the point.
    pub(crate) fn colour(&self, f: usize, point: [f32; 2]) -> Linear {
        let face = self.faces[f].map(|v| v as usize);
        let corners = face.map(|v| self.seen[v]);
        let weights = weights(corners, point);
        let normal = self.normal(face, corners, weights);
        let share = self
            .shares
            .map_or(0.0, |shares| (0..3).map(|i| weights[i] * f64::from(shares[face[i]])).sum::<f64>());
        let [light, shine] = light(normal).map(|x| x as f32);
        self.tinted(share).map(|channel| channel * light + shine)
    }

    /// Of the side of the face that is seen: smooth within it, and also where faces disagree in orientation.
    fn normal(&self, face: [usize; 3], corners: [[f32; 3]; 3], weights: [f64; 3]) -> Vector {
        let flat = normals::of_face(corners);
        let towards_us = if flat[2] < 0.0 { vector::times(-1.0, flat) } else { flat };
        let smooth = (0..3).fold([0.0; 3], |sum, i| {
            // Of unit length before they are mixed, so that large faces around a corner do not win.
            let corner = vector::direction(vector::of(self.normals[face[i]])).unwrap_or([0.0; 3]);
            let sign = if vector::dot(corner, towards_us) < 0.0 { -1.0 } else { 1.0 };
            vector::plus(sum, vector::times(sign * weights[i], corner))
        });
        vector::direction(smooth).or(vector::direction(towards_us)).unwrap_or([0.0, 0.0, 1.0])
    }

    /// Where it is tinted a little the skin still shows, so that the tint has no edge.
    fn tinted(&self, share: f64) -> Linear {
        let [skin, tint] = [SKIN, viridis(share)].map(|colour| colour.map(|c| self.linear[usize::from(c)]));
        let cover = (share * 5.0).min(1.0) as f32;
        std::array::from_fn(|c| skin[c] + (tint[c] - skin[c]) * cover)
    }
}

/// The weights of the three corners at the point, none below zero: samples are in triangles whose corners were rounded.
fn weights([a, b, c]: [[f32; 3]; 3], [x, y]: [f32; 2]) -> [f64; 3] {
    let side = |p: [f32; 3], q: [f32; 3]| {
        let [px, py, qx, qy] = [p[0] - x, p[1] - y, q[0] - x, q[1] - y].map(f64::from);
        px * qy - py * qx
    };
    let parts = [side(b, c), side(c, a), side(a, b)];
    let sign = parts.iter().sum::<f64>().signum();
    let parts = parts.map(|part| (part * sign).max(0.0));
    let sum: f64 = parts.iter().sum();
    if sum > 0.0 { parts.map(|part| part / sum) } else { [1.0 / 3.0; 3] }
}

/// How much of its colour a surface of this normal gives back, and the shine on it.
fn light(normal: Vector) -> [f64; 2] {
    let lamps = LAMPS.iter().map(|lamp| lamp.strength * vector::dot(normal, lamp.towards).max(0.0));
    let ambient = AMBIENT * (1.0 + 0.4 * normal[1]);
    let shine = SHINE_STRENGTH * vector::dot(normal, SHINE).max(0.0).powi(SHINE_POWER);
    [ambient + lamps.sum::<f64>(), shine]
}

/// What is behind everything, from 0 at the top to 1 at the bottom.
pub(crate) fn background(down: f32) -> Linear {
    let linear = |c: u8| (f32::from(c) / 255.0).powf(2.2);
    std::array::from_fn(|c| linear(TOP[c]) + (linear(BOTTOM[c]) - linear(TOP[c])) * down)
}

fn linear() -> [f32; 256] {
    linear_table().map(|linear| f32::from(linear) / f32::from(u16::MAX))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_are_those_of_the_point() {
        let corners = [[0.0, 0.0, 5.0], [4.0, 0.0, 0.0], [0.0, 4.0, 1.0]];
        assert_eq!(weights(corners, [1.0, 2.0]), [0.25, 0.25, 0.5]);
        assert_eq!(weights([corners[1], corners[0], corners[2]], [1.0, 2.0]), [0.25, 0.25, 0.5]);
        assert_eq!(weights(corners, [-1.0, 0.0])[1], 0.0);
        assert_eq!(weights([[0.0; 3]; 3], [0.0; 2]), [1.0 / 3.0; 3]);
    }

    #[test]
    fn the_key_light_comes_from_the_upper_left_and_nothing_is_black() {
        let of = |normal: Vector| light(vector::direction(normal).unwrap())[0];
        assert!(of([-1.0, 1.0, 1.0]) > of([1.0, 1.0, 1.0]) && of([1.0, 1.0, 1.0]) > of([1.0, -1.0, 0.2]));
        assert!(of([0.0, -1.0, 0.0]) > 0.05);
    }
}

//! One triangle in space, by the positions of its three corners.
use crate::{
    Map, Topology,
    vector::{self, Vector},
};
use core::f64::consts::{FRAC_PI_2, FRAC_PI_3};

/// The corners of a face, counter-clockwise.
pub(crate) type Triangle = [Vector; 3];

/// The positions of the corners of `f`.
#[inline]
pub(crate) fn of<M: Topology + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
    f: M::Face,
) -> Triangle {
    mesh.face_vertices(f).map(|v| vector::of(positions[v]))
}

/// The vector across the face whose length is twice its area.
#[inline]
pub(crate) fn normal([a, b, c]: Triangle) -> Vector {
    vector::cross(vector::minus(b, a), vector::minus(c, a))
}

/// The area.
#[inline]
pub(crate) fn area(triangle: Triangle) -> f64 {
    vector::length(normal(triangle)) / 2.0
}

/// What `of` makes of each corner: the corner itself, then the two that follow it.
#[inline]
pub(crate) fn corners([a, b, c]: Triangle, of: impl Fn(Vector, Vector, Vector) -> f64) -> [f64; 3] {
    [of(a, b, c), of(b, c, a), of(c, a, b)]
}

/// The angle between the directions from a corner to two points, 0 to pi. By the arc tangent, since the arc cosine loses
/// half of the digits of small angles (Kahan).
///
/// The angles of three points have the sum pi, even where points coincide: two of them are then seen from each other at
/// a right angle to the third, three as an equilateral triangle.
#[inline]
pub(crate) fn angle(corner: Vector, p: Vector, q: Vector) -> f64 {
    match (p == corner, q == corner) {
        (true, true) => FRAC_PI_3,
        (false, false) => {
            let (u, v) = (vector::minus(p, corner), vector::minus(q, corner));
            libm::atan2(vector::length(vector::cross(u, v)), vector::dot(u, v))
        }
        _ => FRAC_PI_2,
    }
}

/// The cotangent of the angle; 0 where the three points are on a line, so that what they would stretch without bound
/// counts for nothing.
#[inline]
pub(crate) fn cotangent(corner: Vector, p: Vector, q: Vector) -> f64 {
    let (u, v) = (vector::minus(p, corner), vector::minus(q, corner));
    let sine = vector::length(vector::cross(u, v));
    if sine > 0.0 { vector::dot(u, v) / sine } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    const A: Vector = [0.0, 0.0, 0.0];
    const B: Vector = [3.0, 0.0, 0.0];
    const C: Vector = [0.0, 3.0, 0.0];

    #[test]
    fn a_right_triangle() {
        assert_eq!((normal([A, B, C]), area([A, B, C])), ([0.0, 0.0, 9.0], 4.5));
        let angles = corners([A, B, C], angle);
        assert!(angles.iter().zip([2.0, 1.0, 1.0]).all(|(x, k)| (x - k * FRAC_PI_2 / 2.0).abs() < 1e-15));
        let cotangents = corners([A, B, C], cotangent);
        assert!(cotangents.iter().zip([0.0, 1.0, 1.0]).all(|(x, k)| (x - k).abs() < 1e-15));
    }

    #[test]
    fn angles_have_the_sum_pi_whatever_coincides() {
        let between = [1.0, 0.0, 0.0];
        for triangle in [[A, B, C], [A, B, between], [A, A, B], [A, B, A], [B, A, A], [C, C, C]] {
            let sum: f64 = corners(triangle, angle).iter().sum();
            assert!((sum - core::f64::consts::PI).abs() < 1e-15, "{triangle:?}");
        }
        assert_eq!(corners([A, B, between], cotangent), [0.0; 3]);
    }
}

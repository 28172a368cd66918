//! Vectors in space: `[x, y, z]` in `f64`, whatever the positions are kept in.
//!
//! Coordinates are kept as `f32`, and are summed and multiplied as `f64`: differences of `f32` are then nearly exact,
//! and products of two do not overflow.

/// A vector, or a point, of three coordinates.
pub type Vector = [f64; 3];

/// The position, or another vector of `f32`, in `f64`.
#[inline]
pub fn of(p: [f32; 3]) -> Vector {
    p.map(f64::from)
}

/// The nearest vector of `f32`.
#[inline]
pub fn rounded(a: Vector) -> [f32; 3] {
    a.map(|x| x as f32)
}

/// `a + b`.
#[inline]
pub fn plus(a: Vector, b: Vector) -> Vector {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

/// `a - b`.
#[inline]
pub fn minus(a: Vector, b: Vector) -> Vector {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

/// `s a`.
#[inline]
pub fn times(s: f64, a: Vector) -> Vector {
    a.map(|x| s * x)
}

/// The dot product.
#[inline]
pub fn dot(a: Vector, b: Vector) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The cross product.
#[inline]
pub fn cross(a: Vector, b: Vector) -> Vector {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// The length.
#[inline]
pub fn length(a: Vector) -> f64 {
    libm::sqrt(dot(a, a))
}

/// The distance of two points.
#[inline]
pub fn distance(p: Vector, q: Vector) -> f64 {
    length(minus(q, p))
}

/// The vector of length 1 in the direction of `a`; `None` where `a` has no direction: length zero, or not finite.
#[inline]
pub fn direction(a: Vector) -> Option<Vector> {
    let length = length(a);
    (length > 0.0 && length.is_finite()).then(|| times(1.0 / length, a))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products() {
        let [x, y, z] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        assert_eq!((cross(x, y), cross(y, z), cross(z, x)), (z, x, y));
        assert_eq!(dot(plus(x, times(2.0, y)), minus(y, z)), 2.0);
        assert_eq!((length([2.0, 3.0, 6.0]), distance(x, [3.0, 3.0, 6.0])), (7.0, 7.0));
    }

    #[test]
    fn no_direction() {
        assert_eq!(direction([0.0, -2.0, 0.0]), Some([0.0, -1.0, 0.0]));
        assert!([[0.0; 3], [f64::NAN; 3], [f64::INFINITY, 0.0, 0.0]].iter().all(|&a| direction(a).is_none()));
    }
}

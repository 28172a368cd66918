//! From where a picture is taken.

use onering::vector::{self, Vector};

/// The share of a picture that is left free along each side.
pub(crate) const MARGIN: f64 = 0.06;

/// Height over width of a picture: as the surface is, but within these.
const SHAPES: [f64; 2] = [0.4, 1.25];

/// Three directions at right angles: to the right in the picture, up in it, and out of it to who looks.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axes {
    right: Vector,
    up: Vector,
    back: Vector,
}

impl Axes {
    /// Looks from `back` towards the mesh, with `up` upwards; `None` where these do not span a plane.
    pub(crate) fn looking_from(back: Vector, up: Vector) -> Option<Self> {
        let back = vector::direction(back)?;
        let right = vector::cross(vector::direction(up)?, back);
        // Nearly parallel ones tell no direction that is more than rounding.
        let right = vector::direction(right).filter(|_| vector::length(right) > 1e-6)?;
        Some(Self { right, up: vector::cross(back, right), back })
    }
}

/// A camera without perspective: lengths in the picture do not depend on depth.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Camera {
    axes: Axes,
    /// What is in the middle of the picture, along each axis.
    middle: Vector,
    /// Pixels for a unit of length.
    scale: f64,
    /// Pixels.
    pub(crate) width: usize,
    pub(crate) height: usize,
}

impl Camera {
    /// Shows all points, in a picture of this width.
    pub(crate) fn fitted<'a, P>(axes: Axes, points: impl Fn() -> P, width: usize) -> Self
    where
        P: Iterator<Item = &'a [f32; 3]>,
    {
        let [right, up, back] = [axes.right, axes.up, axes.back].map(|axis| extent(axis, points()));
        let sizes = [right, up].map(|[least, most]| most - least);
        let shape = if sizes[0] > 0.0 { sizes[1] / sizes[0] } else { 1.0 };
        let height = (width as f64 * shape.clamp(SHAPES[0], SHAPES[1])).round();
        let free = 1.0 - 2.0 * MARGIN;
        let scale = (free * width as f64 / sizes[0]).min(free * height / sizes[1]);
        Self {
            axes,
            middle: [right, up, back].map(|[least, most]| least + (most - least) / 2.0),
            scale: if scale.is_finite() { scale } else { 1.0 },
            width,
            height: height as usize,
        }
    }

    /// Right, up and out of the picture from its middle, in so many steps a pixel.
    pub(crate) fn see(&self, p: [f32; 3], steps: f64) -> [f32; 3] {
        let Axes { right, up, back } = self.axes;
        let along = |i: usize, axis: Vector| {
            ((vector::dot(axis, vector::of(p)) - self.middle[i]) * self.scale * steps) as f32
        };
        [along(0, right), along(1, up), along(2, back)]
    }
}

/// The least and the largest coordinate along the axis; zeros where there are no points.
fn extent<'a>(axis: Vector, points: impl Iterator<Item = &'a [f32; 3]>) -> [f64; 2] {
    let widen = |[least, most]: [f64; 2], &p: &[f32; 3]| {
        let x = vector::dot(axis, vector::of(p));
        [least.min(x), most.max(x)]
    };
    let [least, most] = points.fold([f64::INFINITY, f64::NEG_INFINITY], widen);
    if least <= most { [least, most] } else { [0.0; 2] }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn corners_of_a_box_are_within_the_margin_of_its_camera() {
        let axes = Axes::looking_from([1.0, 0.7, 0.4], [0.0, 1.0, 0.0]).unwrap();
        let points: Vec<[f32; 3]> =
            (0..8).map(|i| [i & 1, i >> 1 & 1, i >> 2].map(|bit| bit as f32 * 3e20 - 1e20)).collect();
        let camera = Camera::fitted(axes, || points.iter(), 300);
        let half = [camera.width, camera.height].map(|size| size as f64 * (0.5 - MARGIN) + 0.01);
        let seen: Vec<_> = points.iter().map(|&p| camera.see(p, 1.0)).collect();
        assert!(seen.iter().all(|p| (0..2).all(|i| f64::from(p[i].abs()) <= half[i])), "{seen:?}");
        assert!(seen.iter().any(|p| f64::from(p[0]) > half[0] - 0.1));
    }

    #[test]
    fn directions_that_span_no_plane_are_refused() {
        assert!(Axes::looking_from([0.0, 2.0, 0.0], [0.0, 1.0, 0.0]).is_none());
        assert!(Axes::looking_from([0.0; 3], [0.0, 1.0, 0.0]).is_none());
        let axes = Axes::looking_from([0.0, 0.0, 5.0], [0.0, 1.0, 1.0]).unwrap();
        assert_eq!((axes.right, axes.up), ([1.0, 0.0, 0.0], [0.0, 1.0, 0.0]));
    }
}

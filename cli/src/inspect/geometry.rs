//! What positions give: box, area, volume. Sums are in `f64`.

/// The figures of positions; nothing where there are none or one is infinite or no number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Geometry {
    pub(crate) bbox_min: [f32; 3],
    pub(crate) bbox_max: [f32; 3],
    /// Of all triangles, copies and both sides of folds included.
    pub(crate) area: f64,
    /// Of the cones from the origin to the triangles: the volume within, where the surface is closed.
    pub(crate) signed_volume: f64,
}

impl Geometry {
    pub(crate) fn of(positions: &[[f32; 3]], faces: &[[u32; 3]]) -> Option<Self> {
        let first = *positions.first()?;
        if !are_finite(positions) {
            return None;
        }
        let bound = |choose: fn(f32, f32) -> f32| {
            positions.iter().fold(first, |a, b| std::array::from_fn(|i| choose(a[i], b[i])))
        };
        let corners = |face: &[u32; 3]| face.map(|v| positions[v as usize].map(f64::from));
        let twice_area = |[a, b, c]: [[f64; 3]; 3]| {
            let normal = cross(minus(b, a), minus(c, a));
            dot(normal, normal).sqrt()
        };
        let six_volumes = |[a, b, c]: [[f64; 3]; 3]| dot(a, cross(b, c));
        Some(Self {
            bbox_min: bound(f32::min),
            bbox_max: bound(f32::max),
            area: faces.iter().map(corners).map(twice_area).sum::<f64>() / 2.0,
            signed_volume: faces.iter().map(corners).map(six_volumes).sum::<f64>() / 6.0,
        })
    }
}

pub(crate) fn are_finite(positions: &[[f32; 3]]) -> bool {
    positions.as_flattened().iter().all(|x| x.is_finite())
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| a[i] - b[i])
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[cfg(test)]
mod tests {
    use super::*;

    const TETRAHEDRON: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];

    #[test]
    fn a_tetrahedron_away_from_the_origin() {
        let positions = [[1.0, 1.0, 1.0], [3.0, 1.0, 1.0], [1.0, 3.0, 1.0], [1.0, 1.0, 3.0]];
        let found = Geometry::of(&positions, &TETRAHEDRON).unwrap();
        assert_eq!((found.bbox_min, found.bbox_max), ([1.0; 3], [3.0; 3]));
        // Three right triangles of area 2, one of sides sqrt(8); a sixth of a cube of side 2.
        assert!((found.area - (6.0 + 12.0_f64.sqrt())).abs() < 1e-12);
        assert!((found.signed_volume - 8.0 / 6.0).abs() < 1e-12);
    }

    #[test]
    fn nothing_without_numbers() {
        assert_eq!(Geometry::of(&[], &[]), None);
        assert_eq!(Geometry::of(&[[0.0, f32::NAN, 0.0]], &[]), None);
        assert!(Geometry::of(&[[0.0; 3]], &[]).is_some_and(|found| found.area == 0.0));
    }
}

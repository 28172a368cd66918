//! The vertex nearest to a point: where a tool touches the surface, the first step of the deformation that
//! Biscaro et al. (2016, section 2.1) describe.
use crate::{
    Handle, Map,
    vector::{self, Vector},
};

/// The vertex nearest to a point, of those at the same distance the least.
///
/// # Returns
/// `None` where there is no vertex with a finite position, or where the point itself is not finite.
///
/// # Complexity
/// O(vertices), one pass without memory. Where many points are asked for, the feature `kd-tree` has `Tree`.
///
/// # Example
/// ```
/// use onering_core::{Handle, Map, VertexId, nearest};
/// let positions: Map<VertexId, [f32; 3]> = vec![[0.0; 3], [2.0, 0.0, 0.0], [f32::NAN; 3]].into();
/// assert_eq!(nearest::nearest_vertex(&positions, [1.5, 0.5, 0.0]), Some(VertexId::new(1)));
/// assert_eq!(nearest::nearest_vertex(&positions, [1.0, 0.0, 0.0]), Some(VertexId::new(0)));
/// ```
///
/// # Source
/// Biscaro et al. (2016), section 2.1.
pub fn nearest_vertex<V: Handle>(positions: &Map<V, [f32; 3]>, point: Vector) -> Option<V> {
    let mut best = (f64::INFINITY, None);
    for (v, &p) in positions {
        // An infinite distance is not less than the first, and neither is what is no number.
        let distance = squared_distance(vector::of(p), point);
        if distance < best.0 {
            best = (distance, Some(v));
        }
    }
    best.1
}

fn squared_distance(p: Vector, q: Vector) -> f64 {
    let d = vector::minus(p, q);
    vector::dot(d, d)
}

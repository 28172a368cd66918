//! The vertex nearest to a point: where a tool touches the surface, the first step of the deformation that
//! Biscaro et al. (2016, section 2.1) describe.
#[cfg(feature = "kd-tree")]
mod tree;

#[cfg(feature = "kd-tree")]
pub use tree::Tree;

use crate::{
    Handle, Map,
    vector::{self, Vector},
};

/// The vertex nearest to a point; of those at the same distance, the least.
///
/// # Arguments
/// Vertices whose position is infinite or no number are passed over.
///
/// # Returns
/// `None` where there is no vertex to give, or where the point is infinite or no number.
///
/// # Complexity
/// O(vertices), one pass without memory. To ask for many points, turn on the feature `kd-tree`, which has `Tree`.
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
        // What is infinite or no number is not less than infinity.
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

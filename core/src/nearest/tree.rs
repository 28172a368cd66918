//! [`Tree`]: many nearest vertices of the same positions.
use super::squared_distance;
use crate::{
    Handle, Map,
    vector::{self, Vector},
};
use alloc::vec::Vec;
use rstar::{AABB, PointDistance, RTree, RTreeObject};

/// The positions of vertices, sorted in space, to find the nearest to many points (feature `kd-tree`).
///
/// It answers as [`nearest_vertex`](super::nearest_vertex) does. The tree is one of boxes, each with at most six boxes or
/// positions, of the crate `rstar`.
///
/// ```
/// use onering_core::{Handle, Map, VertexId, nearest::Tree};
/// let positions: Map<VertexId, [f32; 3]> = vec![[0.0; 3], [2.0, 0.0, 0.0], [f32::NAN; 3]].into();
/// let tree = Tree::new(&positions);
/// assert_eq!(tree.nearest([1.5, 0.5, 0.0]), Some(VertexId::new(1)));
/// assert_eq!(tree.nearest([1.0, 0.0, 0.0]), Some(VertexId::new(0)));
/// ```
#[derive(Clone, Debug)]
pub struct Tree<V: Handle> {
    tree: RTree<Placed<V>>,
}

impl<V: Handle> Tree<V> {
    /// Sorts the positions; those that are infinite or no number are left out. O(n log n); about 100 bytes for each.
    pub fn new(positions: &Map<V, [f32; 3]>) -> Self {
        let placed = positions.iter().map(|(v, &p)| Placed { position: vector::of(p), v });
        let mut placed: Vec<_> = placed.filter(|p| p.position.iter().all(|x| x.is_finite())).collect();
        // Of vertices at the same place the least is the answer: a heap of them would be searched for each point.
        placed.sort_unstable_by(|a, b| a.key().partial_cmp(&b.key()).expect("finite"));
        placed.dedup_by_key(|p| p.position);
        Self { tree: RTree::bulk_load(placed) }
    }

    /// The vertex nearest to a point; of those at the same distance, the least. `None` where there is no vertex, or
    /// where the point is infinite or no number.
    ///
    /// O(log n) for points near to a surface; O(n log n) at worst, for the centre of a sphere on which all vertices
    /// lie.
    pub fn nearest(&self, point: Vector) -> Option<V> {
        if !point.iter().all(|x| x.is_finite()) {
            return None;
        }
        let mut nearest = self.tree.nearest_neighbor_iter_with_distance_2(point);
        let (first, distance) = nearest.next()?;
        let ties = nearest.take_while(|&(_, other)| other == distance).map(|(p, _)| p.v);
        // A point so far off that its squared distance overflows is nearest to none, as for `nearest_vertex`.
        distance.is_finite().then(|| ties.fold(first.v, V::min))
    }
}

/// A vertex and its position.
#[derive(Clone, Debug)]
struct Placed<V> {
    position: Vector,
    v: V,
}

impl<V: Handle> Placed<V> {
    fn key(&self) -> (Vector, V) {
        (self.position, self.v)
    }
}

impl<V: Handle> RTreeObject for Placed<V> {
    type Envelope = AABB<Vector>;

    fn envelope(&self) -> AABB<Vector> {
        AABB::from_point(self.position)
    }
}

impl<V: Handle> PointDistance for Placed<V> {
    fn distance_2(&self, point: &Vector) -> f64 {
        squared_distance(self.position, *point)
    }
}

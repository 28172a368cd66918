//! [`Rows`]: the springs of each vertex, as its ring is walked.
use super::{SpringError, Stiffness};
use crate::{
    Handle, Incidence, Map,
    vector::{self, Vector},
};
use alloc::vec::Vec;

/// The neighbours of every vertex with the stiffness of the springs to them: the rows of a sparse matrix without its
/// diagonal, each in the order of [`Incidence::neighbours`]. 12 bytes for each, two for each edge.
#[derive(Clone, Debug)]
pub(super) struct Rows<V> {
    /// Where the row of each vertex starts, and the end of the last.
    starts: Vec<usize>,
    neighbours: Vec<V>,
    stiffness: Vec<f64>,
}

impl<V: Handle> Rows<V> {
    /// Walks every ring once, and checks the springs.
    pub(super) fn new<M: Incidence<Vertex = V>>(
        mesh: &M,
        positions: &Map<V, [f32; 3]>,
        stiffness: &Stiffness<M::HalfEdge>,
    ) -> Result<Self, SpringError> {
        let mut rows = Self {
            starts: Vec::with_capacity(mesh.vertex_count() + 1),
            neighbours: Vec::new(),
            stiffness: Vec::new(),
        };
        rows.starts.push(0);
        // The value of the edge to each neighbour of the vertex at hand; that of others is left from before.
        let mut along = Map::filled(mesh.vertex_count(), 0.0);
        for v in mesh.vertices() {
            if let Stiffness::Each(each) = stiffness {
                for h in mesh.star(v) {
                    let p = mesh.prev(h);
                    along[mesh.target(h)] = each[least(mesh, h)];
                    along[mesh.origin(p)] = each[least(mesh, p)];
                }
            }
            let mut sum = 0.0;
            for u in mesh.neighbours(v) {
                let vertices = [v.min(u).index(), v.max(u).index()];
                let length =
                    vector::length(vector::minus(vector::of(positions[u]), vector::of(positions[v])));
                if length == 0.0 {
                    return Err(SpringError::ZeroLength { vertices });
                }
                let value = match stiffness {
                    Stiffness::Same(k) => *k,
                    Stiffness::OverLength(k) => k / length,
                    Stiffness::Each(_) => along[u],
                };
                sum += value;
                if !(value >= 0.0 && f64::is_finite(sum)) {
                    return Err(SpringError::Stiffness { vertices, value });
                }
                rows.neighbours.push(u);
                rows.stiffness.push(value);
            }
            rows.starts.push(rows.neighbours.len());
        }
        Ok(rows)
    }

    /// The neighbours of `v`.
    #[inline]
    pub(super) fn neighbours(&self, v: V) -> impl Iterator<Item = V> {
        self.neighbours[self.starts[v.index()]..self.starts[v.index() + 1]].iter().copied()
    }

    /// The stiffness of the springs to the neighbours of `v`, in their order.
    #[inline]
    pub(super) fn stiffness(&self, v: V) -> &[f64] {
        &self.stiffness[self.starts[v.index()]..self.starts[v.index() + 1]]
    }

    /// The force of the springs on `v`, Eq. (9), where `neighbours` are those of `v` in the order of the rows.
    #[inline(always)]
    pub(super) fn force(&self, v: V, neighbours: impl Iterator<Item = V>, displacement: &[Vector]) -> Vector {
        let mut stiffness = self.stiffness(v).iter();
        let own = displacement[v.index()];
        neighbours.fold([0.0; 3], |f, u| {
            let k = stiffness.next().map_or(0.0, |&k| k);
            vector::plus(f, vector::times(k, vector::minus(displacement[u.index()], own)))
        })
    }
}

/// The least half-edge along the edge of `h`: the others of its fan are in ascending order.
fn least<M: Incidence>(mesh: &M, h: M::HalfEdge) -> M::HalfEdge {
    mesh.edge_fan(h).nth(1).map_or(h, |other| other.min(h))
}

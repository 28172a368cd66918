//! What moves each vertex in Loop subdivision, gathered edge by edge: so no mesh has to start from a vertex.
use crate::vector::{Vector, plus, times};
use crate::{Adjacency, BuildError, Handle, Map, memory, umbrella, vector};

/// What lies around one vertex, as far as it has been seen.
#[derive(Clone, Copy, Default)]
struct Around {
    neighbours: u32,
    creases: u32,
    umbrellas: u32,
    sum: Vector,
    /// Of the far ends of the creases.
    crease_sum: Vector,
}

/// The surroundings of every vertex.
pub(super) struct Rules<V> {
    around: Map<V, Around>,
}

impl<V: Handle> Rules<V> {
    /// With the umbrellas counted, and no edges yet.
    pub(super) fn of<M: Adjacency<Vertex = V> + ?Sized>(mesh: &M) -> Result<Self, BuildError> {
        let mut around: Map<V, Around> = memory::filled(mesh.vertex_count(), Around::default())?.into();
        let umbrella = umbrella::umbrellas(mesh);
        for h in mesh.half_edges().filter(|&h| umbrella[h] == h) {
            around[mesh.origin(h)].umbrellas += 1;
        }
        Ok(Self { around })
    }

    /// Takes one edge, by a half-edge along it, into account at its ends, and gives the place of its new vertex.
    pub(super) fn add_edge<M: Adjacency<Vertex = V> + ?Sized>(
        &mut self,
        mesh: &M,
        positions: &Map<V, [f32; 3]>,
        h: M::HalfEdge,
    ) -> Vector {
        let at = |v: V| vector::of(positions[v]);
        let ends = [mesh.origin(h), mesh.target(h)];
        let smooth = two_faces(mesh, h);
        for [v, u] in [ends, [ends[1], ends[0]]] {
            let around = &mut self.around[v];
            around.neighbours += 1;
            around.sum = plus(around.sum, at(u));
            if smooth.is_none() {
                around.creases += 1;
                around.crease_sum = plus(around.crease_sum, at(u));
            }
        }
        let ends = plus(at(ends[0]), at(ends[1]));
        match smooth.map(|faces| faces.map(|g| mesh.origin(mesh.prev(g)))) {
            Some([c, d]) => plus(times(0.375, ends), times(0.125, plus(at(c), at(d)))),
            None => times(0.5, ends),
        }
    }

    /// Where vertex `v`, now at `p`, goes when all edges have been seen.
    pub(super) fn moved(&self, v: V, p: Vector) -> Vector {
        let Around { neighbours, creases, umbrellas, sum, crease_sum } = self.around[v];
        match (umbrellas, creases) {
            (1, 0) => {
                let w = weight(neighbours);
                plus(times(1.0 - f64::from(neighbours) * w, p), times(w, sum))
            }
            (1, 2) => plus(times(0.75, p), times(0.125, crease_sum)),
            _ => p,
        }
    }
}

/// The two half-edges along the edge of `h`, where it has just two.
fn two_faces<M: Adjacency + ?Sized>(mesh: &M, h: M::HalfEdge) -> Option<[M::HalfEdge; 2]> {
    let mut others = mesh.edge_fan(h).skip(1);
    let other = others.next()?;
    others.next().is_none().then_some([h, other])
}

/// Loop's weight for each of `n` neighbours.
fn weight(n: u32) -> f64 {
    let n = f64::from(n);
    let root = 0.375 + 0.25 * libm::cos(2.0 * core::f64::consts::PI / n);
    (0.625 - root * root) / n
}

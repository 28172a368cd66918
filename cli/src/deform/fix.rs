//! Which vertices are held.

use crate::args::Fix;
use onering::k_ring;
use onering::vector;
use onering::{Handle, Incidence, Map};

/// The vertices that stay, where vertex `at` is pressed. O(half-edges) questions to the mesh, and O(n log n) for the
/// farthest.
///
/// # Errors
/// In words: no such vertex, or none at all, so that nothing would come to rest.
pub(crate) fn held<M: Incidence>(
    fix: &Fix,
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
    at: M::Vertex,
) -> Result<Vec<M::Vertex>, String> {
    let count = mesh.vertex_count();
    let held = match fix {
        Fix::Boundary => boundary(mesh),
        Fix::Farthest(percent) => farthest(positions, at, *percent),
        Fix::Beyond(rings) => {
            let mut is_near = Map::filled(count, false);
            let near = k_ring::k_ring(mesh, at, *rings);
            near.within(*rings).iter().chain([&at]).for_each(|&v| is_near[v] = true);
            mesh.vertices().filter(|&v| !is_near[v]).collect()
        }
        &Fix::Below(axis, value) => {
            mesh.vertices().filter(|&v| f64::from(positions[v][axis]) < value).collect()
        }
        Fix::Vertices(vertices) => match vertices.iter().find(|&&v| v >= count) {
            Some(v) => return Err(format!("--fix {v}: there is no vertex {v}: there are {count}, from 0")),
            None => vertices.iter().map(|&v| M::Vertex::new(v)).collect(),
        },
    };
    if held.is_empty() {
        return Err("--fix holds no vertex, so nothing comes to rest under a force".into());
    }
    Ok(held)
}

fn boundary<M: Incidence>(mesh: &M) -> Vec<M::Vertex> {
    let mut is_on = Map::filled(mesh.vertex_count(), false);
    for h in mesh.half_edges().filter(|&h| mesh.is_boundary(h)) {
        [mesh.origin(h), mesh.target(h)].into_iter().for_each(|v| is_on[v] = true);
    }
    mesh.vertices().filter(|&v| is_on[v]).collect()
}

/// So many vertices in a hundred, those farthest in space, but never `at` itself; of those at the same distance the
/// first ones.
pub(crate) fn farthest<V: Handle>(positions: &Map<V, [f32; 3]>, at: V, percent: f64) -> Vec<V> {
    let distance = |v: V| vector::length(vector::minus(vector::of(positions[v]), vector::of(positions[at])));
    let mut others: Vec<(f64, V)> =
        (0..positions.len()).map(V::new).filter(|&v| v != at).map(|v| (distance(v), v)).collect();
    others.sort_unstable_by(|(a, u), (b, v)| b.total_cmp(a).then(u.cmp(v)));
    others.truncate((positions.len() as f64 * percent / 100.0).ceil() as usize);
    others.into_iter().map(|(_, v)| v).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use onering::{DirectedEdgesSmall, FromFaces, VertexId};

    /// A strip of four faces over six vertices, in space along x.
    fn of(fix: Fix) -> Result<Vec<usize>, String> {
        let faces = [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]];
        let mesh = DirectedEdgesSmall::from_faces(7, &faces).unwrap();
        let positions: Map<VertexId, _> = (0..7).map(|i| [i as f32, 0.0, -(i as f32)]).collect();
        let mut held: Vec<_> =
            held(&fix, &mesh, &positions, VertexId::new(0))?.iter().map(|v| v.index()).collect();
        held.sort_unstable();
        Ok(held)
    }

    #[test]
    fn every_way_to_say_it() {
        assert_eq!(of(Fix::Boundary).unwrap(), [0, 1, 2, 3, 4, 5]);
        assert_eq!(of(Fix::Farthest(25.0)).unwrap(), [5, 6]);
        assert_eq!(of(Fix::Farthest(99.9)).unwrap(), [1, 2, 3, 4, 5, 6]);
        assert_eq!(of(Fix::Beyond(1)).unwrap(), [3, 4, 5, 6]);
        assert_eq!(of(Fix::Below(2, -3.5)).unwrap(), [4, 5, 6]);
        assert_eq!(of(Fix::Vertices(vec![3, 1])).unwrap(), [1, 3]);
        assert!(of(Fix::Below(0, 0.0)).unwrap_err().contains("holds no vertex"));
        assert!(of(Fix::Vertices(vec![7])).unwrap_err().contains("no vertex 7"));
    }
}

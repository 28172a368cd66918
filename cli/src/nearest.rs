//! The vertex that a point on the command line means.

use onering::vector::Vector;
use onering::{Handle, Map, VertexId, nearest};
use onering_io::Triangles;

/// The vertex nearest to the point, of those that faces have: nobody means one that is on no surface. `None` where there
/// is none, or the point is too far away to tell. O(vertices + faces).
pub(crate) fn nearest(mesh: &Triangles, point: Vector) -> Option<usize> {
    // What is no number is passed over.
    let mut positions: Map<VertexId, _> = Map::filled(mesh.positions.len(), [f32::NAN; 3]);
    mesh.faces.as_flattened().iter().for_each(|&v| {
        positions[VertexId::new(v as usize)] = mesh.positions[v as usize];
    });
    nearest::nearest_vertex(&positions, point).map(Handle::index)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vertices_without_faces_are_passed_over() {
        let positions = vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.9; 3]];
        let mesh = Triangles::new(positions, vec![[1, 2, 3]]);
        assert_eq!(nearest(&mesh, [0.1, 0.1, 0.2]), Some(3));
        assert_eq!(nearest(&mesh, [9.0, 0.0, 0.0]), Some(1));
        assert_eq!(nearest(&mesh, [1e300, 0.0, 0.0]), None);
        assert_eq!(nearest(&Triangles::new(vec![[0.0; 3]], vec![]), [0.0; 3]), None);
    }
}

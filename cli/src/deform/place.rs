//! Where a mesh is pressed.

use crate::args::At;
use crate::failure::Failure;
use onering::vector::{self, Vector};
use onering::{Handle, Map, VertexId, nearest};
use onering_io::Triangles;

/// To the left, top and front: where a made organ is thick, and the light of the picture comes from.
const LEFT_TOP_FRONT: Vector = [-0.4, 0.5, 1.0];

/// Refuses what cannot be pressed.
pub(crate) fn check(name: &str, mesh: &Triangles) -> Result<(), Failure> {
    let problem = if mesh.faces.is_empty() {
        "there are no faces, so no springs".into()
    } else if let Some(v) = mesh.positions.iter().position(|p| p.iter().any(|x| !x.is_finite())) {
        format!("vertex {v} has a coordinate that is infinite or no number")
    } else {
        return Ok(());
    };
    Err(Failure::Output(format!("{name}: {problem}")))
}

/// The vertex to press, of a mesh with faces.
pub(crate) fn of(at: Option<At>, mesh: &Triangles) -> Result<usize, Failure> {
    let count = mesh.positions.len();
    let along = |v: u32| vector::dot(vector::of(mesh.positions[v as usize]), LEFT_TOP_FRONT);
    let nearest = |point| {
        let positions: Map<VertexId, _> = mesh.positions.clone().into();
        nearest::nearest_vertex(&positions, point).map(Handle::index)
    };
    let found = match at {
        Some(At::Vertex(v)) if v < count => Some(v),
        Some(At::Vertex(v)) => {
            return Err(Failure::Usage(format!(
                "--at {v}: there is no vertex {v}: there are {count}, from 0"
            )));
        }
        Some(At::Point(point)) => nearest(point),
        // Of vertices in faces: others could not be pressed.
        None => mesh
            .faces
            .as_flattened()
            .iter()
            .copied()
            .max_by(|&u, &v| along(u).total_cmp(&along(v)))
            .map(|v| v as usize),
    };
    found.ok_or_else(|| Failure::Usage("--at: no vertex is near this point, which is too far away".into()))
}

/// The direction out of the surface at the vertex; `None` where its faces have none. O(faces).
pub(crate) fn normal(mesh: &Triangles, at: usize) -> Option<Vector> {
    let around = mesh.faces.iter().filter(|face| face.contains(&(at as u32)));
    let area = |face: &[u32; 3]| {
        let [a, b, c] = face.map(|v| vector::of(mesh.positions[v as usize]));
        vector::cross(vector::minus(b, a), vector::minus(c, a))
    };
    vector::direction(around.map(area).fold([0.0; 3], vector::plus))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::made::organ;

    #[test]
    fn a_point_leads_to_the_nearest_vertex_and_nothing_to_the_left_front() {
        let mesh = organ::of_size(500);
        let p = mesh.positions[77].map(|x| f64::from(x) + 1e-4);
        assert_eq!(of(Some(At::Point(p)), &mesh).unwrap(), 77);
        let v = of(None, &mesh).unwrap();
        let along = |p: &[f32; 3]| vector::dot(vector::of(*p), LEFT_TOP_FRONT);
        assert!(mesh.positions.iter().all(|p| along(p) <= along(&mesh.positions[v])));
        assert!(vector::dot(normal(&mesh, v).unwrap(), LEFT_TOP_FRONT) > 0.0);
        assert!(of(Some(At::Vertex(mesh.positions.len())), &mesh).is_err());
    }
}

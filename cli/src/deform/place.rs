//! Where a mesh is pressed.

use crate::failure::Failure;
use onering::NotFinite;
use onering::vector::{self, Vector};
use onering_io::Triangles;

/// To the left, top and front: where a made organ is thick, and the light of the picture comes from.
const LEFT_TOP_FRONT: Vector = [-0.4, 0.5, 1.0];

/// Refuses what cannot be pressed.
pub(crate) fn check(name: &str, mesh: &Triangles) -> Result<(), Failure> {
    let problem = if mesh.faces.is_empty() {
        "there are no faces, so no springs".into()
    } else if let Some(vertex) = mesh.positions.iter().position(|p| p.iter().any(|x| !x.is_finite())) {
        NotFinite { vertex }.to_string()
    } else {
        return Ok(());
    };
    Err(Failure::Output(format!("{name}: {problem}")))
}

/// The vertex to press where none is named, of a mesh with faces: a vertex in one, as others could not be pressed.
pub(crate) fn usual(mesh: &Triangles) -> usize {
    let along = |v: u32| vector::dot(vector::of(mesh.positions[v as usize]), LEFT_TOP_FRONT);
    let farthest = mesh.faces.as_flattened().iter().copied().max_by(|&u, &v| along(u).total_cmp(&along(v)));
    farthest.map_or(0, |v| v as usize)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::made::organ;

    #[test]
    fn the_usual_place_is_to_the_left_top_and_front() {
        let mesh = organ::of_size(500);
        let v = usual(&mesh);
        let along = |p: &[f32; 3]| vector::dot(vector::of(*p), LEFT_TOP_FRONT);
        assert!(mesh.positions.iter().all(|p| along(p) <= along(&mesh.positions[v])));
    }
}

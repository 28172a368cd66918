//! Asks for `directed-edges-medium`: it walks fans and takes non-manifold input.
use onering::{BuildError, FromFaces, Incidence, Mesh};

/// Three faces on one edge, which the preset holds.
pub fn book() -> Result<Mesh, BuildError> {
    Mesh::from_faces(5, &[[0, 1, 2], [1, 0, 3], [0, 1, 4]])
}

/// The largest number of fans around a vertex.
pub fn most_fans(mesh: &Mesh) -> Option<usize> {
    use onering::Topology;
    mesh.vertices().map(|v| mesh.fans(v).count()).max()
}

//! tri-mesh: built from the mesh type of three-d-asset, the only way that there is.

use super::Structure;
use crate::mesh::{Mesh as Arrays, ring_sum};
use three_d_asset::prelude::vec3;
use three_d_asset::{Indices, Positions, TriMesh};

pub(super) struct Mesh(tri_mesh::Mesh);

pub(super) struct Input(TriMesh);

impl From<&Arrays> for Input {
    fn from(mesh: &Arrays) -> Self {
        let positions = mesh.positions.iter().map(|p| p.map(f64::from)).map(|[x, y, z]| vec3(x, y, z));
        Self(TriMesh {
            positions: Positions::F64(positions.collect()),
            indices: Indices::U32(mesh.faces.as_flattened().to_vec()),
            ..TriMesh::default()
        })
    }
}

impl Structure for Mesh {
    type Input<'a> = Input;

    fn build(input: Input) -> Result<Self, String> {
        Ok(Self(tri_mesh::Mesh::new(&input.0)))
    }

    fn sweep(&self) -> Option<u64> {
        let target = |h| self.0.walker_from_halfedge(h).vertex_id();
        let ring = |v: tri_mesh::VertexID| {
            ring_sum(*v, self.0.vertex_halfedge_iter(v).filter_map(target).map(|u| *u))
        };
        Some(self.0.vertex_iter().map(ring).fold(0, u64::wrapping_add))
    }
}

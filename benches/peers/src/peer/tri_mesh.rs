//! tri-mesh: built from the mesh type of three-d-asset, the only way that there is.

use super::{Structure, walk::Walk};
use crate::mesh::Mesh as Arrays;
use three_d_asset::prelude::vec3;
use three_d_asset::{Indices, Positions, TriMesh};
use tri_mesh::VertexID;

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
}

impl Walk for Mesh {
    type Vertex = VertexID;

    fn vertices(&self) -> impl Iterator<Item = VertexID> {
        self.0.vertex_iter()
    }

    #[inline(always)]
    fn index(v: VertexID) -> u32 {
        *v
    }

    #[inline(always)]
    fn ring(&self, v: VertexID, visit: impl FnMut(VertexID)) {
        let target = |h| self.0.walker_from_halfedge(h).vertex_id();
        self.0.vertex_halfedge_iter(v).filter_map(target).for_each(visit);
    }
}

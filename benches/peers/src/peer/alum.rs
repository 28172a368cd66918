//! alum: its half-edge mesh with everything reserved exactly, as OpenMesh, which it follows.

use super::{Structure, walk::Walk};
use crate::mesh::Mesh as Arrays;
use alum::{Handle, HasIterators, HasTopology, PolyMeshF32, VH, Vec3};

pub(super) struct Mesh(PolyMeshF32);

impl Structure for Mesh {
    type Input<'a> = &'a Arrays;

    fn build(arrays: &Arrays) -> Result<Self, String> {
        let mut mesh =
            PolyMeshF32::with_capacity(arrays.positions.len(), arrays.edge_count, arrays.faces.len());
        for &[x, y, z] in &arrays.positions {
            mesh.add_vertex(Vec3(x, y, z)).map_err(|error| format!("{error:?}"))?;
        }
        for face in &arrays.faces {
            mesh.add_face(&face.map(VH::from)).map_err(|error| format!("{error:?}"))?;
        }
        Ok(Self(mesh))
    }
}

impl Walk for Mesh {
    type Vertex = VH;

    fn vertices(&self) -> impl Iterator<Item = VH> {
        self.0.vertices()
    }

    #[inline(always)]
    fn index(v: VH) -> u32 {
        v.index()
    }

    #[inline(always)]
    fn ring(&self, v: VH, visit: impl FnMut(VH)) {
        self.0.vv_ccw_iter(v).for_each(visit);
    }
}

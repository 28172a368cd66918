//! alum: its half-edge mesh with everything reserved exactly, as OpenMesh, which it follows.

use super::Structure;
use crate::mesh::{Mesh as Arrays, ring_sum};
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

    fn sweep(&self) -> Option<u64> {
        let ring = |v: VH| ring_sum(v.index(), self.0.vv_ccw_iter(v).map(|u| u.index()));
        Some(self.0.vertices().map(ring).fold(0, u64::wrapping_add))
    }
}

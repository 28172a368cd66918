//! halfedge: built by its one function for triangles, walked by its iterator that does not allocate.

use super::{Structure, walk::Walk};
use crate::mesh::Mesh as Arrays;
use halfedge::traversal::VertexAdjacentVertsLazy;
use halfedge::{MeshStorage, VertexId, build_mesh_from_vertices_and_faces};
use slotmap::Key;

pub(super) struct Mesh(MeshStorage);

/// Positions are of `f64` there.
pub(super) struct Input<'a> {
    positions: Vec<[f64; 3]>,
    faces: &'a [[u32; 3]],
}

impl<'a> From<&'a Arrays> for Input<'a> {
    fn from(mesh: &'a Arrays) -> Self {
        Self { positions: mesh.positions.iter().map(|p| p.map(f64::from)).collect(), faces: &mesh.faces }
    }
}

impl Structure for Mesh {
    type Input<'a> = Input<'a>;

    fn build(input: Input<'_>) -> Result<Self, String> {
        build_mesh_from_vertices_and_faces(&input.positions, input.faces)
            .map(Self)
            .map_err(|error| format!("{error:?}"))
    }
}

impl Walk for Mesh {
    type Vertex = VertexId;

    fn vertices(&self) -> impl Iterator<Item = VertexId> {
        self.0.vertex_ids()
    }

    /// Slots are counted from one, and stand in the lower half.
    #[inline(always)]
    fn index(v: VertexId) -> u32 {
        (v.data().as_ffi() as u32).wrapping_sub(1)
    }

    #[inline(always)]
    fn ring(&self, v: VertexId, visit: impl FnMut(VertexId)) {
        VertexAdjacentVertsLazy::new(&self.0, v).for_each(visit);
    }
}

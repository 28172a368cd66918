//! lox: vertices and faces are reserved and added one by one, the only way that there is. Its configurations are those
//! for triangles, with what they store by default.

use super::{Structure, walk::Walk};
use crate::mesh::Mesh;
use lox::VertexHandle;
use lox::prelude::{Empty, FullAdj, Handle, MeshMut};

pub(super) use lox::core::half_edge::TriConfig;
pub(super) use lox::core::{DirectedEdgeMesh, HalfEdgeMesh, SharedVertexMesh};

/// A structure that has no rings to walk.
pub(super) struct NoRings<M>(#[allow(dead_code, reason = "held, so that its bytes are counted")] M);
/// A structure that has.
pub(super) struct Rings<M>(M);

fn build<M: Empty + MeshMut>(mesh: &Mesh) -> M {
    let mut built = M::empty();
    built.reserve_for_vertices(mesh.positions.len() as u32);
    built.reserve_for_faces(mesh.faces.len() as u32);
    for _ in &mesh.positions {
        built.add_vertex();
    }
    for &face in &mesh.faces {
        built.add_triangle(face.map(Handle::new));
    }
    built
}

impl<M: Empty + MeshMut> Structure for NoRings<M> {
    type Input<'a> = &'a Mesh;

    fn build(mesh: &Mesh) -> Result<Self, String> {
        Ok(Self(build(mesh)))
    }
}

impl<M: Empty + MeshMut> Structure for Rings<M> {
    type Input<'a> = &'a Mesh;

    fn build(mesh: &Mesh) -> Result<Self, String> {
        Ok(Self(build(mesh)))
    }
}

impl<M: Empty + MeshMut + FullAdj> Walk for Rings<M> {
    type Vertex = VertexHandle;

    fn vertices(&self) -> impl Iterator<Item = VertexHandle> {
        self.0.vertex_handles()
    }

    #[inline(always)]
    fn index(v: VertexHandle) -> u32 {
        v.idx()
    }

    #[inline(always)]
    fn ring(&self, v: VertexHandle, visit: impl FnMut(VertexHandle)) {
        self.0.vertices_around_vertex(v).for_each(visit);
    }
}

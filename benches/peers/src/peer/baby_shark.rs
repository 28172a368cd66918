//! baby_shark: its corner table through the builder, which is told the counts.

use super::{Structure, walk::Walk};
use crate::mesh::Mesh as Arrays;
use baby_shark::io::{Builder, IndexedBuilder};
use baby_shark::mesh::corner_table::{CornerTableF, VertexId};
use std::hash::{Hash, Hasher};

pub(super) struct Mesh(CornerTableF);

/// Keeps the number that is hashed: the index of a vertex is not public, but its hash is that of a `u32`.
struct Index(u32);

impl Hasher for Index {
    fn write(&mut self, _: &[u8]) {
        unreachable!("a vertex is hashed as a `u32`");
    }

    fn write_u32(&mut self, i: u32) {
        self.0 = i;
    }

    fn finish(&self) -> u64 {
        self.0.into()
    }
}

impl Structure for Mesh {
    type Input<'a> = &'a Arrays;

    fn build(mesh: &Arrays) -> Result<Self, String> {
        let mut builder = CornerTableF::builder_indexed();
        let faces = mesh.faces.iter().map(|face| face.map(|v| v as usize));
        builder.add_vertices(mesh.positions.iter().copied()).map_err(|error| format!("{error:?}"))?;
        builder.add_faces(faces).map_err(|error| format!("{error:?}"))?;
        builder.finish().map(Self).map_err(|error| format!("{error:?}"))
    }
}

impl Walk for Mesh {
    type Vertex = VertexId;

    fn vertices(&self) -> impl Iterator<Item = VertexId> {
        self.0.vertices()
    }

    #[inline(always)]
    fn index(v: VertexId) -> u32 {
        let mut index = Index(0);
        v.hash(&mut index);
        index.0
    }

    #[inline(always)]
    fn ring(&self, v: VertexId, visit: impl FnMut(VertexId)) {
        self.0.vertices_around_vertex(v, visit);
    }
}

//! [`WithOpposites`]: a mesh and a table of opposites.
use crate::{
    Adjacency, Boundaries, BuildError, EdgeMap, Footprint, Handle, Incidence, Map, Pairing, Slot, Topology,
    footprint::Bytes, handle::Handles, memory, pairing,
};
use alloc::vec::Vec;

/// A mesh and a table of opposites: gives [`Adjacency`] to any [`Topology`], whatever its handles.
///
/// Four bytes a half-edge, 12 a face. It is strict: every edge has one half-edge, or two that run in opposite
/// directions. All that the mesh has already is handed on.
///
/// [`Footprint::BYTES`] counts a cell for each half-edge. Where handles have gaps the table has a cell for each
/// gap as well, and only [`heap_bytes`](Footprint::heap_bytes) tells.
#[derive(Clone, Debug)]
pub struct WithOpposites<T: Topology> {
    mesh: T,
    opposite: Map<T::HalfEdge, Slot<T::HalfEdge>>,
}

impl<T: Topology> WithOpposites<T> {
    /// Pairs the half-edges of `mesh`. O(faces); temporary memory is 24 bytes a face and that of
    /// [`pairing::pair`].
    ///
    /// # Errors
    /// [`BuildError::DegenerateFace`], [`BuildError::NonManifoldEdge`], [`BuildError::SameDirection`],
    /// [`BuildError::OutOfMemory`], and too large a mesh for four-byte links.
    pub fn new(mesh: T) -> Result<Self, BuildError> {
        let corners = |f| mesh.face_half_edges(f);
        let vertices = |f| mesh.face_vertices(f).map(|v| v.index() as u32);
        let faces = memory::collected(mesh.faces().map(vertices))?;
        let paired = pairing::pair(mesh.vertex_count(), &faces, Pairing::Auto)?.refuse_irregular(&faces)?;
        let half_edges = memory::collected(mesh.faces().map(corners))?;
        let half_edges = half_edges.as_flattened();
        let mut opposite: Map<_, _> = memory::filled(mesh.half_edge_bound(), Slot::NONE)?.into();
        for (&h, o) in half_edges.iter().zip(paired) {
            opposite[h] = o.get().map(|o| half_edges[o.index()]).into();
        }
        Ok(Self { mesh, opposite })
    }

    /// The mesh inside.
    pub fn mesh(&self) -> &T {
        &self.mesh
    }

    /// The mesh inside, without the table.
    pub fn into_mesh(self) -> T {
        self.mesh
    }
}

impl<T: Topology> Topology for WithOpposites<T> {
    topology_of!(T, self => &self.mesh);
}

impl<T: Topology> Adjacency for WithOpposites<T> {
    #[inline(always)]
    fn opposite(&self, h: T::HalfEdge) -> Option<T::HalfEdge> {
        self.opposite[h].get()
    }
}

impl<T: Incidence> Incidence for WithOpposites<T> {
    incidence_of!(T, self => &self.mesh);
}

impl<T: EdgeMap> EdgeMap for WithOpposites<T> {
    edge_map_of!(T, self => &self.mesh);
}

impl<T: Boundaries> Boundaries for WithOpposites<T> {
    boundaries_of!(T, self => &self.mesh);
}

impl<T: Topology + Footprint> Footprint for WithOpposites<T> {
    const BYTES: Bytes = Bytes { face: T::BYTES.face + 12, ..T::BYTES };

    fn heap_bytes(&self) -> usize {
        self.mesh.heap_bytes() + size_of_val(self.opposite.as_slice())
    }
}

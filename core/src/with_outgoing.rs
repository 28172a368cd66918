//! [`WithOutgoing`]: a mesh and a table of where to start around each vertex.
use crate::{
    Adjacency, Boundaries, BuildError, EdgeMap, Footprint, Handle, Incidence, Map, Slot, Topology, fans,
    footprint::Bytes, handle::Handles, pairing,
};
use alloc::vec::Vec;

/// A mesh and a table of where to start around each vertex: gives [`Incidence`] to any [`Adjacency`].
///
/// Four bytes a vertex. It is strict: faces have three vertices, and those of every vertex form one fan. All that
/// the mesh has already is handed on.
#[derive(Clone, Debug)]
pub struct WithOutgoing<T: Topology> {
    mesh: T,
    outgoing: Map<T::Vertex, Slot<T::HalfEdge>>,
}

impl<T: Adjacency> WithOutgoing<T> {
    /// Finds the first fan of every vertex of `mesh`. O(faces) where `opposite` is O(1).
    ///
    /// # Errors
    /// [`BuildError::DegenerateFace`] for the lowest, [`BuildError::SeveralFans`] for the lowest vertex that has more
    /// than one, [`BuildError::OutOfMemory`], and more vertices than a handle can name.
    pub fn new(mesh: T) -> Result<Self, BuildError> {
        pairing::check_counts(mesh.vertex_count(), 0, 0)?;
        for f in mesh.faces() {
            let [a, b, c] = mesh.face_vertices(f);
            if a == b || b == c || c == a {
                let vertex = if b == c { b } else { a };
                return Err(BuildError::DegenerateFace { face: f.index(), vertex: vertex.index() as u32 });
            }
        }
        let outgoing = fans::fans(&mesh)?.refuse_several()?;
        Ok(Self { mesh, outgoing })
    }
}

impl<T: Topology> WithOutgoing<T> {
    /// The mesh inside.
    pub fn mesh(&self) -> &T {
        &self.mesh
    }

    /// The mesh inside, without the table.
    pub fn into_mesh(self) -> T {
        self.mesh
    }
}

impl<T: Topology> Topology for WithOutgoing<T> {
    topology_of!(T, self => &self.mesh);
}

impl<T: Adjacency> Adjacency for WithOutgoing<T> {
    adjacency_of!(T, self => &self.mesh);
}

impl<T: Adjacency> Incidence for WithOutgoing<T> {
    #[inline(always)]
    fn outgoing(&self, v: T::Vertex) -> Option<T::HalfEdge> {
        self.outgoing[v].get()
    }
}

impl<T: EdgeMap> EdgeMap for WithOutgoing<T> {
    edge_map_of!(T, self => &self.mesh);
}

impl<T: Boundaries> Boundaries for WithOutgoing<T> {
    boundaries_of!(T, self => &self.mesh);
}

impl<T: Topology + Footprint> Footprint for WithOutgoing<T> {
    const BYTES: Bytes = Bytes { vertex: T::BYTES.vertex + 4, ..T::BYTES };

    fn heap_bytes(&self) -> usize {
        self.mesh.heap_bytes() + size_of_val(self.outgoing.as_slice())
    }
}

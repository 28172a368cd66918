//! Connected components of faces.
use crate::{Adjacency, BuildError, Handle, Map, Slot, Topology, disjoint_sets::DisjointSets, edges, memory};
use alloc::{vec, vec::Vec};

/// A partition of the faces: what [`components`] and [`components_by_vertex`] give. Components are numbered
/// in the order of their first faces.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Components<F> {
    of: Map<F, u32>,
    count: usize,
}

impl<F: Handle> Components<F> {
    /// Number of components.
    pub fn count(&self) -> usize {
        self.count
    }

    /// The component of face `f`, below [`count`](Self::count).
    #[inline(always)]
    pub fn of(&self, f: F) -> usize {
        self.of[f] as usize
    }

    /// Number of faces of each component. O(faces).
    pub fn sizes(&self) -> Vec<usize> {
        let mut sizes = vec![0; self.count];
        self.of.as_slice().iter().for_each(|&c| sizes[c as usize] += 1);
        sizes
    }

    /// Numbers sets of faces, each told at its least.
    fn number(face_count: usize, mut least: impl FnMut(F) -> F) -> Result<Self, BuildError> {
        let (mut of, mut count): (Map<F, u32>, u32) = (memory::filled(face_count, 0)?.into(), 0);
        for f in (0..face_count).map(F::new) {
            let first = least(f);
            of[f] = if first == f { count } else { of[first] };
            count += u32::from(first == f);
        }
        Ok(Self { of, count: count as usize })
    }
}

/// The components of faces through shared edges, edges of three or more faces and those that both faces run
/// along in the same direction included. Nearly linear in the faces (union-find); 8 bytes for each face and
/// one for each half-edge.
///
/// Faces that meet in a vertex only are apart: see [`components_by_vertex`].
///
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, Topology, components};
/// let mesh = Mesh::from_faces(7, &[[0, 1, 2], [4, 5, 6], [2, 1, 3]])?;
/// let parts = components::components(&mesh);
/// assert_eq!(parts.sizes(), [2, 1]);
/// assert_eq!(mesh.faces().map(|f| parts.of(f)).collect::<Vec<_>>(), [0, 1, 0]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Panics
/// If memory does not suffice.
pub fn components<M: Adjacency + ?Sized>(mesh: &M) -> Components<M::Face> {
    let couples = edges::each(mesh).flat_map(|h| mesh.edge_fan(h).skip(1).map(move |g| (h, g)));
    joined_by(mesh, couples).unwrap_or_else(|error| panic!("{error}"))
}

/// The components where faces hang together by these couples of half-edges only.
pub(crate) fn joined_by<M: Topology + ?Sized>(
    mesh: &M,
    couples: impl Iterator<Item = (M::HalfEdge, M::HalfEdge)>,
) -> Result<Components<M::Face>, BuildError> {
    let mut sets = DisjointSets::new(mesh.face_count())?;
    couples.for_each(|(h, g)| sets.join(mesh.face(h), mesh.face(g)));
    Components::number(mesh.face_count(), |f| sets.least(f))
}

/// The components of faces through shared vertices. Needs no opposites. Nearly linear in the faces
/// (union-find); 4 bytes for each face and 8 for each vertex.
///
/// ```
/// # use onering::CheL0 as Mesh;
/// use onering_core::{FromFaces, components};
/// let mesh = Mesh::from_faces(5, &[[0, 1, 2], [2, 3, 4]])?;
/// assert_eq!(components::components_by_vertex(&mesh).count(), 1);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Panics
/// If memory does not suffice.
pub fn components_by_vertex<M: Topology + ?Sized>(mesh: &M) -> Components<M::Face> {
    joined_by_vertices(mesh).unwrap_or_else(|error| panic!("{error}"))
}

/// The same, where there may not be the memory.
pub(crate) fn joined_by_vertices<M: Topology + ?Sized>(mesh: &M) -> Result<Components<M::Face>, BuildError> {
    let mut sets = DisjointSets::new(mesh.vertex_count())?;
    for f in mesh.faces() {
        let [a, b, c] = mesh.face_vertices(f);
        sets.join(a, b);
        sets.join(a, c);
    }
    let mut first: Map<M::Vertex, Slot<M::Face>> = memory::filled(mesh.vertex_count(), Slot::NONE)?.into();
    let vertex = |f| mesh.origin(mesh.first(f));
    Components::number(mesh.face_count(), |f| {
        let first = &mut first[sets.least(vertex(f))];
        let least = first.get().unwrap_or(f);
        *first = Slot::some(least);
        least
    })
}

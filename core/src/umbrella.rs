//! Umbrellas: the corners around a vertex that hang together by edges.
//!
//! Where orientation is consistent and no edge has three faces, umbrellas are the fans of
//! [`Incidence::fans`](crate::Incidence::fans). Unlike those, an umbrella goes on across two faces that
//! disagree in orientation and across edges of three or more faces, so it says whether a surface is manifold
//! whatever its orientation.
use crate::{Adjacency, BuildError, Map, Topology, disjoint_sets::DisjointSets, edges};

/// For each half-edge, the least half-edge of the umbrella that it belongs to: those from the same vertex whose
/// faces are reached from its own by edges at that vertex. Where handles have gaps, a gap is on its own.
/// Nearly linear (union-find); 8 bytes at most for each half-edge.
///
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, Topology, umbrella};
/// let bowtie = Mesh::from_faces(5, &[[0, 1, 2], [0, 3, 4]])?;
/// let umbrella = umbrella::umbrellas(&bowtie);
/// assert_eq!(bowtie.half_edges().filter(|&h| umbrella[h] == h).count(), 6); // five vertices, two of them at v0
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Panics
/// If memory does not suffice.
pub fn umbrellas<M: Adjacency + ?Sized>(mesh: &M) -> Map<M::HalfEdge, M::HalfEdge> {
    let couples = edges::each(mesh).flat_map(|h| mesh.edge_fan(h).skip(1).map(move |g| (h, g)));
    joined_by(mesh, couples).unwrap_or_else(|error| panic!("{error}"))
}

/// The umbrellas where faces hang together by these couples of half-edges only, each along one edge.
pub(crate) fn joined_by<M: Topology + ?Sized>(
    mesh: &M,
    couples: impl Iterator<Item = (M::HalfEdge, M::HalfEdge)>,
) -> Result<Map<M::HalfEdge, M::HalfEdge>, BuildError> {
    let mut sets = DisjointSets::new(mesh.half_edge_bound())?;
    couples.for_each(|(h, g)| {
        let [at_origin, at_target] = facing(mesh, h, g);
        sets.join(h, at_origin);
        sets.join(mesh.next(h), at_target);
    });
    Ok(sets.into_least())
}

/// The half-edges of the face of `g` from the origin and from the target of `h`, which lies along the same edge.
#[inline]
pub(crate) fn facing<M: Topology + ?Sized>(mesh: &M, h: M::HalfEdge, g: M::HalfEdge) -> [M::HalfEdge; 2] {
    if mesh.origin(h) == mesh.origin(g) { [g, mesh.next(g)] } else { [mesh.next(g), g] }
}

/// Whether the mesh is a surface, with boundary or without: no edge has three or more faces, and the faces of
/// each vertex form one umbrella. Orientation is not asked for: a Moebius strip is manifold. A mesh without
/// faces is. Nearly linear; 8 bytes at most for each half-edge.
///
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, umbrella};
/// assert!(umbrella::is_manifold(&Mesh::from_faces(4, &[[0, 1, 2], [2, 1, 3]])?));
/// assert!(!umbrella::is_manifold(&Mesh::from_faces(5, &[[0, 1, 2], [0, 3, 4]])?));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn is_manifold<M: Adjacency + ?Sized>(mesh: &M) -> bool {
    mesh.half_edges().all(|h| mesh.edge_fan(h).nth(2).is_none()) && {
        let umbrella = umbrellas(mesh);
        mesh.half_edges().filter(|&h| umbrella[h] == h).count() == used_vertex_count(mesh)
    }
}

/// Number of vertices that are in a face. O(half-edges), one byte of scratch for each vertex.
///
/// ```
/// # use onering::CheL0 as Mesh;
/// use onering_core::{FromFaces, umbrella};
/// assert_eq!(umbrella::used_vertex_count(&Mesh::from_faces(9, &[[0, 1, 2], [0, 3, 4]])?), 5);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn used_vertex_count<M: Topology + ?Sized>(mesh: &M) -> usize {
    let mut used: Map<M::Vertex, bool> = Map::filled(mesh.vertex_count(), false);
    mesh.half_edges().for_each(|h| used[mesh.origin(h)] = true);
    used.as_slice().iter().filter(|&&used| used).count()
}

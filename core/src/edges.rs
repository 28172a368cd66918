//! Undirected edges of any [`Adjacency`]. Compact Half-Edge level 2 keeps them: see [`EdgeMap`](crate::EdgeMap).
use crate::{Adjacency, EdgeId, Handle, Map};

/// One half-edge along each edge, the least, in ascending order.
///
/// Every algorithm that looks at each edge once does so by this: the fan of an edge of `k` faces is walked
/// once, not `k` times. O(half-edges), without scratch.
///
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, Topology, edges};
/// let mesh = Mesh::from_faces(4, &[[0, 1, 2], [2, 1, 3]])?;
/// let ends: Vec<_> = edges::each(&mesh).map(|h| [mesh.origin(h), mesh.target(h)]).collect();
/// assert_eq!(format!("{ends:?}"), "[[v0, v1], [v1, v2], [v2, v0], [v1, v3], [v3, v2]]");
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn each<M: Adjacency + ?Sized>(mesh: &M) -> impl Iterator<Item = M::HalfEdge> {
    mesh.half_edges().filter(|&h| is_least(mesh, h))
}

/// Whether `h` is the least half-edge along its edge. O(1): the others in [`Adjacency::edge_fan`] are ascending.
#[inline]
pub(crate) fn is_least<M: Adjacency + ?Sized>(mesh: &M, h: M::HalfEdge) -> bool {
    mesh.edge_fan(h).nth(1).is_none_or(|least_other| h < least_other)
}

/// The half-edge of the other face at an edge of exactly two faces, whichever way it runs.
#[inline]
pub(crate) fn across<M: Adjacency + ?Sized>(mesh: &M, h: M::HalfEdge) -> Option<M::HalfEdge> {
    mesh.opposite(h).or_else(|| {
        let mut others = mesh.edge_fan(h).skip(1);
        let g = others.next()?;
        others.next().is_none().then_some(g)
    })
}

/// Number of undirected edges. O(half-edges); where the mesh is an
/// [`EdgeMap`](crate::EdgeMap), its own `edge_count` is O(1).
///
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, edges};
/// let mesh = Mesh::from_faces(4, &[[0, 1, 2], [2, 1, 3]])?;
/// assert_eq!(edges::edge_count(&mesh), 5);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn edge_count<M: Adjacency + ?Sized>(mesh: &M) -> usize {
    each(mesh).count()
}

/// Names for the edges of a mesh that keeps none: what [`edge_map`] gives.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Edges<H> {
    edge: Map<H, EdgeId>,
    half_edge: Map<EdgeId, H>,
}

impl<H: Handle> Edges<H> {
    /// Number of edges. Edge handles have the indices below it.
    pub fn edge_count(&self) -> usize {
        self.half_edge.len()
    }

    /// The edge that `h` lies along. Panics for a handle out of range; one that names no half-edge (where
    /// handles have gaps) gets an edge that does not exist.
    #[inline(always)]
    pub fn edge(&self, h: H) -> EdgeId {
        self.edge[h]
    }

    /// The least half-edge along `e`.
    #[inline(always)]
    pub fn half_edge(&self, e: EdgeId) -> H {
        self.half_edge[e]
    }

    /// Every edge with its least half-edge, in order.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (EdgeId, H)> + DoubleEndedIterator {
        self.half_edge.iter().map(|(e, &h)| (e, h))
    }
}

/// Names the edges of a mesh: one for all half-edges of an [`edge_fan`](Adjacency::edge_fan), non-manifold
/// edges included, in the order of their least half-edge. O(half-edges); 4 bytes for each and 4 for each edge.
///
/// This is the edge map of Lage et al. (2005), level 2 of Compact Half-Edge, with both directions as tables.
///
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, Map, Topology, edges};
/// let mesh = Mesh::from_faces(4, &[[0, 1, 2], [2, 1, 3]])?;
/// let edges = edges::edge_map(&mesh);
/// let mut faces = Map::filled(edges.edge_count(), 0);
/// mesh.half_edges().for_each(|h| faces[edges.edge(h)] += 1);
/// assert_eq!(faces.as_slice(), [1, 2, 1, 1, 1]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn edge_map<M: Adjacency + ?Sized>(mesh: &M) -> Edges<M::HalfEdge> {
    let none = EdgeId::new(EdgeId::MAX_INDEX);
    let mut edge = Map::filled(mesh.half_edge_bound(), none);
    let mut half_edge = alloc::vec::Vec::new();
    for h in mesh.half_edges() {
        if edge[h] == none {
            let e = EdgeId::new(half_edge.len());
            mesh.edge_fan(h).for_each(|g| edge[g] = e);
            half_edge.push(h);
        }
    }
    Edges { edge, half_edge: half_edge.into() }
}

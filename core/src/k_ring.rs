//! The k-ring of a vertex, level by level.
//!
//! Biscaro et al. (2016), section 2, define it by cells: the first ring is all cells that contain `v`, the k-th
//! all cells that intersect the (k-1)-th. On triangles this comes down to distance along edges: two vertices
//! share a cell exactly where they are neighbours, so the cells of the k-th ring hold the vertices at distance
//! k or less. Their Table 5 ("number of vertices per level": 6, 17, 35, 58 for a hand) counts just these,
//! `v` left out: [`KRing::count`]. A regular mesh has 6, 18, 36, 60. [`KRing::level`] is what level k adds.
use crate::{Handle, Map, neighbours::Neighbours};
use alloc::vec::Vec;

/// The scratch and the answer of a k-ring search. Kept from one search to the next, it allocates nothing once
/// it has seen a mesh and a ring of the size; it can be used for several meshes.
///
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Topology, k_ring::KRing};
/// let strip = Mesh::from_faces(6, &[[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]])?;
/// let mut ring = KRing::new();
/// let counts: Vec<_> = strip.vertices().map(|v| ring.search(&strip, v, 2).count(2)).collect();
/// assert_eq!(counts, [4, 5, 5, 5, 5, 4]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
#[derive(Clone, Debug)]
pub struct KRing<V> {
    /// The last search that reached the vertex.
    stamps: Map<V, u32>,
    search: u32,
    /// The centre, level 1, level 2, ... up to the last end.
    reached: Vec<V>,
    /// Where each level ends in `reached`.
    ends: Vec<usize>,
}

impl<V: Handle> KRing<V> {
    /// Scratch without memory yet: a search takes 8 bytes for each vertex of the mesh.
    pub fn new() -> Self {
        Self { stamps: Map::default(), search: 0, reached: Vec::new(), ends: Vec::new() }
    }

    /// Finds the levels around `v` up to level `levels`, or to the last one that has vertices. O(what it finds,
    /// with its edges), and O(vertices) where the scratch grows. Panics where `v` is out of range.
    pub fn search<G>(&mut self, graph: &G, v: V, levels: usize) -> &Self
    where
        G: Neighbours<Node = V> + ?Sized,
    {
        self.begin(graph.node_count(), v);
        let (stamps, reached) = (self.stamps.as_mut_slice(), self.reached.as_mut_slice());
        let (mut start, mut count) = (0, 1);
        for _ in 0..levels {
            let end = count;
            for i in start..end {
                // Without a branch, which would be mispredicted for each second vertex: all are written, and
                // the new ones are kept.
                graph.neighbours(reached[i]).for_each(|u| {
                    reached[count] = u;
                    count += usize::from(stamps[u.index()] != self.search);
                    stamps[u.index()] = self.search;
                });
            }
            if count == end {
                break;
            }
            self.ends.push(count);
            start = end;
        }
        self
    }

    /// Makes room, and `v` the only vertex reached.
    fn begin(&mut self, node_count: usize, v: V) {
        if self.search == u32::MAX {
            self.stamps.as_mut_slice().fill(0);
            self.search = 0;
        }
        self.search += 1;
        if self.stamps.len() < node_count {
            self.stamps.resize(node_count, 0);
            // One more than can be reached, to be written and not kept.
            self.reached.resize(node_count + 1, v);
        }
        self.stamps[v] = self.search;
        self.reached[0] = v;
        self.ends.clear();
        self.ends.push(1);
    }

    /// Number of levels found that have vertices, the centre not counted.
    pub fn levels(&self) -> usize {
        self.ends.len().saturating_sub(1)
    }

    /// The vertices at distance `k`, in no order that a caller may rely on; level 0 is the centre. Empty beyond
    /// [`levels`](Self::levels), and before the first search.
    pub fn level(&self, k: usize) -> &[V] {
        let start = if k == 0 { 0 } else { self.end(k - 1) };
        &self.reached[start..self.end(k)]
    }

    /// The vertices at distance 1 to `k`, level after level, the centre left out.
    pub fn within(&self, k: usize) -> &[V] {
        let end = self.end(k);
        &self.reached[end.min(1)..end]
    }

    /// Number of vertices at distance 1 to `k`: the count of Biscaro et al. (2016), Table 5.
    pub fn count(&self, k: usize) -> usize {
        self.within(k).len()
    }

    fn end(&self, k: usize) -> usize {
        self.ends.get(k).or(self.ends.last()).map_or(0, |&end| end)
    }
}

impl<V: Handle> Default for KRing<V> {
    fn default() -> Self {
        Self::new()
    }
}

/// The levels around one vertex.
///
/// # Arguments
/// Any graph or mesh, a vertex of it, and the last level: 1 is that of its neighbours.
///
/// # Returns
/// The vertices of each level, those at that distance along edges.
///
/// # Complexity
/// O(vertices), for the scratch: keep a [`KRing`] to ask for many.
///
/// # Panics
/// Where `v` is out of range.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, VertexId, k_ring};
/// let strip = Mesh::from_faces(6, &[[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]])?;
/// let ring = k_ring::k_ring(&strip, VertexId::new(0), 2);
/// assert_eq!(format!("{:?} {:?}", ring.level(1), ring.level(2)), "[v1, v2] [v3, v4]");
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// The rings of Biscaro et al. (2016), section 2.
pub fn k_ring<G: Neighbours + ?Sized>(graph: &G, v: G::Node, levels: usize) -> KRing<G::Node> {
    let mut ring = KRing::new();
    ring.search(graph, v, levels);
    ring
}

//! Shortest paths along edges, and the distance of every vertex from the nearest of some.
//!
//! Lengths are the caller's: [`straight`] gives those of edges between positions. Where every edge counts one,
//! [`k_ring`](crate::k_ring) finds the same levels without a queue.
use crate::{Handle, Map, Slot, neighbours::Neighbours, vector};
use alloc::{collections::BinaryHeap, vec::Vec};
use core::{cmp::Reverse, error::Error, fmt};

/// An edge has a length that is negative or no number, so no path is the shortest.
#[derive(Clone, Debug, PartialEq)]
pub struct BadLength {
    /// The vertex that the edge was followed from, by its index.
    pub from: usize,
    /// The vertex that it leads to.
    pub to: usize,
    /// Its length.
    pub length: f64,
}

impl fmt::Display for BadLength {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { from, to, length } = self;
        write!(f, "the edge from vertex {from} to {to} has the length {length}")
    }
}

impl Error for BadLength {}

/// A path along edges: what [`shortest_path`] gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Path<V> {
    /// From the first vertex to the last, both included.
    pub vertices: Vec<V>,
    /// The sum of the lengths of its edges.
    pub length: f64,
}

/// What the last search that reached a vertex found of it.
#[derive(Clone, Copy, Debug)]
struct Found<V: Handle> {
    distance: f64,
    predecessor: Slot<V>,
    search: u32,
}

/// The scratch and the answer of a search. Kept from one search to the next, it allocates nothing once it has seen
/// a mesh of the size, and a search costs what it reaches, however large the mesh; it can be used for several meshes.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Topology, distance::Dijkstra};
/// let strip = Mesh::from_faces(6, &[[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]])?;
/// let mut dijkstra = Dijkstra::new();
/// let mut farthest = 0.0_f64;
/// for v in strip.vertices() {
///     dijkstra.search(&strip, [v], |_, _| 1.0).unwrap();
///     farthest = strip.vertices().map(|u| dijkstra.distance(u)).fold(farthest, f64::max);
/// }
/// assert_eq!(farthest, 3.0);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// E. W. Dijkstra, *A note on two problems in connexion with graphs*, Numerische Mathematik 1, 1959; with a binary
/// heap that keeps outdated entries and skips them.
#[derive(Clone, Debug)]
pub struct Dijkstra<V: Handle> {
    found: Map<V, Found<V>>,
    search: u32,
    /// The bits of distances: as none is negative, they are in the order of the numbers, and quicker to compare.
    queue: BinaryHeap<Reverse<(u64, V)>>,
}

impl<V: Handle> Default for Dijkstra<V> {
    fn default() -> Self {
        Self::new()
    }
}

impl<V: Handle> Dijkstra<V> {
    /// Scratch without memory yet: a search takes 16 bytes for each vertex of the mesh, and 16 at most for each
    /// half-edge that it follows, most often far less.
    pub fn new() -> Self {
        Self { found: Map::default(), search: 0, queue: BinaryHeap::new() }
    }

    /// Finds the distance of every vertex from the nearest of `sources`.
    ///
    /// # Arguments
    /// `sources`: where distance is 0; with none, nothing is reached. `length`: of the edge from a vertex to a
    /// neighbour, asked for in both directions, which may differ. An edge of infinite length leads nowhere.
    ///
    /// # Returns
    /// The distances, by [`distance`](Self::distance), and the ways there, by [`path`](Self::path).
    ///
    /// # Complexity
    /// O(edges log edges) of what can be reached, and O(vertices) where the scratch grows.
    ///
    /// # Errors
    /// [`BadLength`] names the first edge that is met whose length is negative or no number. Panics where a source
    /// is out of range.
    pub fn search<G: Neighbours<Node = V> + ?Sized>(
        &mut self,
        graph: &G,
        sources: impl IntoIterator<Item = V>,
        length: impl FnMut(V, V) -> f64,
    ) -> Result<&Self, BadLength> {
        self.search_until(graph, sources, length, |_, _| false)
    }

    /// As [`search`](Self::search), but ends early: vertices are asked about in the order of their distances, which
    /// is then known to be theirs, and `is_last` says whether it was enough. Of other vertices the distance may be
    /// too large.
    ///
    /// # Errors
    /// As for [`search`](Self::search); an edge that is not met is not looked at.
    pub fn search_until<G: Neighbours<Node = V> + ?Sized>(
        &mut self,
        graph: &G,
        sources: impl IntoIterator<Item = V>,
        mut length: impl FnMut(V, V) -> f64,
        mut is_last: impl FnMut(V, f64) -> bool,
    ) -> Result<&Self, BadLength> {
        self.begin(graph.node_count());
        sources.into_iter().for_each(|v| self.reach(v, 0.0, Slot::NONE));
        while let Some(Reverse((bits, v))) = self.queue.pop() {
            let distance = f64::from_bits(bits);
            // A shorter way was found after this one.
            if distance > self.found[v].distance {
                continue;
            }
            if is_last(v, distance) {
                break;
            }
            for u in graph.neighbours(v) {
                let length = length(v, u);
                if length.is_nan() || length < 0.0 {
                    return Err(BadLength { from: v.index(), to: u.index(), length });
                }
                self.reach(u, distance + length, Slot::some(v));
            }
        }
        Ok(self)
    }

    fn begin(&mut self, node_count: usize) {
        let unreached = Found { distance: f64::INFINITY, predecessor: Slot::NONE, search: 0 };
        if self.search == u32::MAX {
            self.found.as_mut_slice().fill(unreached);
            self.search = 0;
        }
        self.search += 1;
        if self.found.len() < node_count {
            self.found.resize(node_count, unreached);
        }
        self.queue.clear();
    }

    /// Takes note of a way to `v`, where it is shorter than all before.
    #[inline]
    fn reach(&mut self, v: V, distance: f64, predecessor: Slot<V>) {
        if distance < self.distance(v) {
            self.found[v] = Found { distance, predecessor, search: self.search };
            self.queue.push(Reverse((distance.to_bits(), v)));
        }
    }

    /// The distance of `v` in the last search; infinite where it was not reached. O(1). Panics where `v` is out of
    /// range of every mesh that was searched.
    #[inline]
    pub fn distance(&self, v: V) -> f64 {
        let found = &self.found[v];
        if found.search == self.search { found.distance } else { f64::INFINITY }
    }

    /// The vertex before `v` on the way from the nearest source; `None` for a source, and where `v` was not reached.
    /// O(1). Panics as [`distance`](Self::distance) does.
    #[inline]
    pub fn predecessor(&self, v: V) -> Option<V> {
        let found = &self.found[v];
        if found.search == self.search { found.predecessor.get() } else { None }
    }

    /// The shortest path from the nearest source to `v`; `None` where it was not reached. O(its vertices). Panics as
    /// [`distance`](Self::distance) does.
    pub fn path(&self, v: V) -> Option<Path<V>> {
        let length = self.distance(v);
        let mut vertices: Vec<V> = core::iter::successors(Some(v), |&v| self.predecessor(v)).collect();
        vertices.reverse();
        (length < f64::INFINITY).then_some(Path { vertices, length })
    }
}

/// The length of an edge as the distance of its ends.
///
/// # Arguments
/// `positions`: of all vertices.
///
/// # Returns
/// What the functions here take as `length`. An edge to a position that is infinite or no number is a
/// [`BadLength`], or leads nowhere.
///
/// # Complexity
/// O(1) an edge.
///
/// # Panics
/// When called, if a position is missing.
///
/// # Example
/// ```
/// use onering_core::{Handle, Map, VertexId, distance};
/// let positions: Map<VertexId, _> = vec![[0.0, 0.0, 1.0], [3.0, 4.0, 1.0]].into();
/// assert_eq!(distance::straight(&positions)(VertexId::new(0), VertexId::new(1)), 5.0);
/// ```
pub fn straight<V: Handle>(positions: &Map<V, [f32; 3]>) -> impl Fn(V, V) -> f64 {
    |u, v| vector::length(vector::minus(vector::of(positions[v]), vector::of(positions[u])))
}

/// The distance field of some vertices: the length of the shortest path along edges from the nearest of them to
/// each vertex.
///
/// # Arguments
/// `sources`: where distance is 0. `length`: of the edge from a vertex to a neighbour, such as [`straight`].
///
/// # Returns
/// The distances; infinite where there is no way.
///
/// # Complexity
/// O(vertices + edges log edges). Keep a [`Dijkstra`] to ask for many.
///
/// # Errors
/// [`BadLength`] names the first edge that is met whose length is negative or no number. Panics where a source is
/// out of range.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, VertexId, distance};
/// let mesh = Mesh::from_faces(5, &[[0, 1, 2], [2, 1, 3]])?;
/// let positions = vec![[0.0, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 4.0, 0.0], [3.0, 4.0, 0.0], [0.0; 3]].into();
/// let field = distance::distances(&mesh, [VertexId::new(0)], distance::straight(&positions)).unwrap();
/// assert_eq!(field.as_slice(), [0.0, 3.0, 4.0, 7.0, f64::INFINITY]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// As for [`Dijkstra`].
pub fn distances<G: Neighbours + ?Sized>(
    graph: &G,
    sources: impl IntoIterator<Item = G::Node>,
    length: impl FnMut(G::Node, G::Node) -> f64,
) -> Result<Map<G::Node, f64>, BadLength> {
    let mut dijkstra = Dijkstra::new();
    dijkstra.search(graph, sources, length)?;
    Ok(Map::from_fn(graph.node_count(), |v| dijkstra.distance(v)))
}

/// The shortest path along edges between two vertices. The search ends where it is found.
///
/// # Arguments
/// `from`, `to`: its ends. `length`: of the edge from a vertex to a neighbour, such as [`straight`].
///
/// # Returns
/// The vertices on the way and the length; `None` where there is no way. From a vertex to itself, that vertex alone.
/// Of several paths as short, any.
///
/// # Complexity
/// O(vertices), for the scratch, + O(edges log edges) of what is nearer than `to`. Keep a [`Dijkstra`] to ask for
/// many.
///
/// # Errors
/// [`BadLength`] names the first edge that is met whose length is negative or no number. Panics where `from` is out
/// of range, or `to` is and has to be looked for.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, Handle, VertexId, distance};
/// let strip = Mesh::from_faces(6, &[[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 5]])?;
/// // Edges along the two rails are long.
/// let length = |a: VertexId, b: VertexId| if a.index() % 2 == b.index() % 2 { 5.0 } else { 1.0 };
/// let path = distance::shortest_path(&strip, VertexId::new(0), VertexId::new(5), length).unwrap().unwrap();
/// assert_eq!(format!("{:?}", path.vertices), "[v0, v1, v2, v3, v4, v5]");
/// assert_eq!(path.length, 5.0);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// As for [`Dijkstra`].
pub fn shortest_path<G: Neighbours + ?Sized>(
    graph: &G,
    from: G::Node,
    to: G::Node,
    length: impl FnMut(G::Node, G::Node) -> f64,
) -> Result<Option<Path<G::Node>>, BadLength> {
    let mut dijkstra = Dijkstra::new();
    dijkstra.search_until(graph, [from], length, |v, _| v == to)?;
    Ok(dijkstra.path(to))
}

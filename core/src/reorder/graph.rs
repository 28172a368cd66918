//! Orders by distance in the graph.
use crate::{BuildError, Handle, Map, memory, neighbours::Neighbours};
use alloc::vec::Vec;

/// The vertices level by level, component after component, each from its least vertex on.
///
/// # Arguments
/// A mesh that can start from a vertex, or a graph: of vertices, or of faces ([`Dual`](crate::dual::Dual)).
///
/// # Returns
/// Every vertex, once: an order for [`reorder`](super::reorder).
///
/// # Complexity
/// O(vertices + edges), one byte of scratch for each vertex.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, reorder};
/// let strip = Mesh::from_faces(5, &[[0, 3, 2], [2, 3, 4], [4, 3, 1]])?;
/// assert_eq!(format!("{:?}", reorder::breadth_first(&strip)), "[v0, v3, v2, v1, v4]");
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Standard.
///
/// # Panics
/// If memory does not suffice.
pub fn breadth_first<G: Neighbours + ?Sized>(graph: &G) -> Vec<G::Node> {
    let mut search = Search::of(graph).unwrap_or_else(|error| panic!("{error}"));
    for v in nodes(graph) {
        search.from(v, |_| {});
    }
    search.order
}

/// The vertices level by level, those that a vertex leads to by their degrees, the least first: neighbours get numbers
/// that differ little.
///
/// Each component begins with a vertex of least degree among those farthest from its least vertex: one search
/// finds it. That is cheaper than to search on for a still farther one, and nearly as good.
///
/// # Arguments
/// A mesh that can start from a vertex, or a graph.
///
/// # Returns
/// Every vertex, once: an order for [`reorder`](super::reorder).
///
/// # Complexity
/// O(vertices + edges log largest degree), 8 bytes of scratch for each vertex.
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, reorder};
/// let strip = Mesh::from_faces(5, &[[0, 3, 2], [2, 3, 4], [4, 3, 1]])?;
/// assert_eq!(format!("{:?}", reorder::cuthill_mckee(&strip)), "[v1, v4, v3, v2, v0]");
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Cuthill, McKee, "Reducing the bandwidth of sparse symmetric matrices", ACM National Conference, 1969; a start far
/// away after George, Liu, "An implementation of a pseudoperipheral node finder", ACM TOMS 5, 1979.
///
/// # Panics
/// If memory does not suffice: [`try_cuthill_mckee`] gives that as an error.
pub fn cuthill_mckee<G: Neighbours + ?Sized>(graph: &G) -> Vec<G::Node> {
    try_cuthill_mckee(graph).unwrap_or_else(|error| panic!("{error}"))
}

/// As [`cuthill_mckee`], for the construction of a structure.
///
/// # Errors
/// [`BuildError::OutOfMemory`].
pub fn try_cuthill_mckee<G: Neighbours + ?Sized>(graph: &G) -> Result<Vec<G::Node>, BuildError> {
    let degrees = (0..graph.node_count()).map(|v| graph.neighbours(G::Node::new(v)).count() as u32);
    let degree: Map<G::Node, u32> = memory::collected(degrees)?.into();
    let by_degree = |found: &mut [G::Node]| found.sort_by_key(|&v| degree[v]);
    let (mut probe, mut search) = (Search::of(graph)?, Search::of(graph)?);
    for v in nodes(graph) {
        let farthest = probe.from(v, |_| {});
        if let Some(&start) = probe.order[farthest..].iter().min_by_key(|&&u| degree[u]) {
            search.from(start, by_degree);
            probe.order.clear();
        }
    }
    Ok(search.order)
}

/// The order of [`cuthill_mckee`] from its end: the same differences of numbers, and where a matrix of this graph is
/// factored, fewer entries come to be.
///
/// # Arguments, Returns, Complexity
/// As [`cuthill_mckee`].
///
/// # Example
/// ```
/// # use onering::CheL2 as Mesh;
/// use onering_core::{FromFaces, reorder};
/// let strip = Mesh::from_faces(5, &[[0, 3, 2], [2, 3, 4], [4, 3, 1]])?;
/// assert_eq!(format!("{:?}", reorder::reverse_cuthill_mckee(&strip)), "[v0, v2, v3, v4, v1]");
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// George, "Computer implementation of the finite element method", thesis, Stanford, 1971.
///
/// # Panics
/// As [`cuthill_mckee`].
pub fn reverse_cuthill_mckee<G: Neighbours + ?Sized>(graph: &G) -> Vec<G::Node> {
    let mut order = cuthill_mckee(graph);
    order.reverse();
    order
}

fn nodes<G: Neighbours + ?Sized>(graph: &G) -> impl Iterator<Item = G::Node> {
    (0..graph.node_count()).map(G::Node::new)
}

/// What has been reached, in the order in which it was; its end is the queue.
struct Search<'a, G: Neighbours + ?Sized> {
    graph: &'a G,
    reached: Map<G::Node, bool>,
    order: Vec<G::Node>,
}

impl<'a, G: Neighbours + ?Sized> Search<'a, G> {
    /// With room for all, so that nothing grows on the way.
    fn of(graph: &'a G) -> Result<Self, BuildError> {
        let count = graph.node_count();
        Ok(Self { graph, reached: memory::filled(count, false)?.into(), order: memory::with_room(count)? })
    }

    /// Goes on from `start` through its component, unless it has been reached; `arrange` puts in order what one vertex
    /// leads to. Gives where in `order` the last level begins.
    fn from(&mut self, start: G::Node, arrange: impl Fn(&mut [G::Node])) -> usize {
        let mut level = self.order.len();
        if core::mem::replace(&mut self.reached[start], true) {
            return level;
        }
        self.order.push(start);
        let (mut next, mut level_end) = (level, self.order.len());
        while next < self.order.len() {
            if next == level_end {
                (level, level_end) = (next, self.order.len());
            }
            let found = self.order.len();
            for u in self.graph.neighbours(self.order[next]) {
                if !core::mem::replace(&mut self.reached[u], true) {
                    self.order.push(u);
                }
            }
            arrange(&mut self.order[found..]);
            next += 1;
        }
        level
    }
}

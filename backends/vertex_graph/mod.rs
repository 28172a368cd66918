//! [`VertexGraph`]: neighbours alone, as TopTri has them.
mod columns;
mod common;

use crate::storage::{Owned, Storage};
use alloc::{borrow::Cow, vec::Vec};
use common::{Common, from};
use core::fmt;
use onering_core::footprint::{Bytes, Footprint};
use onering_core::handle::Handles;
use onering_core::{
    BuildError, FromFaces, Handle, Pairing, VertexId, memory, neighbours::Neighbours, pairing,
};

/// The graph of vertices and edges of TopTri (Figueiredo et al. 2014): for each vertex its neighbours.
///
/// Made from any list of triangles in range; a degenerate face gives no loop, and an edge is there once however
/// many faces share it. There are no faces: what the queries call a face is a *3-cycle*, three vertices that
/// are neighbours of each other, found by search (`w` in `N(u) ∩ N(v)`). **That is not always a face.** The
/// triangular bipyramid has V = 5, E = 9 and F = 6, but 7 three-cycles: its equator is one that bounds no face.
/// A tetrahedron with one face taken away still has four. Where faces matter, take
/// [`AdjacencyGraph`](crate::AdjacencyGraph), which keeps them.
///
/// Edges are named by their two vertices, faces by their three. Lists are ascending, so that an intersection is
/// one merge, with doubling steps through the longer list: O(shorter x log(longer / shorter)), where the
/// original has hash tables (Python dictionaries). Queries give iterators and take no memory.
///
/// | query | in TopTri | |
/// |---|---|---|
/// | [`neighbours`](Self::neighbours) | `vGetAdjacentVertices` | Property 1(a), explicit |
/// | [`vertex_edges`](Self::vertex_edges) | `vGetIncidentEdges` | 1(b), explicit |
/// | [`vertex_faces`](Self::vertex_faces) | `vGetIncidentFaces` | 1(c), implicit |
/// | [`adjacent_edges`](Self::adjacent_edges) | `eGetAdjacentEdges` | 2(a), implicit |
/// | [`edge_faces`](Self::edge_faces) | `eGetIncidentFaces` | 2(b), implicit |
/// | [`adjacent_faces`](Self::adjacent_faces) | `fGetAdjacentFaces` | 3, implicit |
///
/// Methods panic for a vertex out of range.
#[derive(Clone)]
pub struct VertexGraph<S: Storage = Owned> {
    /// Where each list starts, and the end of the last.
    offsets: S::Slice<u32>,
    neighbours: S::Slice<VertexId>,
}

/// Two ends of 2^31 - 1 half-edges are what offsets of four bytes can count.
const MAX_HALF_EDGES: usize = i32::MAX as usize;

impl<S: Storage> VertexGraph<S> {
    /// Number of vertices, isolated ones included.
    #[inline(always)]
    pub fn vertex_count(&self) -> usize {
        self.offsets.len() - 1
    }

    /// Number of edges.
    #[inline(always)]
    pub fn edge_count(&self) -> usize {
        self.neighbours.len() / 2
    }

    /// Every vertex.
    pub fn vertices(&self) -> Handles<VertexId> {
        Handles::below(self.vertex_count())
    }

    /// Every edge once, the lesser vertex first. O(edges).
    pub fn edges(&self) -> impl Iterator<Item = [VertexId; 2]> {
        self.vertices().flat_map(|u| from(self.list(u), u).iter().map(move |&v| [u, v]))
    }

    /// Every 3-cycle once, ascending: see the type for how they differ from faces. O(edges x degree) at worst.
    pub fn faces(&self) -> impl Iterator<Item = [VertexId; 3]> {
        self.vertices().flat_map(|u| self.cycles(u, from(self.list(u), u)))
    }

    /// Whether `u` and `v` are neighbours. O(log degree).
    pub fn has_edge(&self, u: VertexId, v: VertexId) -> bool {
        self.list(u).binary_search(&v).is_ok()
    }

    /// The neighbours of `v`, ascending: `vGetAdjacentVertices`.
    #[inline]
    pub fn neighbours(
        &self,
        v: VertexId,
    ) -> impl ExactSizeIterator<Item = VertexId> + DoubleEndedIterator + Clone {
        self.list(v).iter().copied()
    }

    /// The edges at `v`, each as `v` and its other end: `vGetIncidentEdges`.
    #[inline]
    pub fn vertex_edges(&self, v: VertexId) -> impl ExactSizeIterator<Item = [VertexId; 2]> + Clone {
        self.list(v).iter().map(move |&w| [v, w])
    }

    /// The 3-cycles through `u`, each once, as `u` and the other two ascending: `vGetIncidentFaces`.
    /// An intersection for each neighbour.
    #[inline]
    pub fn vertex_faces(&self, u: VertexId) -> impl Iterator<Item = [VertexId; 3]> + Clone {
        self.cycles(u, self.list(u))
    }

    /// The other edges at the two ends of `e`, each from that end: `eGetAdjacentEdges`. O(degree).
    #[inline]
    pub fn adjacent_edges(&self, e: [VertexId; 2]) -> impl Iterator<Item = [VertexId; 2]> + Clone {
        let [u, v] = e;
        self.vertex_edges(u).filter(move |e| e[1] != v).chain(self.vertex_edges(v).filter(move |e| e[1] != u))
    }

    /// The 3-cycles along `e`, each as its two ends and the third vertex: `eGetIncidentFaces`. None where the
    /// two are no neighbours. One intersection.
    #[inline]
    pub fn edge_faces(&self, e: [VertexId; 2]) -> impl Iterator<Item = [VertexId; 3]> + Clone {
        let [u, v] = e;
        let around = if self.has_edge(u, v) { self.list(u) } else { &[] };
        Common::new(around, self.list(v)).map(move |w| [u, v, w])
    }

    /// The other 3-cycles along the sides of `f`, side after side, as [`edge_faces`](Self::edge_faces) has
    /// them: `fGetAdjacentFaces`. Three intersections.
    #[inline]
    pub fn adjacent_faces(&self, f: [VertexId; 3]) -> impl Iterator<Item = [VertexId; 3]> + Clone {
        let [u, v, w] = f;
        let others = |e, not| self.edge_faces(e).filter(move |f: &[VertexId; 3]| f[2] != not);
        others([u, v], w).chain(others([v, w], u)).chain(others([w, u], v))
    }

    #[inline(always)]
    fn list(&self, v: VertexId) -> &[VertexId] {
        &self.neighbours[self.offsets[v.index()] as usize..self.offsets[v.index() + 1] as usize]
    }

    /// The 3-cycles of `u` with two out of `around`, a part of its list.
    #[inline]
    fn cycles<'a>(
        &'a self,
        u: VertexId,
        around: &'a [VertexId],
    ) -> impl Iterator<Item = [VertexId; 3]> + Clone {
        let with = move |(i, &v): (usize, &VertexId)| {
            Common::new(&around[i + 1..], self.list(v)).map(move |w| [u, v, w])
        };
        around.iter().enumerate().flat_map(with)
    }
}

impl<S: Storage> fmt::Debug for VertexGraph<S> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "VertexGraph {{ vertices: {}, edges: {} }}", self.vertex_count(), self.edge_count())
    }
}

impl FromFaces for VertexGraph {
    /// Nothing is paired, so `pairing` makes no difference. O(faces log degree); 12 bytes a face and 4 a vertex
    /// of scratch.
    fn build(vertex_count: usize, faces: Cow<'_, [[u32; 3]]>, _: Pairing) -> Result<Self, BuildError> {
        pairing::check_counts(vertex_count, faces.len(), MAX_HALF_EDGES)?;
        pairing::check_vertices(vertex_count, &faces)?;
        let (ends, higher) = edges_by_lower(vertex_count, &faces)?;
        // The cell after that of each vertex counts its neighbours, then moves from the start of its list to
        // the end, which is the start of the next.
        let mut offsets = memory::filled(vertex_count + 1, 0u32)?;
        for [low, high] in each_once(&ends, &higher) {
            offsets[low + 1] += 1;
            offsets[high + 1] += 1;
        }
        let mut neighbours = memory::filled(counts_to_starts(&mut offsets[1..]), VertexId::new(0))?;
        let mut add = |to: usize, v: usize| {
            neighbours[offsets[to + 1] as usize] = VertexId::new(v);
            offsets[to + 1] += 1;
        };
        // Ascending in the lower vertex, so each list gets its lower neighbours before its higher ones.
        for [low, high] in each_once(&ends, &higher) {
            add(low, high);
            add(high, low);
        }
        Ok(Self { offsets: offsets.into(), neighbours: neighbours.into() })
    }
}

/// The higher vertex of every side, sorted in buckets by the lower one; and the end of each bucket.
fn edges_by_lower(vertex_count: usize, faces: &[[u32; 3]]) -> Result<(Vec<u32>, Vec<u32>), BuildError> {
    let sides = || faces.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]).filter(|(a, b)| a != b);
    let mut ends = memory::filled(vertex_count, 0u32)?;
    sides().for_each(|(a, b)| ends[a.min(b) as usize] += 1);
    let mut higher = memory::filled(counts_to_starts(&mut ends), 0u32)?;
    for (a, b) in sides() {
        let end = &mut ends[a.min(b) as usize];
        higher[*end as usize] = a.max(b);
        *end += 1;
    }
    let mut start = 0;
    for &end in &ends {
        higher[start..end as usize].sort_unstable();
        start = end as usize;
    }
    Ok((ends, higher))
}

/// Turns the length of each list into its start. Gives the length of all.
fn counts_to_starts(lengths: &mut [u32]) -> usize {
    let mut sum = 0;
    for length in lengths {
        (*length, sum) = (sum, sum + *length);
    }
    sum as usize
}

/// Every edge once, ascending, lower vertex first.
fn each_once(ends: &[u32], higher: &[u32]) -> impl Iterator<Item = [usize; 2]> {
    let starts = core::iter::once(0).chain(ends.iter().copied());
    starts.zip(ends).enumerate().flat_map(move |(low, (start, &end))| {
        let same = higher[start as usize..end as usize].chunk_by(|a, b| a == b);
        same.map(move |high| [low, high[0] as usize])
    })
}

impl Footprint for VertexGraph {
    const BYTES: Bytes = Bytes { constant: 4, vertex: 4, edge: 8, ..Bytes::NONE };

    fn heap_bytes(&self) -> usize {
        size_of_val(&*self.offsets) + size_of_val(&*self.neighbours)
    }
}

/// As good as the graph.
impl<S: Storage> Neighbours for &VertexGraph<S> {
    type Node = VertexId;

    fn node_count(&self) -> usize {
        self.vertex_count()
    }

    #[inline]
    fn neighbours(&self, v: VertexId) -> impl Iterator<Item = VertexId> {
        VertexGraph::neighbours(self, v)
    }
}

impl<S: Storage> Neighbours for VertexGraph<S> {
    type Node = VertexId;

    fn node_count(&self) -> usize {
        self.vertex_count()
    }

    #[inline]
    fn neighbours(&self, v: VertexId) -> impl Iterator<Item = VertexId> {
        self.neighbours(v)
    }
}

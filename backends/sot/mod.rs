//! [`Sot`]: the sorted opposite table, half of a corner table.
mod matching;
mod order;

use crate::link::{Coded, Coding};
use crate::{CheL1, Renumbering};
use alloc::boxed::Box;
use core::fmt;
use matching::Matching;
use onering_core::footprint::{Bytes, Footprint};
use onering_core::{
    Adjacency, BuildError, FaceId, FromFaces, HalfEdgeId, Handle, Incidence, Topology, VertexId,
    WithOutgoing, corner, pairing,
};
use order::Order;

/// What a table is encoded from: it numbers half-edges by corners.
type Source = WithOutgoing<CheL1>;

/// The sorted opposite table (Gurung and Rossignac 2009, 2010): one reference for each half-edge, its opposite, and
/// nothing else. Full adjacency in the 12 bytes a triangle of a bare list of vertices.
///
/// It renumbers: vertex `i` is the first of face `i`, and its half-edge out of there is `3i`. So where a vertex is
/// needs no table, and which vertex a half-edge starts at is found by walking around it. [`encode`](Self::encode)
/// gives the maps between the numbers of the list and those of the table; attributes go through
/// [`Renumbering::carry_vertices`] and [`carry_faces`](Renumbering::carry_faces). That is why it has no `FromFaces`,
/// whose meshes give their faces back as they came.
///
/// # What is not O(1)
/// **`origin` is a walk**, O(degree): clockwise around the vertex until a half-edge `3i` names it, or the boundary
/// does, whose cells hold the vertex where other cells hold the opposite. Three to four faces are looked at on
/// ordinary meshes, and `target`, `face_vertices`, rings and neighbours each do that for every vertex that they give.
/// `outgoing` is O(1) but at the boundary, where it turns to the clockwise end of the fan. A table to keep meshes in,
/// where memory matters more than speed: one-rings took three to five times as long as on Compact Half-Edge level 2,
/// while stars, which ask for no origin, took about as long (`docs/performance.md`).
///
/// # Unmatched vertices
/// Every vertex needs a face of its own, and where all have three faces or more there is one for each. Else as few as
/// can be go without: at most two of each component, both on its boundary, and one of each pillow (a face and its
/// reverse). These take 4 bytes each. Isolated vertices take nothing.
///
/// Degenerate faces, edges of three or more faces, faces that disagree in orientation and vertices of several fans
/// are refused. Up to 2^31 - 1 half-edges.
///
/// ```
/// use onering::{Handle, Incidence, Sot, Topology};
/// // A square, cut in two: vertices 0 and 2 have two faces each, 1 and 3 one.
/// let (mesh, maps) = Sot::encode(4, &[[0, 1, 2], [2, 3, 0]])?;
/// let names = maps.carry_vertices(&["one end", "a side", "other end", "a side"]);
/// for v in mesh.vertices() {
///     let degree = if names[v.index()] == "a side" { 2 } else { 3 };
///     assert_eq!(mesh.one_ring(v).count(), degree);
/// }
/// assert_eq!(mesh.matched_count(), 2); // two faces, so two of the four vertices have none of their own
/// # Ok::<(), onering::BuildError>(())
/// ```
#[derive(Clone)]
pub struct Sot {
    vertex_count: usize,
    /// Vertices below this have a face of their own and are inside: those on the boundary follow.
    inside_count: usize,
    /// Vertices below this have a face of their own. Those with a cell of `unmatched` follow, then isolated ones.
    matched_count: usize,
    /// For each half-edge its opposite; on the boundary its own origin instead, complemented, which is negative.
    opposite: Box<[i32]>,
    /// Where the fan starts of each vertex without a face of its own: on the boundary, then of pillows, each ascending.
    unmatched: Box<[HalfEdgeId]>,
}

impl Sot {
    /// The table of `faces`, and the maps to its numbers. O(vertices + faces); beside the result and the maps, what
    /// [`CheL1`] of the list takes, and up to some 25 bytes a face and 12 a vertex.
    ///
    /// Vertices with a face of their own come first, inside ones before those on the boundary, then those that are
    /// left over, then isolated ones; all but those left over in the order of the list, and further faces too.
    ///
    /// # Errors
    /// What the table cannot hold, the first element that is at fault, as all backends say it; see [`BuildError`].
    pub fn encode(vertex_count: usize, faces: &[[u32; 3]]) -> Result<(Self, Renumbering), BuildError> {
        pairing::check_counts(vertex_count, faces.len(), Coded::MAX_HALF_EDGES)?;
        let source: Source = WithOutgoing::new(CheL1::from_faces(vertex_count, faces)?)?;
        Order::of(&source, &Matching::of(&source)?)?.encode(&source)
    }

    /// Number of vertices with a face of their own. Face `i` below it begins with vertex `i`.
    pub fn matched_count(&self) -> usize {
        self.matched_count
    }

    /// The opposite of `h`, or on the boundary the vertex that `h` starts at.
    #[inline(always)]
    fn across(&self, h: HalfEdgeId) -> Result<HalfEdgeId, VertexId> {
        let cell = self.opposite[h.index()];
        if cell >= 0 { Ok(HalfEdgeId::new(cell as usize)) } else { Err(VertexId::new(!cell as usize)) }
    }

    /// The vertex that the number of `h` says.
    #[inline(always)]
    fn named(&self, h: HalfEdgeId) -> Option<VertexId> {
        let is_named = h.index().is_multiple_of(3) && h.index() < 3 * self.matched_count;
        is_named.then(|| VertexId::new(h.index() / 3))
    }

    /// The vertex of a pillow that has no face of its own, by one of its two half-edges.
    #[cold]
    fn of_pillow(&self, h: HalfEdgeId) -> VertexId {
        let place =
            |h| self.unmatched.binary_search_by_key(&(true, h), |&g| (self.across(g).is_ok(), g)).ok();
        let place = place(h).or_else(|| place(self.rotate_cw(h)?));
        VertexId::new(self.matched_count + place.expect("a turn that nothing stops is of a pillow"))
    }
}

impl fmt::Debug for Sot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Sot {{ vertices: {}, faces: {} }}", self.vertex_count, self.opposite.len() / 3)
    }
}

impl Footprint for Sot {
    const BYTES: Bytes = Bytes { face: 12, unmatched: 4, ..Bytes::NONE };

    fn heap_bytes(&self) -> usize {
        size_of_val(&*self.opposite) + size_of_val(&*self.unmatched)
    }
}

impl Topology for Sot {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    #[inline(always)]
    fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    #[inline(always)]
    fn face_count(&self) -> usize {
        self.opposite.len() / 3
    }

    /// A walk around the vertex, O(degree): see [`Sot`].
    #[inline]
    fn origin(&self, h: HalfEdgeId) -> VertexId {
        let mut g = h;
        loop {
            if let Some(v) = self.named(g) {
                return v;
            }
            match self.across(g) {
                Ok(o) => g = corner::next(o),
                Err(v) => return v,
            }
            if g == h {
                return self.of_pillow(h);
            }
        }
    }
}

impl Adjacency for Sot {
    #[inline(always)]
    fn opposite(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.across(h).ok()
    }
}

impl Incidence for Sot {
    /// O(1) but on the boundary, where it is a turn, O(degree).
    #[inline]
    fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId> {
        let v = v.index();
        assert!(v < self.vertex_count, "vertex {v} of {}", self.vertex_count);
        if v >= self.matched_count {
            return self.unmatched.get(v - self.matched_count).copied();
        }
        let mut h = HalfEdgeId::new(3 * v);
        if v >= self.inside_count {
            while let Ok(o) = self.across(h) {
                h = corner::next(o);
            }
        }
        Some(h)
    }
}

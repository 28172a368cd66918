//! [`CompactStars`]: the neighbours of each vertex around it, as short differences, and nothing else.
mod encode;
mod marks;
mod packed;
mod queries;

use crate::{CheL1, Renumbering};
use core::{fmt, ops::Range};
use marks::Marks;
use onering_core::{BuildError, FromFaces, Handle, Topology, VertexId, WithOutgoing, memory, reorder};
use packed::Packed;

/// What stars are encoded from: it numbers half-edges by corners.
type Source = WithOutgoing<CheL1>;

/// The neighbours of each vertex in order around it, each told by how far its number is from that of the vertex, in as
/// few bits as the longest such step takes: full incidence in 5 to 6.5 bytes a triangle, half of a bare list of vertices.
/// One-rings took 0.8 to 1.5 times as long as on Compact Half-Edge level 2 in the same order (`docs/performance.md`).
///
/// Lists of neighbours in order around each vertex are the star-vertices of Kallmann and Thalmann (2001); to tell them
/// by differences, over a numbering that keeps neighbours close, is due to Blandford, Blelloch, Cardoze and Kadow (2003).
/// Here all differences take the same number of bits, so that each can be read by itself, and two bits beside each say
/// whether a star starts there and whether a face has its first half-edge there, to be counted and found in constant time
/// (Jacobson 1989). So a half-edge is a place in the lists: it starts at the vertex whose list that is, leads to the
/// neighbour before the place, and has the one at the place across. What lies opposite, after or before is found by a
/// look at the list of one of these two.
///
/// It renumbers: [`encode`](Self::encode) numbers vertices by the order of Cuthill and McKee
/// ([`reorder::cuthill_mckee`]), by which the longest step is a few thousand on a mesh of a million triangles;
/// [`encode_in_order`](Self::encode_in_order) keeps the numbers that vertices have. Faces are sorted by their least
/// vertex, which comes first in each, by both. Attributes go through the maps.
///
/// # What is not O(1)
/// `origin`, `target`, `outgoing`, turns, `is_boundary`, `first` and `face_vertices` are, and rings, stars and neighbours take a step for each
/// item. But `opposite`, `next`, `prev` and `face` **look through the list of a neighbour, O(its degree)**: six numbers
/// on ordinary meshes, where they took some 35 ns, walks over many half-edges thus many times as long as on directed
/// edges. To ask all half-edges into a hub for their opposites takes the square of its degree; to turn around it does not.
/// What starts behind a list of many thousands is found by a look at a bit for each of them, 64 at once.
///
/// # Memory
/// With `w` bits for a difference and `S` places, which are 3 for each of `T` triangles, 2 more for each vertex on the
/// boundary and 1 for each isolated one of `V`: `S w / 8`, rounded up, and 8 bytes of differences; for the starts of stars
/// 12 for each 64 of `S + 1` places begun and 4 for each 8 of `V + 1` begun; for the faces 12 for each 64 of `S` begun
/// and 4 for each 32 of `T` begun. That is `3 w / 8 + 1.5` bytes a triangle of a large closed mesh. `w` is
/// [`difference_bits`](Self::difference_bits); it is for the order to say, so this is no formula of counts, as
/// [`Footprint`](onering_core::Footprint) asks for: [`heap_bytes`](Self::heap_bytes) tells. It is 33 at the most.
///
/// Half-edge handles have gaps, two for each vertex on the boundary and one for each isolated one, of which nothing may
/// be asked. Degenerate faces, edges of three or more faces, faces that disagree in orientation and vertices of several
/// fans are refused. Up to 2^32 - 2 places.
///
/// ```
/// use onering::{CompactStars, Handle, Incidence, Topology};
/// // A square, cut in two: vertices 0 and 2 have two faces each, 1 and 3 one.
/// let (mesh, maps) = CompactStars::encode(4, &[[0, 1, 2], [2, 3, 0]])?;
/// let names = maps.carry_vertices(&["one end", "a side", "other end", "a side"]);
/// for v in mesh.vertices() {
///     let degree = if names[v.index()] == "a side" { 2 } else { 3 };
///     assert_eq!(mesh.one_ring(v).count(), degree);
/// }
/// # Ok::<(), onering::BuildError>(())
/// ```
#[derive(Clone)]
pub struct CompactStars {
    vertex_count: usize,
    face_count: usize,
    /// How many half-edges there are, and gaps.
    place_count: usize,
    /// The neighbours of each vertex, counter-clockwise, less the vertex. Where an open star comes round from its last to
    /// its first there is a 0, which leads nowhere; it stands first, and of an isolated vertex alone.
    neighbours: Packed,
    /// The places where stars start, and where the last ends.
    starts: Marks<8>,
    /// The places of the first half-edges of faces.
    firsts: Marks<32>,
}

impl CompactStars {
    /// The stars of `faces`, vertices in an order that keeps neighbours close; and the maps. O(vertices + edges log
    /// largest degree); beside the result and the maps, what [`CheL1`] of the list takes, and some 20 bytes a vertex.
    ///
    /// # Errors
    /// What stars cannot hold, the first element that is at fault, as all backends say it; see [`BuildError`].
    pub fn encode(vertex_count: usize, faces: &[[u32; 3]]) -> Result<(Self, Renumbering), BuildError> {
        let source = source(vertex_count, faces)?;
        encode::encode(&source, &reorder::try_cuthill_mckee(&source)?)
    }

    /// The stars of `faces`, vertices with the numbers that they have; and the maps, of which those of vertices lead each
    /// to itself. No larger than by [`encode`](Self::encode) where the list is in a good order already; where it is
    /// in none, nearly twice as large. O(vertices + faces).
    ///
    /// # Errors
    /// As for [`encode`](Self::encode).
    pub fn encode_in_order(
        vertex_count: usize,
        faces: &[[u32; 3]],
    ) -> Result<(Self, Renumbering), BuildError> {
        let source = source(vertex_count, faces)?;
        encode::encode(&source, &memory::collected(source.vertices())?)
    }

    /// How many bits each difference takes: one for its direction, and those of the longest step from a vertex to a
    /// neighbour.
    pub fn difference_bits(&self) -> u32 {
        self.neighbours.width()
    }

    /// Bytes of topology on the heap: see [Memory](Self#memory).
    pub fn heap_bytes(&self) -> usize {
        self.neighbours.heap_bytes() + self.starts.heap_bytes() + self.firsts.heap_bytes()
    }

    /// The places of the star of `v`.
    #[inline(always)]
    fn star_of(&self, v: VertexId) -> Range<usize> {
        let (v, count) = (v.index(), self.vertex_count);
        assert!(v < count, "vertex {v} of {count}");
        let start = self.starts.select(v);
        start..self.starts.next_after(start)
    }

    /// Whether this place is the end of an open star.
    #[inline(always)]
    fn is_end(&self, p: usize) -> bool {
        self.neighbours.get(p) == 0
    }

    /// The neighbour of `v` at a place of its star.
    #[inline(always)]
    fn neighbour(&self, v: VertexId, p: usize) -> VertexId {
        VertexId::new((v.index() as i64 + self.neighbours.get(p)) as usize)
    }

    /// The place after `p` around its star, unless that is where an open one ends.
    #[inline(always)]
    fn after(&self, p: usize) -> Option<usize> {
        if !self.starts.has(p + 1) {
            return Some(p + 1);
        }
        let start = self.starts.select(self.starts.rank(p + 1) - 1);
        (!self.is_end(start)).then_some(start)
    }

    /// The place before `p` around its star.
    #[inline(always)]
    fn before(&self, p: usize) -> usize {
        if self.starts.has(p) { self.starts.next_after(p) - 1 } else { p - 1 }
    }

    /// The place in the star of `w` of its neighbour `v`. O(degree).
    #[inline(always)]
    fn find(&self, w: VertexId, v: VertexId) -> usize {
        let step = v.index() as i64 - w.index() as i64;
        let place = self.star_of(w).find(|&p| self.neighbours.get(p) == step);
        place.expect("each of two neighbours is in the star of the other")
    }
}

impl fmt::Debug for CompactStars {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "CompactStars {{ vertices: {}, faces: {} }}", self.vertex_count, self.face_count)
    }
}

fn source(vertex_count: usize, faces: &[[u32; 3]]) -> Result<Source, BuildError> {
    WithOutgoing::new(CheL1::from_faces(vertex_count, faces)?)
}

//! The traits of [`CompactStars`].
use super::CompactStars;
use alloc::vec::Vec;
use onering_core::{Adjacency, FaceId, HalfEdgeId, Handle, Incidence, Topology, VertexId};

impl Topology for CompactStars {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    #[inline(always)]
    fn vertex_count(&self) -> usize {
        self.vertex_count
    }

    #[inline(always)]
    fn face_count(&self) -> usize {
        self.face_count
    }

    /// The last vertex whose star starts here or before.
    #[inline(always)]
    fn origin(&self, h: HalfEdgeId) -> VertexId {
        self.assert_exists(h);
        VertexId::new(self.starts.rank(h.index() + 1) - 1)
    }

    #[inline(always)]
    fn target(&self, h: HalfEdgeId) -> VertexId {
        self.neighbour(self.origin(h), self.before(h.index()))
    }

    /// In the star of the target, where the origin is. O(degree).
    #[inline]
    fn next(&self, h: HalfEdgeId) -> HalfEdgeId {
        let v = self.origin(h);
        let w = self.neighbour(v, self.before(h.index()));
        HalfEdgeId::new(self.find(w, v))
    }

    /// In the star of the third vertex, where the target is. O(degree).
    #[inline]
    fn prev(&self, h: HalfEdgeId) -> HalfEdgeId {
        let [_, b, c] = self.corners(h);
        HalfEdgeId::new(self.find(c, b))
    }

    /// O(degree).
    #[inline]
    fn face(&self, h: HalfEdgeId) -> FaceId {
        let [a, b, c] = self.corners(h);
        let first = if a < b.min(c) {
            h.index()
        } else if b < c {
            self.find(b, a)
        } else {
            self.find(c, b)
        };
        FaceId::new(self.firsts.rank(first))
    }

    #[inline]
    fn first(&self, f: FaceId) -> HalfEdgeId {
        let (f, count) = (f.index(), self.face_count);
        assert!(f < count, "face {f} of {count}");
        HalfEdgeId::new(self.firsts.select(f))
    }

    #[inline]
    fn face_vertices(&self, f: FaceId) -> [VertexId; 3] {
        self.corners(self.first(f))
    }

    fn half_edge_bound(&self) -> usize {
        self.place_count
    }

    fn half_edges(&self) -> impl Iterator<Item = HalfEdgeId> {
        self.vertices().flat_map(|v| self.star(v))
    }

    /// Star after star, so that no face is searched for.
    fn to_faces(&self) -> Vec<[u32; 3]> {
        let corners = self.half_edges().map(|h| self.corners(h));
        corners.filter(|[a, b, c]| a < b.min(c)).map(|face| face.map(|v| v.index() as u32)).collect()
    }
}

impl CompactStars {
    /// That there is such a place; a gap is not told from a half-edge.
    #[inline(always)]
    fn assert_exists(&self, h: HalfEdgeId) {
        assert!(h.index() < self.place_count, "{h:?} is out of range");
    }

    /// The vertices of the face of `h`, from its origin on.
    #[inline(always)]
    fn corners(&self, h: HalfEdgeId) -> [VertexId; 3] {
        let v = self.origin(h);
        [v, self.neighbour(v, self.before(h.index())), self.neighbour(v, h.index())]
    }
}

impl Adjacency for CompactStars {
    /// In the star of the target, the place after that of the origin, unless the star ends there. O(degree).
    #[inline]
    fn opposite(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        let v = self.origin(h);
        let w = self.neighbour(v, self.before(h.index()));
        self.after(self.find(w, v)).map(HalfEdgeId::new)
    }

    /// The next place of the star. O(1).
    #[inline]
    fn rotate_ccw(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.assert_exists(h);
        self.after(h.index()).map(HalfEdgeId::new)
    }

    /// The place before, in the star, unless that is the first of an open one. O(1).
    #[inline]
    fn rotate_cw(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        self.assert_exists(h);
        let turned = self.before(h.index());
        let is_first = self.is_end(self.before(turned));
        (!is_first).then(|| HalfEdgeId::new(turned))
    }

    /// Whether the star is open and begins with `h`. O(1).
    #[inline]
    fn is_boundary(&self, h: HalfEdgeId) -> bool {
        self.rotate_cw(h).is_none()
    }
}

impl Incidence for CompactStars {
    /// The first place of the star. O(1).
    #[inline]
    fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId> {
        self.star(v).next()
    }

    /// All places of the star but, where it is open, the end and the first neighbour.
    #[inline]
    fn star(&self, v: VertexId) -> impl Iterator<Item = HalfEdgeId> {
        let star = self.star_of(v);
        let gaps = if self.is_end(star.start) { 2 } else { 0 };
        (star.start + gaps..star.end).map(HalfEdgeId::new)
    }

    #[inline]
    fn one_ring(&self, v: VertexId) -> impl Iterator<Item = VertexId> {
        let star = self.star_of(v);
        let gaps = usize::from(self.is_end(star.start));
        (star.start + gaps..star.end).map(move |p| self.neighbour(v, p))
    }

    #[inline]
    fn neighbours(&self, v: VertexId) -> impl Iterator<Item = VertexId> {
        self.one_ring(v)
    }
}

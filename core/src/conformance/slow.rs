//! What the laws expect: found by comparing every half-edge with every other.
use crate::{FaceId, HalfEdgeId, Handle, Topology, VertexId, corner};
use alloc::{collections::BTreeSet, vec, vec::Vec};

/// A face list as the plainest of meshes.
pub(super) struct FaceList<'a> {
    pub(super) vertices: usize,
    pub(super) faces: &'a [[u32; 3]],
}

impl Topology for FaceList<'_> {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    fn vertex_count(&self) -> usize {
        self.vertices
    }

    fn face_count(&self) -> usize {
        self.faces.len()
    }

    fn origin(&self, h: HalfEdgeId) -> VertexId {
        VertexId::new(corner::origin(self.faces, h.index()) as usize)
    }
}

/// One half-edge. Others are named by their place in the list of all.
pub(super) struct Side<H> {
    pub(super) name: H,
    pub(super) from: usize,
    pub(super) to: usize,
    pub(super) next: usize,
    pub(super) prev: usize,
    /// All along the same edge, itself among them.
    pub(super) along: Vec<usize>,
}

/// Every half-edge of a mesh, in the order in which it lists them.
pub(super) struct Slow<H> {
    pub(super) sides: Vec<Side<H>>,
    pub(super) vertices: usize,
}

impl<H: Handle> Slow<H> {
    pub(super) fn of<T: Topology<HalfEdge = H>>(mesh: &T) -> Self {
        let names: Vec<H> = mesh.half_edges().collect();
        let place = |h| names.iter().position(|&g| g == h).expect("`half_edges` lists every half-edge");
        let ends = |h| (mesh.origin(h).index(), mesh.target(h).index());
        let is_along = |h, g| ends(h) == ends(g) || ends(h) == (ends(g).1, ends(g).0);
        let side = |&h: &H| Side {
            name: h,
            from: ends(h).0,
            to: ends(h).1,
            next: place(mesh.next(h)),
            prev: place(mesh.prev(h)),
            along: (0..names.len()).filter(|&g| is_along(h, names[g])).collect(),
        };
        Self { sides: names.iter().map(side).collect(), vertices: mesh.vertex_count() }
    }

    pub(super) fn names(&self, places: impl IntoIterator<Item = usize>) -> BTreeSet<H> {
        places.into_iter().map(|i| self.sides[i].name).collect()
    }

    pub(super) fn opposite(&self, i: usize) -> Option<usize> {
        let &[g, h] = &self.sides[i].along[..] else { return None };
        (self.sides[g].from != self.sides[h].from).then_some(if g == i { h } else { g })
    }

    pub(super) fn is_boundary(&self, i: usize) -> bool {
        self.sides[i].along.len() == 1
    }

    /// Whether exactly two half-edges lie along the edge, and run in the same direction.
    pub(super) fn is_same_direction(&self, i: usize) -> bool {
        self.sides[i].along.len() == 2 && self.opposite(i).is_none()
    }

    /// Each edge by its first half-edge. A side that returns to its own vertex is no edge.
    pub(super) fn edges(&self) -> Vec<usize> {
        let is_edge = |side: &Side<H>| side.from != side.to;
        (0..self.sides.len()).filter(|&i| self.sides[i].along[0] == i && is_edge(&self.sides[i])).collect()
    }

    pub(super) fn out_of(&self, v: usize) -> Vec<usize> {
        (0..self.sides.len()).filter(|&i| self.sides[i].from == v).collect()
    }

    /// The half-edge out of the same vertex that a counter-clockwise turn meets next.
    pub(super) fn ccw(&self, i: usize) -> Option<usize> {
        self.opposite(self.sides[i].prev)
    }

    /// The half-edges out of `v`, in groups that turns across opposites connect.
    pub(super) fn fans(&self, v: usize) -> Vec<Vec<usize>> {
        groups(self.out_of(v), |i, j| self.ccw(i) == Some(j) || self.ccw(j) == Some(i))
    }

    /// The half-edges out of `v`, in groups that steps across edges of two faces connect, whichever way these
    /// run.
    pub(super) fn fans_across_edges(&self, v: usize) -> Vec<Vec<usize>> {
        groups(self.out_of(v), |i, j| self.touch(i, j))
    }

    /// Whether the faces of two half-edges out of the same vertex are the two along an edge of that vertex.
    pub(super) fn touch(&self, i: usize, j: usize) -> bool {
        let edges = |i: usize| [i, self.sides[i].prev];
        let touches = |g: usize| {
            self.sides[g].along.len() == 2 && edges(j).iter().any(|&h| g != h && self.is_along(g, h))
        };
        i != j && edges(i).into_iter().any(touches)
    }

    fn is_along(&self, g: usize, h: usize) -> bool {
        self.sides[g].along.contains(&h)
    }

    /// All vertices but `v` that an edge joins to it.
    pub(super) fn neighbours(&self, v: usize) -> BTreeSet<usize> {
        let ends = self.sides.iter().map(|side| (side.from, side.to));
        let other = |(a, b)| if a == v { Some(b) } else { (b == v).then_some(a) };
        ends.filter_map(other).filter(|&u| u != v).collect()
    }

    /// The boundary half-edge that follows boundary half-edge `i`.
    pub(super) fn next_along(&self, i: usize) -> Option<usize> {
        let mut g = self.sides[i].next;
        while let Some(o) = self.opposite(g) {
            g = self.sides[o].next;
        }
        self.is_boundary(g).then_some(g)
    }

    pub(super) fn curve_count(&self) -> usize {
        let boundary = (0..self.sides.len()).filter(|&i| self.is_boundary(i)).collect();
        groups(boundary, |i, j| self.next_along(i) == Some(j) || self.next_along(j) == Some(i)).len()
    }

    /// Vertices with faces, but without one of their own, where as many as can be have one: each looks for a face that
    /// is free, or whose owner finds another (Kuhn 1955).
    pub(super) fn unmatched(&self) -> usize {
        let mut owner = vec![None; self.sides.len()];
        let with_faces = (0..self.vertices).filter(|&v| !self.out_of(v).is_empty());
        with_faces.filter(|&v| !self.is_given_a_face(v, &mut owner, &mut BTreeSet::new())).count()
    }

    /// Faces are named by their first side.
    fn is_given_a_face(&self, v: usize, owner: &mut [Option<usize>], asked: &mut BTreeSet<usize>) -> bool {
        let first = |i: usize| i.min(self.sides[i].next).min(self.sides[i].prev);
        for f in self.out_of(v).into_iter().map(first) {
            let is_new = asked.insert(f);
            if is_new && owner[f].is_none_or(|other| self.is_given_a_face(other, owner, asked)) {
                owner[f] = Some(v);
                return true;
            }
        }
        false
    }

    /// Words of records: for each edge that is not one half-edge or a pair of opposites, one and its half-edges.
    pub(super) fn edge_record_words(&self) -> usize {
        let irregular = |&i: &usize| !self.is_boundary(i) && self.opposite(i).is_none();
        self.edges().into_iter().filter(irregular).map(|i| 1 + self.sides[i].along.len()).sum()
    }

    /// Words of records: for each vertex of several fans, one and its fans.
    pub(super) fn vertex_record_words(&self, fans: impl Fn(usize) -> Vec<Vec<usize>>) -> usize {
        (0..self.vertices).map(|v| fans(v).len()).filter(|&n| n > 1).map(|n| 1 + n).sum()
    }
}

/// The elements in groups that `are_joined` connects.
fn groups(of: Vec<usize>, are_joined: impl Fn(usize, usize) -> bool) -> Vec<Vec<usize>> {
    let mut groups: Vec<Vec<usize>> = Vec::new();
    for i in of {
        let joins = |group: &Vec<usize>| group.iter().any(|&j| are_joined(i, j));
        let (joined, mut rest): (Vec<_>, Vec<_>) = groups.into_iter().partition(joins);
        rest.push(joined.into_iter().flatten().chain(vec![i]).collect());
        groups = rest;
    }
    groups
}

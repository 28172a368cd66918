//! From boundary curves to loops that come by each vertex once.
use super::{FillOptions, LeftReason, clip, edges::Edges, optimal};
use crate::vector::{self, Vector};
use crate::{Adjacency, Handle, Map, boundary};
use alloc::{collections::BTreeMap, vec::Vec};

/// The half-edges of the curve that starts with `start`.
pub(super) fn closed_curve<M: Adjacency + ?Sized>(
    mesh: &M,
    start: M::HalfEdge,
    max_edges: usize,
) -> Result<Vec<M::HalfEdge>, LeftReason> {
    let curve: Vec<_> = boundary::Curve::new(mesh, start).take(max_edges.saturating_add(1)).collect();
    if curve.len() > max_edges {
        return Err(LeftReason::TooLong);
    }
    let is_closed = curve.last().is_some_and(|&last| boundary::next_along(mesh, last) == Some(start));
    if is_closed { Ok(curve) } else { Err(LeftReason::EndsEarly) }
}

/// The loops that a closed curve consists of: each time that it comes back to a vertex, it has closed one.
pub(super) fn simple<M: Adjacency + ?Sized>(mesh: &M, curve: &[M::HalfEdge]) -> Vec<Vec<M::HalfEdge>> {
    let mut loops = Vec::new();
    let mut open: Vec<M::HalfEdge> = Vec::new();
    let mut places = BTreeMap::new();
    for &h in curve {
        if let Some(&place) = places.get(&mesh.origin(h)) {
            let closed = open.split_off(place);
            for &g in &closed {
                places.remove(&mesh.origin(g));
            }
            loops.push(closed);
        }
        places.insert(mesh.origin(h), open.len());
        open.push(h);
    }
    loops.push(open);
    loops
}

/// A loop to be filled. Its edge `i` runs from vertex `i` to the next one.
pub(super) struct Hole {
    pub(super) vertices: Vec<u32>,
    pub(super) points: Vec<Vector>,
    /// The unit normal of the face along each edge, where it has one.
    pub(super) normals: Vec<Option<Vector>>,
    /// The far vertex of the face along each edge.
    apexes: Vec<u32>,
}

impl Hole {
    pub(super) fn of<M: Adjacency + ?Sized>(
        mesh: &M,
        positions: &Map<M::Vertex, [f32; 3]>,
        half_edges: &[M::HalfEdge],
    ) -> Self {
        let number = |v: M::Vertex| v.index() as u32;
        let at = |v: M::Vertex| vector::of(positions[v]);
        let normal = |&h: &M::HalfEdge| normal(mesh.face_vertices(mesh.face(h)).map(at));
        Self {
            vertices: half_edges.iter().map(|&h| number(mesh.origin(h))).collect(),
            points: half_edges.iter().map(|&h| at(mesh.origin(h))).collect(),
            normals: half_edges.iter().map(normal).collect(),
            apexes: half_edges.iter().map(|&h| number(mesh.origin(mesh.prev(h)))).collect(),
        }
    }

    /// Triangles that fill the loop, as places in it, the way round that new faces have to run.
    pub(super) fn triangles(&self, options: &FillOptions, edges: &Edges) -> Option<Vec<[usize; 3]>> {
        match self.vertices.len() {
            0..3 => None,
            3 if self.apexes[0] == self.vertices[2] => None,
            n if n <= options.optimal_edges => optimal::triangles(self, options.weigh_folds, edges),
            _ => clip::triangles(self, edges),
        }
    }

    /// Whether a triangle may have this side: an edge of the loop, or one that the mesh does not have yet.
    pub(super) fn allows(&self, i: usize, j: usize, edges: &Edges) -> bool {
        self.is_side(i, j) || !edges.has([self.vertices[i], self.vertices[j]])
    }

    /// The sides of a triangle that are no edges of the loop, by their vertices.
    pub(super) fn chords(&self, [i, j, k]: [usize; 3]) -> impl Iterator<Item = [u32; 2]> {
        let chords = [[i, j], [j, k], [k, i]].into_iter().filter(|&[i, j]| !self.is_side(i, j));
        chords.map(|ends| ends.map(|i| self.vertices[i]))
    }

    fn is_side(&self, i: usize, j: usize) -> bool {
        let apart = i.abs_diff(j);
        apart == 1 || apart + 1 == self.vertices.len()
    }
}

/// The unit normal of a triangle, where it has one.
fn normal([a, b, c]: [Vector; 3]) -> Option<Vector> {
    vector::direction(vector::cross(vector::minus(b, a), vector::minus(c, a)))
}

//! A face for each vertex, each face for one vertex at most.
use super::Source;
use alloc::vec::Vec;
use onering_core::{
    Adjacency, BuildError, FaceId, HalfEdgeId, Incidence, Map, Slot, Topology, VertexId, memory,
};

/// A largest matching of vertices with faces that they are corners of. Which vertices are left out: at most two of
/// each component with a boundary, both on it; of a closed component one if it is a pillow, else none.
#[derive(Debug)]
pub(super) struct Matching {
    /// For each vertex its half-edge in the face that it has.
    pub(super) of_vertex: Map<VertexId, Slot<HalfEdgeId>>,
    /// For each face its half-edge out of the vertex that has it.
    pub(super) of_face: Map<FaceId, Slot<HalfEdgeId>>,
}

impl Matching {
    /// O(faces).
    pub(super) fn of(mesh: &Source) -> Result<Self, BuildError> {
        let mut search = Search {
            mesh,
            found: Self {
                of_vertex: memory::filled(mesh.vertex_count(), Slot::NONE)?.into(),
                of_face: memory::filled(mesh.face_count(), Slot::NONE)?.into(),
            },
            is_entered: memory::filled(mesh.face_count(), false)?.into(),
            stack: Vec::new(),
            reached_by: memory::filled(mesh.face_count(), Slot::NONE)?.into(),
            reached: Vec::new(),
        };
        // From the boundary where there is one, so that what is left over lies there: the two ends of the first edge.
        let on_boundary = mesh.half_edges().filter(|&h| mesh.is_boundary(h));
        for h in on_boundary.chain(mesh.half_edges()) {
            if !search.is_entered[mesh.face(h)] {
                search.grow(h)?;
                search.cover(mesh.origin(h))?;
                search.cover(mesh.target(h))?;
            }
        }
        Ok(search.found)
    }
}

struct Search<'a> {
    mesh: &'a Source,
    found: Matching,
    is_entered: Map<FaceId, bool>,
    stack: Vec<HalfEdgeId>,
    /// For each face that [`cover`](Self::cover) reached, its half-edge out of the vertex that it was reached from.
    reached_by: Map<FaceId, Slot<HalfEdgeId>>,
    reached: Vec<FaceId>,
}

impl Search<'_> {
    /// Enters the faces of a component, each across an edge, the first across that of `start`. All vertices but the
    /// ends of that edge are met as the tip of a face that is being entered, and get that face.
    fn grow(&mut self, start: HalfEdgeId) -> Result<(), BuildError> {
        let mesh = self.mesh;
        let ends = [mesh.origin(start), mesh.target(start)];
        memory::push(&mut self.stack, start)?;
        while let Some(h) = self.stack.pop() {
            if core::mem::replace(&mut self.is_entered[mesh.face(h)], true) {
                continue;
            }
            let [next, tip] = [mesh.next(h), mesh.prev(h)];
            let v = mesh.origin(tip);
            if self.found.of_vertex[v].get().is_none() && !ends.contains(&v) {
                self.give(tip);
            }
            let first = (h == start).then_some(start);
            for o in [first, Some(next), Some(tip)].into_iter().flatten().filter_map(|g| mesh.opposite(g)) {
                memory::push(&mut self.stack, o)?;
            }
        }
        Ok(())
    }

    /// Gives the face of `h` to its origin.
    fn give(&mut self, h: HalfEdgeId) {
        self.found.of_vertex[self.mesh.origin(h)] = Slot::some(h);
        self.found.of_face[self.mesh.face(h)] = Slot::some(h);
    }

    /// Gives a face to `v`, which has none, and others to those that lose theirs, or changes nothing if that cannot
    /// be: a shortest augmenting path (Berge 1957). O(faces of the component), and there are two searches for each.
    fn cover(&mut self, v: VertexId) -> Result<(), BuildError> {
        let mut at = v;
        let mut next = 0;
        let free = loop {
            if let Some(free) = self.spread(at)? {
                break Some(free);
            }
            let Some(owner) = self.reached.get(next).and_then(|&f| self.found.of_face[f].get()) else {
                break None;
            };
            at = self.mesh.origin(owner);
            next += 1;
        };
        if let Some(free) = free {
            self.exchange(free);
        }
        for f in self.reached.drain(..) {
            self.reached_by[f] = Slot::NONE;
        }
        Ok(())
    }

    /// Reaches the faces of `v`, until one is free.
    fn spread(&mut self, v: VertexId) -> Result<Option<FaceId>, BuildError> {
        let mesh = self.mesh;
        for h in mesh.star(v) {
            let f = mesh.face(h);
            if self.reached_by[f].get().is_none() {
                self.reached_by[f] = Slot::some(h);
                memory::push(&mut self.reached, f)?;
                if self.found.of_face[f].get().is_none() {
                    return Ok(Some(f));
                }
            }
        }
        Ok(None)
    }

    /// Gives each face on the way back to the vertex that it was reached from, up to the one that had none.
    fn exchange(&mut self, free: FaceId) {
        let mut f = free;
        while let Some(h) = self.reached_by[f].get() {
            let before = self.found.of_vertex[self.mesh.origin(h)].get();
            self.give(h);
            match before {
                Some(g) => f = self.mesh.face(g),
                None => break,
            }
        }
    }
}

//! The order of a sorted opposite table.
use super::matching::Matching;
use super::{Sot, Source};
use crate::Renumbering;
use alloc::vec::Vec;
use onering_core::{
    Adjacency, BuildError, FaceId, HalfEdgeId, Handle, Incidence, Map, Topology, VertexId, memory,
};

/// What is known of a vertex, in the order in which the table has them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Inside,
    OnBoundary,
    UnmatchedOnBoundary,
    UnmatchedOfPillow,
    Isolated,
}

const KINDS: [Kind; 5] =
    [Kind::Inside, Kind::OnBoundary, Kind::UnmatchedOnBoundary, Kind::UnmatchedOfPillow, Kind::Isolated];

fn kind(source: &Source, matching: &Matching, v: VertexId) -> Kind {
    let Some(start) = source.outgoing(v) else { return Kind::Isolated };
    match (matching.of_vertex[v].get().is_some(), source.is_boundary(start)) {
        (true, false) => Kind::Inside,
        (true, true) => Kind::OnBoundary,
        (false, true) => Kind::UnmatchedOnBoundary,
        (false, false) => Kind::UnmatchedOfPillow,
    }
}

/// The maps, and how many vertices there are of each kind.
#[derive(Debug)]
pub(super) struct Order {
    renumbering: Renumbering,
    /// For each face of the list the one of the table that it is now.
    face_target: Map<FaceId, u32>,
    /// For each vertex without a face of its own where its fan starts, in the numbers of the table.
    unmatched: Vec<HalfEdgeId>,
    inside_count: usize,
    matched_count: usize,
}

impl Order {
    pub(super) fn of(source: &Source, matching: &Matching) -> Result<Self, BuildError> {
        let mut vertices: Vec<VertexId> = memory::with_room(source.vertex_count())?;
        let ends = KINDS.map(|of| {
            vertices.extend(source.vertices().filter(|&v| kind(source, matching, v) == of));
            vertices.len()
        });
        let [inside_count, matched_count, on_boundary_end, unmatched_end, _] = ends;
        let mut order = Self::of_faces(source, matching, &vertices[..matched_count])?;
        (order.inside_count, order.matched_count) = (inside_count, matched_count);
        let start = |v: &VertexId| source.outgoing(*v).map(|h| order.half_edge(h));
        vertices[matched_count..on_boundary_end].sort_unstable_by_key(start);
        vertices[on_boundary_end..unmatched_end].sort_unstable_by_key(start);
        let mut unmatched = memory::with_room(unmatched_end - matched_count)?;
        unmatched.extend(vertices[matched_count..unmatched_end].iter().filter_map(start));
        order.unmatched = unmatched;
        let mut target = memory::filled(vertices.len(), 0)?;
        vertices.iter().zip(0..).for_each(|(v, i)| target[v.index()] = i);
        order.renumbering.vertex_target = target;
        order.renumbering.vertex_source = memory::collected(vertices.iter().map(|v| v.index() as u32))?;
        Ok(order)
    }

    /// The order of faces: those that belong to these vertices, then the others.
    fn of_faces(source: &Source, matching: &Matching, owners: &[VertexId]) -> Result<Self, BuildError> {
        let owned = owners.iter().filter_map(|&v| matching.of_vertex[v].get());
        let free = source.faces().filter(|&f| matching.of_face[f].get().is_none());
        let mut face_source = memory::with_room(source.face_count())?;
        let mut first_corner = memory::with_room(source.face_count())?;
        let mut face_target: Map<FaceId, u32> = memory::filled(source.face_count(), 0)?.into();
        for h in owned.chain(free.map(|f| source.first(f))) {
            face_target[source.face(h)] = face_source.len() as u32;
            face_source.push(source.face(h).index() as u32);
            first_corner.push((h.index() % 3) as u8);
        }
        let renumbering = Renumbering { face_source, first_corner, ..Renumbering::default() };
        Ok(Self { renumbering, face_target, unmatched: Vec::new(), inside_count: 0, matched_count: 0 })
    }

    /// The half-edge of the table that `h` of the list is now.
    fn half_edge(&self, h: HalfEdgeId) -> HalfEdgeId {
        let f = self.face_target[FaceId::new(h.index() / 3)] as usize;
        let first = usize::from(self.renumbering.first_corner[f]);
        HalfEdgeId::new(3 * f + (h.index() % 3 + 3 - first) % 3)
    }

    /// The table in this order.
    pub(super) fn encode(self, source: &Source) -> Result<(Sot, Renumbering), BuildError> {
        let cell = |h: usize| {
            let h = self.renumbering.corner_source(h / 3, h % 3);
            match source.opposite(h) {
                Some(o) => self.half_edge(o).index() as i32,
                None => !(self.renumbering.vertex_target[source.origin(h).index()] as i32),
            }
        };
        let opposite = memory::collected((0..source.half_edge_count()).map(cell))?;
        let mesh = Sot {
            vertex_count: source.vertex_count(),
            inside_count: self.inside_count,
            matched_count: self.matched_count,
            opposite: opposite.into(),
            unmatched: self.unmatched.into(),
        };
        Ok((mesh, self.renumbering))
    }
}

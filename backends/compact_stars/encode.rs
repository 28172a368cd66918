//! Compact stars of a mesh, its vertices in an order.
use super::marks::{self, Marks};
use super::packed::Packed;
use super::{CompactStars, Source};
use crate::Renumbering;
use alloc::vec::Vec;
use onering_core::{Adjacency, BuildError, HalfEdgeId, Handle, Incidence, Map, Topology, VertexId, memory};

/// The stars of `source`, vertices numbered in this order, in which each is once.
pub(super) fn encode(source: &Source, order: &[VertexId]) -> Result<(CompactStars, Renumbering), BuildError> {
    let mut target: Map<VertexId, u32> = memory::filled(order.len(), 0)?.into();
    order.iter().zip(0..).for_each(|(&v, i)| target[v] = i);
    let mut stars = Stars::new(source, &target)?;
    order.iter().for_each(|&v| stars.add(source, &target, v));
    let maps = Renumbering {
        vertex_source: memory::collected(order.iter().map(|v| v.index() as u32))?,
        vertex_target: target.into_vec(),
        ..stars.maps
    };
    marks::mark(&mut stars.starts, stars.at);
    let mesh = CompactStars {
        vertex_count: order.len(),
        face_count: source.face_count(),
        place_count: stars.at,
        neighbours: stars.neighbours,
        starts: Marks::new(stars.starts)?,
        firsts: Marks::new(stars.firsts)?,
    };
    Ok((mesh, maps))
}

/// Stars one after the other.
struct Stars {
    neighbours: Packed,
    starts: Vec<u64>,
    firsts: Vec<u64>,
    /// Faces in the order in which their first half-edges come.
    maps: Renumbering,
    /// The place of the next neighbour.
    at: usize,
}

impl Stars {
    /// Room for all.
    fn new(source: &Source, target: &Map<VertexId, u32>) -> Result<Self, BuildError> {
        let gaps: usize = source.vertices().map(|v| gaps(source, v)).sum();
        let places = check_places(source.half_edge_count().saturating_add(gaps))?;
        let span = |h| target[source.origin(h)].abs_diff(target[source.target(h)]);
        let longest = source.half_edges().map(span).max().unwrap_or(0);
        let face_source = memory::with_room(source.face_count())?;
        let first_corner = memory::with_room(source.face_count())?;
        Ok(Self {
            neighbours: Packed::zeros(places, longest)?,
            starts: marks::no_marks(places + 1)?,
            firsts: marks::no_marks(places)?,
            maps: Renumbering { face_source, first_corner, ..Renumbering::default() },
            at: 0,
        })
    }

    /// The star of `v`, which is the next vertex.
    fn add(&mut self, source: &Source, target: &Map<VertexId, u32>, v: VertexId) {
        marks::mark(&mut self.starts, self.at);
        if gaps(source, v) > 0 {
            self.at += 1;
            source.outgoing(v).into_iter().for_each(|h| self.push(target[v], target[source.target(h)]));
        }
        for h in source.star(v) {
            let [a, b] = [source.target(h), source.origin(source.prev(h))].map(|w| target[w]);
            if target[v] < a.min(b) {
                marks::mark(&mut self.firsts, self.at);
                self.maps.face_source.push((h.index() / 3) as u32);
                self.maps.first_corner.push((h.index() % 3) as u8);
            }
            self.push(target[v], b);
        }
    }

    /// Neighbour `w` of `v`, by how far it is from there.
    fn push(&mut self, v: u32, w: u32) {
        self.neighbours.set(self.at, i64::from(w) - i64::from(v));
        self.at += 1;
    }
}

/// How many places of `v` are no half-edges out of it: the end of an open star, and its first neighbour.
fn gaps(source: &Source, v: VertexId) -> usize {
    match source.outgoing(v) {
        None => 1,
        Some(h) if source.is_boundary(h) => 2,
        Some(_) => 0,
    }
}

/// Whether there are half-edge handles for so many places, and one more where the last star ends.
fn check_places(places: usize) -> Result<usize, BuildError> {
    let limit = HalfEdgeId::MAX_INDEX;
    if places > limit { Err(BuildError::TooManyHalfEdges { half_edges: places, limit }) } else { Ok(places) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn handles_of_four_bytes_are_the_limit() {
        let limit = u32::MAX as usize - 1;
        assert_eq!(check_places(limit), Ok(limit));
        let error = BuildError::TooManyHalfEdges { half_edges: limit + 1, limit };
        assert_eq!(check_places(limit + 1), Err(error));
    }
}

//! What meets at each vertex.

use super::sheets::Sheets;
use crate::{BuildError, HalfEdgeId, Map, Topology, VertexId, memory};
use alloc::vec::Vec;

/// The figures of the vertices, and by slot what they are made of.
pub(crate) struct Vertices {
    /// How many edges each slot has: none where no triangle uses it.
    pub(crate) valence: Map<VertexId, u32>,
    pub(crate) bowties: Vec<u32>,
    pub(crate) nonmanifold: Vec<u32>,
    pub(crate) max_faces: usize,
}

impl Vertices {
    /// O(half-edges), after the umbrellas of the mesh.
    pub(crate) fn of(sheets: &Sheets, umbrella: &Map<HalfEdgeId, HalfEdgeId>) -> Result<Self, BuildError> {
        let fans = count(sheets, |h| umbrella[h] == h)?;
        let mut singular: Map<VertexId, bool> = memory::filled(sheets.vertex_count(), false)?.into();
        let many = sheets.irregular().filter(|edge| edge.len() > 2);
        many.flat_map(|edge| sheets.ends(edge[0])).for_each(|v| singular[v] = true);
        let names = |slots: &dyn Fn(&VertexId) -> bool| {
            let mut names = Vec::new();
            let mut found = sheets.vertices().filter(slots).map(|slot| sheets.triangles.vertex(slot));
            found.try_for_each(|v| memory::push(&mut names, v)).map(|()| names)
        };
        Ok(Self {
            bowties: names(&|&v| fans[v] > 1)?,
            nonmanifold: names(&|&v| fans[v] > 1 || singular[v])?,
            max_faces: count(sheets, |_| true)?.as_slice().iter().max().map_or(0, |&n| n as usize),
            valence: valence(sheets)?,
        })
    }
}

fn valence(sheets: &Sheets) -> Result<Map<VertexId, u32>, BuildError> {
    let mut valence: Map<VertexId, u32> = memory::filled(sheets.vertex_count(), 0)?.into();
    sheets.edges().flat_map(|h| sheets.ends(h)).for_each(|v| valence[v] += 1);
    Ok(valence)
}

/// How many such half-edges start at each slot.
fn count(sheets: &Sheets, which: impl Fn(HalfEdgeId) -> bool) -> Result<Map<VertexId, u32>, BuildError> {
    let mut counts: Map<VertexId, u32> = memory::filled(sheets.vertex_count(), 0)?.into();
    sheets.half_edges().filter(|&h| which(h)).for_each(|h| counts[sheets.origin(h)] += 1);
    Ok(counts)
}

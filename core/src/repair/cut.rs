//! Cutting: one vertex for each fan that is left when only consistent edges of two triangles join.
//!
//! Such a fan is a path or a cycle of triangles, oriented alike, so an edge at it has at most two of them, and
//! two only where the path's ends meet: in opposite directions, and at both ends of the edge or at none. That is why
//! vertices need cutting only, and no edge can become non-manifold again by its copies falling together. It
//! also heals what it can: a fin on a closed surface comes off, and the surface stays whole.
//! After Guéziec, Taubin, Lazarus, Horn, "Cutting and stitching", 2001.

use super::orient::Orientation;
use crate::defects::sheets::Sheets;
use crate::{BuildError, HalfEdgeId, Map, Topology, VertexId, memory, umbrella};
use alloc::vec::Vec;

/// New vertices for the corners of the triangles.
pub(crate) struct Cut {
    /// For each corner 0 if it keeps its vertex, else 1 + the place of its copy in `copied`.
    copy: Map<HalfEdgeId, u32>,
    /// The vertex behind each copy.
    pub(crate) copied: Vec<u32>,
    pub(crate) edges_cut: usize,
    pub(crate) vertices_cut: usize,
}

impl Cut {
    /// Near-linear in the corners. At each vertex the fan with the least corner keeps it; copies are numbered by
    /// the least corners of the other fans.
    pub(crate) fn of(sheets: &Sheets, orientation: &Orientation) -> Result<Self, BuildError> {
        let fan = umbrella::joined_by(sheets, orientation.couples(sheets))?;
        let mut cut = Self { copy: Map::default(), copied: Vec::new(), edges_cut: 0, vertices_cut: 0 };
        cut.copy_vertices(sheets, &fan)?;
        let paired = sheets.paired().filter(|&(h, g)| cut.parts(sheets, h, g)).count();
        let is_cut = |edge: &&[HalfEdgeId]| edge.iter().any(|&g| cut.parts(sheets, edge[0], g));
        cut.edges_cut = paired + sheets.irregular().filter(is_cut).count();
        Ok(cut)
    }

    fn copy_vertices(
        &mut self,
        sheets: &Sheets,
        fan: &Map<HalfEdgeId, HalfEdgeId>,
    ) -> Result<(), BuildError> {
        self.copy = memory::filled(sheets.half_edge_count(), 0)?.into();
        let mut fan_count: Map<VertexId, u32> = memory::filled(sheets.vertex_count(), 0)?.into();
        for (h, &first) in fan.iter() {
            if first < h {
                self.copy[h] = self.copy[first];
                continue;
            }
            let slot = sheets.origin(h);
            let count = &mut fan_count[slot];
            *count += 1;
            self.vertices_cut += usize::from(*count == 2);
            if *count > 1 {
                memory::push(&mut self.copied, sheets.triangles.vertex(slot))?;
                self.copy[h] = self.copied.len() as u32;
            }
        }
        Ok(())
    }

    /// Whether two half-edges of an edge no longer have the same two vertices.
    fn parts(&self, sheets: &Sheets, h: HalfEdgeId, g: HalfEdgeId) -> bool {
        let copies = |corners: [HalfEdgeId; 2]| corners.map(|corner| self.copy[corner]);
        copies([h, sheets.next(h)]) != copies(umbrella::facing(sheets, h, g))
    }

    /// The new vertex of a corner; copies are numbered from `vertex_count`, which with the copies is in range.
    pub(crate) fn vertex(&self, sheets: &Sheets, corner: HalfEdgeId, vertex_count: u32) -> u32 {
        match self.copy[corner] {
            0 => sheets.triangles.vertex(sheets.origin(corner)),
            place => vertex_count + place - 1,
        }
    }
}

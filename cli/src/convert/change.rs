//! Welding, mending, filling and reordering, with the polygons that outlast it.

use super::{Method, fill_holes, reorder};
use crate::failure::Failure;
use onering::BuildError;
use onering::repair::{RepairError, RepairOptions, Repaired, repair, weld};
use onering_io::Triangles;
use std::fmt::Display;

/// What was done to the mesh.
#[derive(Debug, Default)]
pub(crate) struct Change {
    /// How many vertices were welded away, where that was asked for.
    pub(crate) welded: Option<usize>,
    /// What the repair did beside, in words, where that was asked for.
    pub(crate) repaired: Option<String>,
    /// Which holes were filled, in words, where that was asked for.
    pub(crate) filled: Option<String>,
    /// How it was put in order, where that was asked for.
    pub(crate) reordered: Option<Method>,
}

impl Change {
    /// Welds and repairs the mesh of this name, where that is asked for.
    pub(crate) fn apply(weld: bool, repair: bool, name: &str, mesh: &mut Triangles) -> Result<Self, Failure> {
        let failed = |error: &dyn Display| Failure::Output(format!("{name}: {error}"));
        let welded = weld.then(|| weld_vertices(mesh)).transpose();
        let welded = welded.map_err(|error| failed(&format_args!("weld: {error}")))?;
        let repaired = repair.then(|| mend(mesh)).transpose();
        let repaired = repaired.map_err(|error| failed(&format_args!("repair: {error}")))?;
        Ok(Self { welded, repaired, ..Self::default() })
    }

    /// Fills holes of up to so many edges, and puts vertices and faces in order, where that is asked for.
    pub(crate) fn filled_and_reordered(
        self,
        max_edges: Option<usize>,
        reordered: Option<Method>,
        name: &str,
        mesh: &mut Triangles,
    ) -> Result<Self, Failure> {
        let failed = |what: &str, error: &str| Failure::Output(format!("{name}: {what}: {error}"));
        let filled = max_edges.map(|max_edges| fill_holes::apply(max_edges, mesh)).transpose();
        let filled = filled.map_err(|error| failed("fill holes", &error))?;
        let order = reordered.map_or(Ok(()), |method| reorder::apply(method, mesh));
        order.map_err(|error| failed("reorder", &error))?;
        Ok(Self { filled, reordered, ..self })
    }
}

/// How many vertices it took away.
fn weld_vertices(mesh: &mut Triangles) -> Result<usize, BuildError> {
    let before = mesh.positions.len();
    let welded = weld(&mesh.positions)?;
    mesh.positions = welded.source.iter().map(|&v| mesh.positions[v as usize]).collect();
    mesh.faces.as_flattened_mut().iter_mut().for_each(|corner| *corner = welded.target[*corner as usize]);
    Ok(before - mesh.positions.len())
}

/// What it did, in words.
fn mend(mesh: &mut Triangles) -> Result<String, RepairError> {
    let mut repaired = repair(mesh.positions.len(), &mesh.faces, &RepairOptions::default())?;
    let steps = repaired.to_string();
    mesh.polygon_starts = carry_polygons(mesh, &mut repaired);
    mesh.positions = repaired.carry_vertices(&mesh.positions);
    mesh.faces = repaired.faces;
    Ok(steps)
}

/// The first new face of each polygon of which faces are left. The faces of a flipped polygon change their order, for
/// only so are they a fan again: `abc acd` is flipped to `adc acb`, the polygon `adcb`.
fn carry_polygons(mesh: &Triangles, repaired: &mut Repaired) -> Option<Vec<u32>> {
    mesh.polygon_starts.as_ref()?;
    let Repaired { face_source, faces, flipped, .. } = repaired;
    let mut starts = Vec::new();
    let mut start = 0;
    for polygon in face_source.chunk_by(|&f, &g| mesh.polygon(f as usize) == mesh.polygon(g as usize)) {
        let end = start + polygon.len();
        if flipped.binary_search(&polygon[0]).is_ok() {
            faces[start..end].reverse();
        }
        starts.push(start as u32);
        start = end;
    }
    Some(starts)
}

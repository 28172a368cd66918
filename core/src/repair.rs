//! From any list of triangles to one that every backend accepts.
//!
//! ```
//! use onering_core::{defects::Defects, repair::{RepairOptions, repair}};
//! // Three triangles on one edge, one of them twice.
//! let faces = [[0, 1, 2], [1, 0, 3], [0, 1, 4], [2, 0, 1]];
//! let repaired = repair(5, &faces, &RepairOptions::default())?;
//! assert!(Defects::of(repaired.vertex_count, &repaired.faces)?.is_clean());
//! assert_eq!(repaired.dropped.duplicate, [3]);
//! assert_eq!(repaired.vertex_source, [0, 1, 2, 3, 4, 1, 0, 0, 1]);
//! assert_eq!(repaired.to_string(), "1 duplicate face dropped, 1 edge cut, 2 vertices cut, 4 vertices added");
//! # Ok::<(), onering_core::repair::RepairError>(())
//! ```

mod cut;
mod error;
mod orient;
mod report;
mod weld;

pub use error::RepairError;
pub use report::{Dropped, Repaired};
pub use weld::{Welded, Welder, weld, weld_into};

use crate::defects::MAX_FACES;
use crate::defects::duplicates::Duplicates;
use crate::defects::sheets::Sheets;
use crate::defects::triangles::Triangles;
use crate::pairing::check_counts;
use crate::{BuildError, HalfEdgeId, Topology, memory};
use alloc::borrow::Cow;
use alloc::vec::Vec;
use cut::Cut;
use orient::Orientation;

/// What a repair may do beyond what it has to.
#[derive(Clone, Copy, Debug, Default)]
pub struct RepairOptions<'a> {
    /// One position for each vertex: makes vertices at equal positions one, before all else, as [`weld`] does.
    pub weld: Option<&'a [[f32; 3]]>,
}

/// Turns any list of triangles into one that every backend accepts; see [`Repaired`] for what it tells.
///
/// In this order: welds equal positions if asked; drops faces that name no vertex, that name one twice, and
/// that have the same three vertices as an earlier one, in whatever order; orients every patch with the fewest
/// flips; cuts patches that have no orientation along a seam, all faces of an edge of three or more apart, and
/// each vertex into as many as it has fans then. Where at an edge of many faces two still are neighbours around
/// both its ends, they stay joined. Isolated vertices stay. Two faces back to back are copies, so one of them goes,
/// though every backend would hold such a pillow.
///
/// Afterwards every edge has at most two faces, in opposite directions, every vertex at most one fan, and no two
/// faces have the same vertices. No area is lost but that of the dropped faces. Repairing again changes nothing.
///
/// Near-linear in the faces and vertices, in the worst case of [`weld`] O(n log n).
///
/// # Errors
/// [`RepairError`] where numbers or memory do not suffice, or positions do not match the vertices; no list of faces
/// is an error in itself.
pub fn repair(
    vertex_count: usize,
    faces: &[[u32; 3]],
    options: &RepairOptions<'_>,
) -> Result<Repaired, RepairError> {
    check_counts(vertex_count, faces.len(), 3 * MAX_FACES)?;
    check_positions(vertex_count, options)?;
    let welded = options.weld.map(weld).transpose()?;
    let source = welded.as_ref().map(|welded| &welded.source[..]);
    let count = source.map_or(vertex_count, <[u32]>::len);
    let triangles = Triangles::sift(count, &welded_faces(faces, welded.as_ref())?)?;
    let (sheets, duplicate) = without_duplicates(Sheets::join(triangles)?)?;
    let orientation = Orientation::of(&sheets)?;
    let cut = Cut::of(&sheets, &orientation)?;
    let vertex_source = vertex_source(count, source, &cut.copied)?;
    Ok(Repaired {
        vertex_count: vertex_source.len(),
        vertex_source,
        faces: oriented_faces(&sheets, &orientation, &cut, count as u32)?,
        flipped: sheets.triangles.sources(&orientation.flipped()?)?,
        vertices_welded: vertex_count - count,
        edges_cut: cut.edges_cut,
        seam_edges: orientation.seam_edges,
        vertices_cut: cut.vertices_cut,
        vertices_added: cut.copied.len(),
        face_source: sheets.triangles.source,
        dropped: Dropped {
            out_of_range: sheets.triangles.out_of_range,
            degenerate: sheets.triangles.degenerate,
            duplicate,
        },
    })
}

fn check_positions(vertices: usize, options: &RepairOptions<'_>) -> Result<(), RepairError> {
    match options.weld {
        Some(positions) if positions.len() != vertices => {
            Err(RepairError::PositionCount { vertices, positions: positions.len() })
        }
        _ => Ok(()),
    }
}

/// The faces over the welded vertices. Numbers that were out of range stay, and stay out of range.
fn welded_faces<'a>(
    faces: &'a [[u32; 3]],
    welded: Option<&Welded>,
) -> Result<Cow<'a, [[u32; 3]]>, BuildError> {
    let Some(Welded { target, .. }) = welded else { return Ok(Cow::Borrowed(faces)) };
    let new = |v: u32| target.get(v as usize).copied().unwrap_or(v);
    Ok(memory::collected(faces.iter().map(|face| face.map(new)))?.into())
}

/// The triangles without copies, and the faces that were copies.
fn without_duplicates(sheets: Sheets) -> Result<(Sheets, Vec<u32>), BuildError> {
    let copies = Duplicates::find(&sheets)?.copies;
    if copies.is_empty() {
        return Ok((sheets, Vec::new()));
    }
    let faces = sheets.triangles.sources(&copies)?;
    Ok((Sheets::join(sheets.into_triangles().without(&copies))?, faces))
}

/// The map back, checked before memory is taken: it is all here that grows with the vertices alone.
fn vertex_source(count: usize, welded: Option<&[u32]>, copied: &[u32]) -> Result<Vec<u32>, BuildError> {
    let vertices = count.saturating_add(copied.len());
    check_counts(vertices, 0, 0)?;
    let mut source = memory::with_room(vertices)?;
    match welded {
        Some(welded) => source.extend(welded),
        None => source.extend(0..count as u32),
    }
    for &v in copied {
        source.push(source[v as usize]);
    }
    Ok(source)
}

fn oriented_faces(
    sheets: &Sheets,
    orientation: &Orientation,
    cut: &Cut,
    vertex_count: u32,
) -> Result<Vec<[u32; 3]>, BuildError> {
    let vertices = |f| sheets.face_half_edges(f).map(|h: HalfEdgeId| cut.vertex(sheets, h, vertex_count));
    let turned = |[a, b, c]: [u32; 3], flip| if flip { [a, c, b] } else { [a, b, c] };
    memory::collected(sheets.faces().map(|f| turned(vertices(f), orientation.flip[f])))
}

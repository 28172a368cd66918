//! Holes filled with triangles.

use onering::holes::{FillOptions, LeftReason, fill};
use onering::{DirectedEdgesSmall, FromFaces};
use onering_io::Triangles;

/// Fills boundary curves of up to so many edges, and says what it did.
pub(super) fn apply(max_edges: usize, mesh: &mut Triangles) -> Result<String, String> {
    let built = DirectedEdgesSmall::from_faces(mesh.positions.len(), &mesh.faces)
        .map_err(|error| format!("{error} (--repair mends that)"))?;
    let mut options = FillOptions::default();
    options.max_edges = max_edges;
    let positions = mesh.positions.clone().into();
    let filled = fill(&built, &positions, &options).map_err(|error| error.to_string())?;
    let first = mesh.faces.len();
    mesh.faces.extend(&filled.faces);
    if let Some(starts) = &mut mesh.polygon_starts {
        starts.extend((first..mesh.faces.len()).map(|face| face as u32));
    }
    let left = |reason: LeftReason| filled.left.iter().filter(|curve| curve.reason == reason).count();
    let reasons = [
        (left(LeftReason::TooLong), "longer than asked"),
        (left(LeftReason::EndsEarly), "not closed"),
        (left(LeftReason::NoWay), "without room for triangles"),
    ];
    let left = reasons.iter().filter(|(count, _)| *count > 0);
    let left: String = left.map(|(count, why)| format!(", {count} left: {why}")).collect();
    let noun = if filled.filled.len() == 1 { "curve" } else { "curves" };
    Ok(format!("{} {noun} filled with {} faces{left}", filled.filled.len(), filled.faces.len()))
}

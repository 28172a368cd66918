//! How the edges of one triangle hang together.

use super::sheets::Sheets;
use crate::disjoint_sets::DisjointSets;
use crate::{BuildError, EdgeId, HalfEdgeId, Handle, Map, Topology, VertexId, memory};

/// Components of the graph of the boundary edges. O(vertices + boundary).
pub(crate) fn components(sheets: &Sheets) -> Result<usize, BuildError> {
    let mut graph = DisjointSets::new(sheets.vertex_count())?;
    let mut touched: Map<VertexId, bool> = memory::filled(sheets.vertex_count(), false)?.into();
    for h in sheets.alone() {
        let ends = sheets.ends(h);
        graph.join(ends[0], ends[1]);
        ends.into_iter().for_each(|v| touched[v] = true);
    }
    Ok(sheets.vertices().filter(|&v| touched[v] && graph.least(v) == v).count())
}

/// What [`boundary::loops`](crate::boundary::loops) gives, from umbrellas that are known already: that one would
/// make them once more where faces disagree, and take 17 bytes for each half-edge. O(b log b) and 20 bytes each
/// for b boundary edges.
pub(crate) fn loops(
    sheets: &Sheets,
    umbrella: &Map<HalfEdgeId, HalfEdgeId>,
) -> Result<Option<usize>, BuildError> {
    let count = sheets.alone().count();
    let mut ends = memory::with_room(2 * count)?;
    for (e, h) in (0..count).map(EdgeId::new).zip(sheets.alone()) {
        ends.extend([(umbrella[h], e), (umbrella[sheets.next(h)], e)]);
    }
    ends.sort_unstable();
    let mut curves = DisjointSets::new(count)?;
    for two in ends.chunk_by(|a, b| a.0 == b.0) {
        let &[(_, a), (_, b)] = two else { return Ok(None) };
        curves.join(a, b);
    }
    Ok(Some((0..count).map(EdgeId::new).filter(|&e| curves.least(e) == e).count()))
}

//! The law of [`Footprint`].
use crate::{
    Footprint,
    conformance::{
        Case,
        slow::{FaceList, Slow},
    },
    footprint::Counts,
};

/// The law of [`Footprint`]: its bytes equal its formula in the numbers of elements that a search finds.
///
/// A record of a vertex has one word for each fan. On a mesh with two faces that run along an edge in the same
/// direction fans may end there or go on, as for [`incidence`](super::incidence); either is right here.
pub fn footprint<M: Footprint>(case: &Case, mesh: &M) {
    let slow = Slow::of(&FaceList { vertices: case.vertices, faces: &case.faces });
    let counts = |vertex_record_words| Counts {
        vertices: case.vertices,
        edges: slow.edges().len(),
        faces: case.faces.len(),
        curves: slow.curve_count(),
        edge_record_words: slow.edge_record_words(),
        vertex_record_words,
        unmatched: slow.unmatched(),
    };
    let across_edges = M::BYTES.of(&counts(slow.vertex_record_words(|v| slow.fans_across_edges(v))));
    if mesh.heap_bytes() != across_edges {
        let across_opposites = M::BYTES.of(&counts(slow.vertex_record_words(|v| slow.fans(v))));
        assert_eq!(mesh.heap_bytes(), across_opposites, "{}: {}", case.name, M::BYTES);
    }
}

//! Asks for `che-l3`: it draws boundary curves and edges.
use onering::{Boundaries, EdgeMap, Mesh};

/// Number of boundary curves, and of edges.
pub fn lines(mesh: &Mesh) -> (usize, usize) {
    (mesh.curve_count(), mesh.edge_count())
}

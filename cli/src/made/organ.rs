//! Something soft to press.

use onering_io::Triangles;

/// A closed surface.
pub(crate) fn mesh() -> Triangles {
    let positions = vec![[1.0, 1.0, 1.0], [-1.0, -1.0, 1.0], [-1.0, 1.0, -1.0], [1.0, -1.0, -1.0]];
    Triangles::new(positions, vec![[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]])
}

//! A backend of one's own, in a crate of one's own: a terrain on a regular grid, which stores nothing but its
//! size. It answers the whole ladder, so every generic algorithm runs on it; tests/your_own_backend.rs runs the laws on it.
//!
//! `cargo run --example your_own_backend`
use onering::{Adjacency, FaceId, HalfEdgeId, Handle, Incidence, Topology, VertexId, boundary};

/// Squares of two triangles each: the lower right, then the upper left.
#[derive(Clone, Debug)]
pub(crate) struct Grid {
    pub(crate) columns: usize,
    pub(crate) rows: usize,
}

impl Topology for Grid {
    type Vertex = VertexId;
    type HalfEdge = HalfEdgeId;
    type Face = FaceId;

    fn vertex_count(&self) -> usize {
        (self.columns + 1) * (self.rows + 1)
    }

    fn face_count(&self) -> usize {
        2 * self.columns * self.rows
    }

    fn origin(&self, h: HalfEdgeId) -> VertexId {
        let (square, side) = (h.index() / 6, h.index() % 6);
        let (dc, dr) = [(0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)][side];
        let (column, row) = (square % self.columns + dc, square / self.columns + dr);
        VertexId::new(row * (self.columns + 1) + column)
    }
}

impl Adjacency for Grid {
    fn opposite(&self, h: HalfEdgeId) -> Option<HalfEdgeId> {
        let (square, side) = (h.index() / 6, h.index() % 6);
        let (column, row) = (square % self.columns, square / self.columns);
        let (across, other_side) = match side {
            0 if row > 0 => (square - self.columns, 4),
            1 if column + 1 < self.columns => (square + 1, 5),
            2 => (square, 3),
            3 => (square, 2),
            4 if row + 1 < self.rows => (square + self.columns, 0),
            5 if column > 0 => (square - 1, 1),
            _ => return None,
        };
        Some(HalfEdgeId::new(6 * across + other_side))
    }
}

impl Incidence for Grid {
    fn outgoing(&self, v: VertexId) -> Option<HalfEdgeId> {
        if self.columns == 0 || self.rows == 0 {
            return None;
        }
        let (column, row) = (v.index() % (self.columns + 1), v.index() / (self.columns + 1));
        let square = |column: usize, row: usize| 6 * (row * self.columns + column);
        // The most clockwise of the up to six: on the lower border the one that runs right along it, and so on.
        let h = match (column, row) {
            (c, 0) if c < self.columns => square(c, 0),
            (c, r) if c == self.columns && r < self.rows => square(c - 1, r) + 1,
            (c, r) if r == self.rows && c > 0 => square(c - 1, r - 1) + 4,
            (0, r) => square(0, r - 1) + 5,
            (c, r) => square(c, r),
        };
        Some(HalfEdgeId::new(h))
    }
}

fn main() {
    let terrain = Grid { columns: 30, rows: 20 };
    let degrees: usize = terrain.vertices().map(|v| terrain.one_ring(v).count()).sum();
    println!(
        "{terrain:?}: {} vertices, mean degree {:.2}",
        terrain.vertex_count(),
        degrees as f64 / terrain.vertex_count() as f64
    );
    let curves = boundary::curves(&terrain);
    println!(
        "boundary: {} curve of {} half-edges",
        curves.len(),
        boundary::Curve::new(&terrain, curves[0]).count()
    );
}

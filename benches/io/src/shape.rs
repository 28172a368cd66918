//! The mesh that is written: a wavy sheet.

/// Positions and faces of a mesh, and what every reader of it has to find.
pub(crate) struct Shape {
    pub(crate) positions: Vec<[f32; 3]>,
    pub(crate) faces: Vec<[u32; 3]>,
}

/// What a reader found, for comparing readers with each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Answer {
    pub(crate) triangles: usize,
    /// Sum of x + 2 y + 3 z over all corners in order: the same bits for the same triangles, however a library
    /// numbers its vertices.
    pub(crate) sum: f64,
}

impl Answer {
    /// Of the corners of all triangles, in order.
    pub(crate) fn of(corners: impl Iterator<Item = [f32; 3]>) -> Self {
        let (mut count, mut sum) = (0, 0.0);
        for [x, y, z] in corners {
            count += 1;
            sum += f64::from(x) + 2.0 * f64::from(y) + 3.0 * f64::from(z);
        }
        Self { triangles: count / 3, sum }
    }

    pub(crate) fn of_indexed(positions: &[[f32; 3]], faces: &[[u32; 3]]) -> Self {
        Self::of(faces.as_flattened().iter().map(|&v| positions[v as usize]))
    }
}

impl Shape {
    pub(crate) fn answer(&self) -> Answer {
        Answer::of_indexed(&self.positions, &self.faces)
    }
}

/// A square sheet of about so many triangles, row by row. Its coordinates have six decimals, as most programs write
/// them.
pub(crate) fn sheet(triangles: usize) -> Shape {
    let side = ((triangles / 2) as f64).sqrt().round().max(1.0) as usize + 1;
    let round = |x: f64| ((x * 1e6).round() / 1e6) as f32;
    let position = |i: usize| {
        let [u, v] = [i % side, i / side].map(|i| i as f64 / side as f64 - 0.5);
        [round(u), round(v), round((u * 20.0).sin() * (v * 30.0).cos() * 0.1)]
    };
    let corner = |i: usize| (i / (side - 1) * side + i % (side - 1)) as u32;
    let next = side as u32;
    Shape {
        positions: (0..side * side).map(position).collect(),
        faces: (0..(side - 1) * (side - 1))
            .map(corner)
            .flat_map(|a| [[a, a + 1, a + next + 1], [a, a + next + 1, a + next]])
            .collect(),
    }
}

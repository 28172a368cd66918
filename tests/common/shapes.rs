//! Small meshes that several tests start from.
#![allow(dead_code, reason = "each test uses a part of it")]

pub(crate) type Faces = Vec<[u32; 3]>;

/// The cells of Fig. 5 of Biscaro et al. (2016).
pub(crate) const TETRAHEDRON: [[u32; 3]; 4] = [[0, 1, 3], [1, 2, 3], [1, 0, 2], [3, 2, 0]];

/// Five vertices, five faces; all vertices are neighbours and on the boundary. Faces agree but for one pair.
pub(crate) const MOEBIUS: [[u32; 3]; 5] = [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 0], [4, 0, 1]];

/// A closed fan of `n` faces around vertex 0.
pub(crate) fn wheel(n: u32) -> Faces {
    (1..=n).map(|i| [0, i, i % n + 1]).collect()
}

/// `n` by `m` quads, each as two triangles; wrapping makes it a cylinder or torus, and `flip` turns the seam
/// of the first direction round: a Moebius strip or Klein bottle.
pub(crate) fn grid(n: u32, m: u32, wrap: [bool; 2], flip: bool) -> (usize, Faces) {
    let rows = if wrap[0] { n } else { n + 1 };
    let columns = if wrap[1] { m } else { m + 1 };
    let vertex = |i: u32, j: u32| match wrap[0] && i == n {
        true if flip => (m - j) % columns,
        true => j % columns,
        false => i * columns + j % columns,
    };
    let quad = |i, j| {
        let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
        [[a, b, c], [a, c, d]]
    };
    let quads = (0..n).flat_map(|i| (0..m).map(move |j| (i, j)));
    ((rows * columns) as usize, quads.flat_map(|(i, j)| quad(i, j)).collect())
}

/// Numbers without rhyme, the same on every run.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % n
    }
}

/// The same list in an order without rhyme.
pub(crate) fn shuffled(mut faces: Faces) -> Faces {
    let mut random = Random(1);
    (1..faces.len()).rev().for_each(|i| faces.swap(i, random.below(i + 1)));
    faces
}

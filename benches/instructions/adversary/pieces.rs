//! What lists are put together from: surfaces and heaps of faces that are hard on some step of a build.
use crate::meshes::{Faces, Random};

/// Each has a size, which grows with the list or not: see [`Piece::faces`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Family {
    /// Fans of so many faces, beside each other.
    Fans,
    /// Fans of so many faces, all around one vertex.
    Rosette,
    /// So many vertices, each the hub of a fan over the same rim.
    Hubs,
    /// Two closed fans over one rim.
    Bipyramid,
    /// Edges of so many faces.
    Books,
    /// The same three vertices so many times.
    Copies,
    /// Rows of so many quads, three at least.
    Grid,
    /// The same, its rows closed.
    Tube,
    /// The same, closed after a turn.
    Moebius,
    /// The same, closed both ways, one of them after a turn.
    Klein,
    /// Any three of so many vertices.
    Soup,
    /// Any two of so many vertices, with one and the same.
    Bundle,
    /// Each face of some that were there before parted in three, so that few vertices get many neighbours.
    Stacked,
}

const FAMILIES: [Family; 13] = [
    Family::Fans,
    Family::Rosette,
    Family::Hubs,
    Family::Bipyramid,
    Family::Books,
    Family::Copies,
    Family::Grid,
    Family::Tube,
    Family::Moebius,
    Family::Klein,
    Family::Soup,
    Family::Bundle,
    Family::Stacked,
];

#[derive(Clone, Debug)]
pub(crate) struct Piece {
    family: Family,
    /// Which part of all faces it is, of the sum of all shares.
    pub(crate) share: usize,
    /// Of n faces the size is n to the power of so many eighths.
    size: u8,
}

impl Piece {
    pub(crate) fn random(random: &mut Random) -> Self {
        let size = random.below(9) as u8;
        Self { family: random.of(&FAMILIES), share: 1 << random.below(5), size }
    }

    /// Changes one of what it is made by.
    pub(crate) fn change(&mut self, random: &mut Random) {
        match random.below(3) {
            0 => self.family = random.of(&FAMILIES),
            1 => self.share = 1 << random.below(5),
            _ => self.size = random.below(9) as u8,
        }
    }

    /// About `n` faces. Vertex 0 is a hub, where there is one.
    pub(crate) fn faces(&self, n: usize, random: &mut Random) -> Faces {
        let n = n.max(4) as u32;
        let size = f64::from(n).powf(f64::from(self.size) / 8.0) as u32;
        let faces: Vec<[u32; 3]> = match self.family {
            Family::Fans => fans(n, size, |fan| fan * (size + 2)),
            Family::Rosette => fans(n, size, |_| 0),
            Family::Hubs => hubs(n, size),
            Family::Bipyramid => {
                let rim = |i: u32| 2 + i % (n / 2);
                (0..n / 2).flat_map(|i| [[0, rim(i), rim(i + 1)], [1, rim(i + 1), rim(i)]]).collect()
            }
            Family::Books => {
                let page = |i: u32| [i / size * 2, i / size * 2 + 1, n.div_ceil(size) * 2 + i];
                (0..n).map(|i| if i % 2 == 0 { page(i) } else { reversed(page(i)) }).collect()
            }
            Family::Copies => (0..n).map(|i| [0, 1, 2].map(|k| i / size * 3 + k)).collect(),
            Family::Grid => grid(n, size, false, false, 0),
            Family::Tube => grid(n, size, true, false, 0),
            Family::Moebius => grid(n, size, true, false, 1),
            Family::Klein => grid(n, size, true, true, 1),
            Family::Soup => (0..n).map(|_| three(size.max(4), random)).collect(),
            Family::Bundle => {
                let two = |[_, a, b]: [u32; 3]| {
                    [0, a.max(1), if b == 0 || a.max(1) == b { a.max(1) + 1 } else { b }]
                };
                (0..n).map(|_| two(three(size.max(4), random))).collect()
            }
            Family::Stacked => stacked(n, size, random),
        };
        (faces.as_flattened().iter().max().map_or(0, |&v| v as usize + 1), faces)
    }
}

fn reversed([a, b, c]: [u32; 3]) -> [u32; 3] {
    [b, a, c]
}

/// Open fans of `size` faces around the vertices that `hub` names.
fn fans(n: u32, size: u32, hub: impl Fn(u32) -> u32) -> Vec<[u32; 3]> {
    (0..n)
        .map(|i| {
            let (fan, at) = (i / size, i % size);
            let rim = fan * (size + 2) + 1 + at;
            [hub(fan), rim, rim + 1]
        })
        .collect()
}

/// Fans of as many hubs, turned this way and that, over one rim.
fn hubs(n: u32, hubs: u32) -> Vec<[u32; 3]> {
    let face = |i: u32| [i % hubs, hubs + i / hubs, hubs + i / hubs + 1];
    (0..n).map(|i| if (i % hubs).is_multiple_of(2) { face(i) } else { reversed(face(i)) }).collect()
}

/// Rows of so many quads, each cut in two; closed along the rows, which may come back upside down, and across.
fn grid(n: u32, columns: u32, is_tube: bool, is_torus: bool, turns: u32) -> Vec<[u32; 3]> {
    let least = if is_tube { 3 } else { 1 };
    let columns = columns.clamp(least, (n / 6).max(least));
    let rows = (n / 2 / columns).max(3);
    let wide = if is_tube { columns } else { columns + 1 };
    let high = if is_torus { rows } else { rows + 1 };
    let at = |x: u32, y: u32| {
        let is_over = is_tube && x == columns && turns > 0;
        let y = y % high;
        (if is_over { high - 1 - y } else { y }) * wide + x % wide
    };
    let quad = |x, y| {
        let [a, b, c, d] = [at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)];
        [[a, b, c], [a, c, d]]
    };
    (0..rows).flat_map(|y| (0..columns).flat_map(move |x| quad(x, y))).collect()
}

/// Three different vertices.
fn three(vertices: u32, random: &mut Random) -> [u32; 3] {
    let mut any = || random.below(vertices as usize) as u32;
    let [a, b, c] = [any(), any(), any()];
    let b = if b == a { (a + 1) % vertices } else { b };
    let free = |v: u32| v != a && v != b;
    [a, b, (c..c + 3).map(|v| v % vertices).find(|&v| free(v)).unwrap_or(c)]
}

/// A vertex is put into a face, one of the first `size`, until there are so many.
fn stacked(n: u32, size: u32, random: &mut Random) -> Vec<[u32; 3]> {
    let mut faces = vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]];
    for v in 4..n / 2 + 2 {
        let at = random.below(faces.len().min(size as usize));
        let [a, b, c] = faces[at];
        faces[at] = [a, b, v];
        faces.extend([[b, c, v], [c, a, v]]);
    }
    faces
}

/// Every family of every size is about as large as it was asked to be.
pub(crate) fn check() {
    let mut random = Random::default();
    for (family, size) in FAMILIES.into_iter().flat_map(|family| (0..9).map(move |size| (family, size))) {
        let (_, faces) = Piece { family, share: 1, size }.faces(2000, &mut random);
        assert!((1000..=2001).contains(&faces.len()), "{} faces of {family:?} {size}", faces.len());
    }
}

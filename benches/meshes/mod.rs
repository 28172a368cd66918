//! The meshes that benchmarks share, in the order in which they are made and shuffled: the same on every machine.
#![allow(dead_code, reason = "no benchmark uses all of it")]
use onering::{CheL1, FromFaces, Map, VertexId, subdivision};

/// Faces over so many vertices.
pub(crate) type Faces = (usize, Vec<[u32; 3]>);

/// A position for each vertex, and faces.
pub(crate) type Placed = (Map<VertexId, [f32; 3]>, Vec<[u32; 3]>);

/// An icosahedron divided so many times, in the order of the library's own subdivision, which is coherent.
pub(crate) fn icosphere(levels: usize) -> Placed {
    let t = (1.0 + 5_f32.sqrt()) / 2.0;
    let mut positions: Map<VertexId, [f32; 3]> = (0..12)
        .map(|i| {
            let [a, b] = [1.0 - (i & 1) as f32 * 2.0, t * (1.0 - (i >> 1 & 1) as f32 * 2.0)];
            [[a, b, 0.0], [0.0, a, b], [b, 0.0, a]][i >> 2]
        })
        .collect();
    let mut faces = icosahedron(positions.as_slice());
    for _ in 0..levels {
        let mesh = CheL1::from_faces(positions.len(), &faces).expect("a sphere");
        let finer = subdivision::loop_subdivision(&mesh, &positions).expect("finite positions");
        (positions, faces) = (finer.positions.into(), finer.faces);
    }
    (positions, faces)
}

/// The same, without positions.
pub(crate) fn sphere(levels: usize) -> Faces {
    let (positions, faces) = icosphere(levels);
    (positions.len(), faces)
}

/// All triples of corners that are near to each other, turned outward.
fn icosahedron(corners: &[[f32; 3]]) -> Vec<[u32; 3]> {
    let near = |a: [f32; 3], b: [f32; 3]| (0..3).map(|i| (a[i] - b[i]).powi(2)).sum::<f32>() < 4.5;
    let triples = (0..12).flat_map(|a| (a + 1..12).flat_map(move |b| (b + 1..12).map(move |c| [a, b, c])));
    let faces = triples.filter_map(|[a, b, c]: [usize; 3]| {
        let [p, q, r] = [a, b, c].map(|v| corners[v]);
        let outward = p[0] * (q[1] * r[2] - q[2] * r[1])
            + p[1] * (q[2] * r[0] - q[0] * r[2])
            + p[2] * (q[0] * r[1] - q[1] * r[0]);
        let face = if outward > 0.0 { [a, b, c] } else { [a, c, b] };
        (near(p, q) && near(q, r) && near(r, p)).then(|| face.map(|v| v as u32))
    });
    faces.collect()
}

/// A closed torus of `2 columns rows` triangles, row after row.
pub(crate) fn torus(columns: u32, rows: u32) -> Faces {
    let v = |c: u32, r: u32| (r % rows) * columns + c % columns;
    let quad = |c, r| {
        let [a, b, d, e] = [v(c, r), v(c + 1, r), v(c + 1, r + 1), v(c, r + 1)];
        [[a, b, d], [a, d, e]]
    };
    let faces = (0..rows).flat_map(|r| (0..columns).flat_map(move |c| quad(c, r))).collect();
    ((columns * rows) as usize, faces)
}

/// New numbers for all vertices, and all faces in a new order.
pub(crate) fn shuffled((vertex_count, faces): &Faces) -> Faces {
    (*vertex_count, renumbered(&shuffled_numbers(*vertex_count), faces))
}

/// The same, with positions.
pub(crate) fn shuffled_with_positions((positions, faces): &Placed) -> Placed {
    let numbers = shuffled_numbers(positions.len());
    let mut placed = positions.clone();
    positions.as_slice().iter().zip(&numbers).for_each(|(&p, &v)| placed.as_mut_slice()[v as usize] = p);
    (placed, renumbered(&numbers, faces))
}

fn shuffled_numbers(count: usize) -> Vec<u32> {
    let mut numbers: Vec<u32> = (0..count as u32).collect();
    shuffle(&mut numbers);
    numbers
}

fn renumbered(numbers: &[u32], faces: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut faces: Vec<_> = faces.iter().map(|face| face.map(|v| numbers[v as usize])).collect();
    shuffle(&mut faces);
    faces
}

/// By a fixed seed.
pub(crate) fn shuffle<T>(things: &mut [T]) {
    Random::default().shuffle(things);
}

/// Marsaglia's xorshift.
pub(crate) struct Random(u64);

impl Default for Random {
    fn default() -> Self {
        Self(88172645463325252)
    }
}

impl Random {
    /// Seeds that are near each other give numbers that are not; none is 0, where xorshift stands still.
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed.wrapping_add(1).wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    pub(crate) fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    /// A number below `limit`.
    pub(crate) fn below(&mut self, limit: usize) -> usize {
        (self.next() % limit as u64) as usize
    }

    /// One of these.
    pub(crate) fn of<T: Clone>(&mut self, things: &[T]) -> T {
        things[self.below(things.len())].clone()
    }

    pub(crate) fn shuffle<T>(&mut self, things: &mut [T]) {
        for i in (1..things.len()).rev() {
            things.swap(i, self.below(i + 1));
        }
    }
}

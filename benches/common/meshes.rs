//! Meshes that several benchmarks run on.
#![allow(dead_code, reason = "each benchmark uses a part of it")]
use std::collections::HashMap;

/// Number of vertices, and faces.
pub(crate) type Mesh = (usize, Vec<[u32; 3]>);

/// An icosahedron with every triangle divided into four, so many times.
pub(crate) fn icosphere(times: u32) -> Mesh {
    let band = |i: u32| [1 + i % 5, 1 + (i + 1) % 5, 6 + i % 5, 6 + (i + 1) % 5];
    let faces = |[a, b, c, d]: [u32; 4]| [[0, a, b], [a, c, b], [b, c, d], [c, 11, d]];
    let mut faces: Vec<[u32; 3]> = (0..5).map(band).flat_map(faces).collect();
    let mut vertices = 12;
    for _ in 0..times {
        let mut middles = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                vertices += 1;
                vertices - 1
            })
        };
        let four = |[a, b, c]: [u32; 3]| {
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        };
        faces = faces.into_iter().flat_map(four).collect();
    }
    (vertices as usize, faces)
}

/// The same mesh, its vertices and faces in an order without a pattern.
pub(crate) fn shuffled((vertices, mut faces): Mesh) -> Mesh {
    let mut state = 88172645463325252_u64;
    let mut below = |n: usize| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state % n as u64) as usize
    };
    let mut number: Vec<u32> = (0..vertices as u32).collect();
    for i in (1..vertices).rev() {
        number.swap(i, below(i + 1));
    }
    for face in &mut faces {
        *face = face.map(|v| number[v as usize]);
    }
    for i in (1..faces.len()).rev() {
        faces.swap(i, below(i + 1));
    }
    (vertices, faces)
}

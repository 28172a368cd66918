//! Closed surfaces and a disk, on grids.
use crate::{
    BuildError,
    conformance::{Case, Flaw},
};
use alloc::{vec, vec::Vec};

pub(super) fn cases() -> Vec<Case> {
    vec![
        Case::new("disk", 16, &disk(3, 3), 33, 1),
        Case::new("torus", 12, &torus(4, 3), 36, 0),
        // Each torus has 9 vertices, 27 edges and 18 faces, and they share a triangle that is no face.
        Case::new("genus 2", 15, &genus_2(), 51, 0),
        klein_bottle(),
    ]
}

/// `n` by `m` squares of two faces each: (n + 1)(m + 1) vertices, 3nm + n + m edges.
fn disk(n: u32, m: u32) -> Vec<[u32; 3]> {
    squares(n, m, |i, j| i * (m + 1) + j)
}

/// The faces of a torus of `n` by `m` vertices, both at least 3: 3nm edges and 2nm faces.
pub fn torus(n: u32, m: u32) -> Vec<[u32; 3]> {
    squares(n, m, |i, j| i % n * m + j % m)
}

/// A torus that is turned over where it closes the long way.
fn klein(n: u32, m: u32) -> Vec<[u32; 3]> {
    squares(n, m, |i, j| if i < n { i * m + j % m } else { (2 * m - j) % m })
}

fn squares(n: u32, m: u32, vertex: impl Fn(u32, u32) -> u32) -> Vec<[u32; 3]> {
    let mut faces = Vec::new();
    for i in 0..n {
        for j in 0..m {
            let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
            faces.extend([[a, b, c], [a, c, d]]);
        }
    }
    faces
}

/// Two tori, without their first faces, joined along these.
fn genus_2() -> Vec<[u32; 3]> {
    let first = torus(3, 3);
    let [a, b, c] = first[0];
    // The vertices of the second follow, but those on the seam are those of the first, the other way round.
    let mut renamed = [0; 9];
    (renamed[a as usize], renamed[b as usize], renamed[c as usize]) = (a, c, b);
    let free = (0..9).filter(|&v| ![a, b, c].contains(&v));
    free.zip(9..).for_each(|(v, name)| renamed[v as usize] = name);
    let second = first[1..].iter().map(|f| f.map(|v| renamed[v as usize]));
    first[1..].iter().copied().chain(second).collect()
}

/// Twelve vertices. Where the surface closes, the three edges between vertices 0, 1 and 2 have faces that
/// disagree, and so the ends of these edges have two fans.
fn klein_bottle() -> Case {
    Case::new("Klein bottle", 12, &klein(4, 3), 36, None)
        .with(Flaw::SameDirection, BuildError::SameDirection { vertices: [0, 2], faces: [5, 18] })
        .with(Flaw::SeveralFans, BuildError::SeveralFans { vertex: 0, fans: 2 })
}

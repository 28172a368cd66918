//! Springs as a list of edges, and a dense matrix.
use onering::spring::Stiffness;
use onering::{Adjacency, Handle, Map, edges};
use std::collections::BTreeMap;

pub type Vector = [f64; 3];

/// The springs of a face list: two ends, and how stiff.
pub type Springs = Vec<([usize; 2], f64)>;

/// One spring along every edge; an edge that several faces share has one.
pub fn springs(faces: &[[u32; 3]], stiffness: impl Fn([usize; 2]) -> f64) -> Springs {
    let sides = faces.iter().flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]]);
    let ends = sides.map(|[a, b]| [a.min(b) as usize, a.max(b) as usize]);
    ends.map(|ends| (ends, stiffness(ends))).collect::<BTreeMap<_, _>>().into_iter().collect()
}

/// The same for a mesh: at the least half-edge along each edge; at the others stands what must not be read.
pub fn each<M: Adjacency>(mesh: &M, stiffness: impl Fn([usize; 2]) -> f64) -> Stiffness<M::HalfEdge> {
    let mut each = Map::filled(mesh.half_edge_bound(), f64::NAN);
    for h in edges::each(mesh) {
        let [a, b] = [mesh.origin(h).index(), mesh.target(h).index()];
        each[h] = stiffness([a.min(b), a.max(b)]);
    }
    Stiffness::Each(each)
}

pub fn forces(springs: &Springs, displacement: &[Vector]) -> Vec<Vector> {
    let mut forces = vec![[0.0; 3]; displacement.len()];
    for &([a, b], k) in springs {
        for axis in 0..3 {
            let pull = k * (displacement[b][axis] - displacement[a][axis]);
            forces[a][axis] += pull;
            forces[b][axis] -= pull;
        }
    }
    forces
}

pub fn sum(vectors: &[Vector]) -> Vector {
    vectors.iter().fold([0.0; 3], |[x, y, z], v| [x + v[0], y + v[1], z + v[2]])
}

pub fn dot(a: &[Vector], b: &[Vector]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (0..3).map(|i| a[i] * b[i]).sum::<f64>()).sum()
}

/// Whether two lists of vectors are the same but for rounding errors, relative to the largest number.
pub fn agree(a: &[Vector], b: &[Vector], tolerance: f64) -> bool {
    let largest = a.iter().chain(b).flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
    a.len() == b.len()
        && a.iter().flatten().zip(b.iter().flatten()).all(|(x, y)| (x - y).abs() <= tolerance * largest)
}

/// The displacements at rest of the vertices that are `moving`, the others zero: Gauss with pivots.
pub fn at_rest(springs: &Springs, loads: &[Vector], moving: &[bool]) -> Vec<Vector> {
    let n = loads.len();
    let mut rows: Vec<Vec<f64>> =
        (0..n).map(|i| (0..n).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    for i in (0..n).filter(|&i| moving[i]) {
        rows[i][i] = 0.0;
    }
    for &([a, b], k) in springs {
        for (i, j) in [(a, b), (b, a)] {
            if moving[i] {
                rows[i][i] += k;
                rows[i][j] -= k;
            }
        }
    }
    for i in 0..n {
        rows[i].extend(if moving[i] { loads[i] } else { [0.0; 3] });
    }
    for i in 0..n {
        let pivot = (i..n).max_by(|&a, &b| rows[a][i].abs().total_cmp(&rows[b][i].abs())).unwrap();
        rows.swap(i, pivot);
        let row = rows[i].clone();
        for other in (0..n).filter(|&other| other != i) {
            let factor = rows[other][i] / row[i];
            (i..n + 3).for_each(|j| rows[other][j] -= factor * row[j]);
        }
    }
    (0..n).map(|i| [0, 1, 2].map(|axis| rows[i][n + axis] / rows[i][i])).collect()
}

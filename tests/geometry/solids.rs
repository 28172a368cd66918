//! Meshes in space whose measures are known.
use super::shapes::{Faces, grid};
use onering::{FromFaces, Handle, Map};
use std::collections::HashMap;
use std::f64::consts::TAU;

/// Faces look outward, or upward.
pub struct Solid {
    pub positions: Vec<[f32; 3]>,
    pub faces: Faces,
}

impl Solid {
    /// In the structure `M`, which has to take it.
    pub fn build<M: FromFaces>(&self) -> M {
        M::from_faces(self.positions.len(), &self.faces).unwrap()
    }

    pub fn positions<V: Handle>(&self) -> Map<V, [f32; 3]> {
        self.positions.clone().into()
    }

    /// Moved by a vector.
    pub fn moved(mut self, by: [f32; 3]) -> Self {
        self.positions.iter_mut().for_each(|p| (0..3).for_each(|i| p[i] += by[i]));
        self
    }
}

/// A grid with a position for each row and column.
fn placed(n: u32, m: u32, wrap: [bool; 2], place: impl Fn(f64, f64) -> [f64; 3]) -> Solid {
    let (count, faces) = grid(n, m, wrap, false);
    let columns = if wrap[1] { m } else { m + 1 };
    let at = |v: u32| place(f64::from(v / columns), f64::from(v % columns)).map(|x| x as f32);
    Solid { positions: (0..count as u32).map(at).collect(), faces }
}

/// `n` by `m` unit squares at height 0.
pub fn plane(n: u32, m: u32) -> Solid {
    placed(n, m, [false, false], |i, j| [i, j, 0.0])
}

/// A tube of height 1 around the z axis, its rim of `n` vertices at distance `radius`, open at both ends.
pub fn cylinder(n: u32, rows: u32, radius: f64) -> Solid {
    placed(n, rows, [true, false], |i, j| {
        let turn = TAU * i / f64::from(n);
        [radius * turn.cos(), radius * turn.sin(), j / f64::from(rows)]
    })
}

/// Around the z axis: the middle of the tube at distance 2, its radius 1. The second value of a vertex is the cosine of
/// the angle along the tube: 1 outside, -1 inside.
pub fn torus(n: u32, m: u32) -> (Solid, Vec<f64>) {
    let angle = move |j: f64| TAU * j / f64::from(m);
    let solid = placed(n, m, [true, true], |i, j| {
        let turn = TAU * i / f64::from(n);
        let out = 2.0 + angle(j).cos();
        [out * turn.cos(), out * turn.sin(), angle(j).sin()]
    });
    let cosines = (0..n * m).map(|v| angle(f64::from(v % m)).cos()).collect();
    (solid, cosines)
}

/// A cone of `n` faces from the tip, vertex 0 at height 1, to a rim of radius 1 at height 0, without its base.
pub fn cone(n: u32) -> Solid {
    let rim =
        (0..n).map(|i| TAU * f64::from(i) / f64::from(n)).map(|a| [a.cos() as f32, a.sin() as f32, 0.0]);
    let positions = [[0.0, 0.0, 1.0]].into_iter().chain(rim).collect();
    Solid { positions, faces: super::shapes::wheel(n) }
}

/// A sphere of radius 1: an icosahedron of which each face was cut in four so many times.
pub fn sphere(times: usize) -> Solid {
    let (a, b) = (0.525_731_112_119_133_6, 0.850_650_808_352_039_9);
    let mut points: Vec<[f64; 3]> = [0, 1, 2]
        .into_iter()
        .flat_map(|axis| {
            [[a, b], [a, -b], [-a, b], [-a, -b]].map(|[x, y]| {
                let mut p = [0.0; 3];
                (p[(axis + 1) % 3], p[(axis + 2) % 3]) = (x, y);
                p
            })
        })
        .collect();
    let mut faces = hull(&points);
    for _ in 0..times {
        faces = quartered(&faces, &mut points);
    }
    Solid { positions: points.into_iter().map(|p| p.map(|x| x as f32)).collect(), faces }
}

/// The triangles of three points that are as near to each other as can be, looking outward.
fn hull(points: &[[f64; 3]]) -> Faces {
    let near = |i: u32, j: u32| {
        let [p, q] = [i, j].map(|i| points[i as usize]);
        (0..3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>() < 1.2
    };
    let n = points.len() as u32;
    let mut faces = Vec::new();
    for a in 0..n {
        for b in a + 1..n {
            for c in b + 1..n {
                if near(a, b) && near(b, c) && near(c, a) {
                    let [p, q, r] = [a, b, c].map(|i| points[i as usize]);
                    faces.push(if six_volumes(p, q, r) > 0.0 { [a, b, c] } else { [a, c, b] });
                }
            }
        }
    }
    faces
}

fn six_volumes([a, b, c]: [f64; 3], [d, e, f]: [f64; 3], [g, h, i]: [f64; 3]) -> f64 {
    a * (e * i - f * h) + b * (f * g - d * i) + c * (d * h - e * g)
}

fn quartered(faces: &[[u32; 3]], points: &mut Vec<[f64; 3]>) -> Faces {
    let mut middles = HashMap::new();
    let mut middle = |a: u32, b: u32| {
        *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
            let (p, q) = (points[a as usize], points[b as usize]);
            let sum = [p[0] + q[0], p[1] + q[1], p[2] + q[2]];
            let length = sum.iter().map(|x| x * x).sum::<f64>().sqrt();
            points.push(sum.map(|x| x / length));
            points.len() as u32 - 1
        })
    };
    let mut quarters = Vec::new();
    for &[a, b, c] in faces {
        let [d, e, f] = [middle(a, b), middle(b, c), middle(c, a)];
        quarters.extend([[a, d, f], [d, b, e], [f, e, c], [d, e, f]]);
    }
    quarters
}

//! The best triangulation of a loop, by dynamic programming over its parts.
use super::edges::Edges;
use super::loops::Hole;
use crate::vector::{self, Vector, cross, dot, length, minus};
use alloc::{vec, vec::Vec};

/// The best way to fill what lies between two vertices of the loop, and the chord between them.
#[derive(Clone, Copy)]
struct Part {
    /// The sharpest fold, in [`STEPS`]; compared before area.
    fold: u32,
    area: f64,
    /// The third vertex of the triangle along the chord.
    apex: usize,
    /// The unit normal of that triangle, or of the face of the mesh along an edge of the loop; where it has none, zero.
    normal: Vector,
}

/// Steps from no fold (0) to a right angle. A fold counts as 1 - cos; rounded, so that what should be flat is
/// equally flat, and area decides: one step is 0.08 degrees there.
const STEPS: f64 = 1e6;

const NO_WAY: Part = Part { fold: u32::MAX, area: f64::INFINITY, apex: 0, normal: [0.0; 3] };

/// O(n^3) time, 48 n^2 bytes.
pub(super) fn triangles(hole: &Hole, weigh_folds: bool, edges: &Edges) -> Option<Vec<[usize; 3]>> {
    let n = hole.points.len();
    let mut parts = vec![NO_WAY; n * n];
    for i in 0..n - 1 {
        parts[i * n + i + 1] = side(hole, i);
    }
    for (apart, i) in (2..n).flat_map(|apart| (0..n - apart).map(move |i| (apart, i))) {
        if hole.allows(i, i + apart, edges) {
            parts[i * n + i + apart] = best(hole, &parts, weigh_folds, [i, i + apart]);
        }
    }
    (parts[n - 1].area < f64::INFINITY).then(|| collected(&parts, n))
}

/// An edge of the loop, as a part that is filled.
fn side(hole: &Hole, i: usize) -> Part {
    Part { fold: 0, area: 0.0, apex: i, normal: hole.normals[i].unwrap_or([0.0; 3]) }
}

/// The best triangle along the chord from `i` to `k`.
fn best(hole: &Hole, parts: &[Part], weigh_folds: bool, [i, k]: [usize; 2]) -> Part {
    let n = hole.points.len();
    let closing = (weigh_folds && i == 0 && k == n - 1).then(|| side(hole, n - 1).normal);
    let mut best = NO_WAY;
    for j in i + 1..k {
        let [before, after] = [parts[i * n + j], parts[j * n + k]];
        let (mut fold, mut area) = (before.fold.max(after.fold), before.area + after.area);
        if (fold, area) >= (best.fold, best.area) {
            continue;
        }
        let [p, q, r] = [k, j, i].map(|i| hole.points[i]);
        let doubled = cross(minus(q, p), minus(r, p));
        let normal = vector::direction(doubled).unwrap_or([0.0; 3]);
        area += 0.5 * length(doubled);
        if weigh_folds {
            let beside = [before.normal, after.normal].into_iter().chain(closing);
            fold = beside.map(|other| fold_between(normal, other)).fold(fold, u32::max);
        }
        if (fold, area) < (best.fold, best.area) {
            best = Part { fold, area, apex: j, normal };
        }
    }
    best
}

/// How sharply two faces fold: most of all for a triangle without a normal, so that it is the last to be chosen, and not
/// at all towards a face of the mesh without one.
fn fold_between(normal: Vector, other: Vector) -> u32 {
    match (normal == [0.0; 3], other == [0.0; 3]) {
        (true, _) => (2.0 * STEPS) as u32,
        (false, true) => 0,
        (false, false) => libm::round(STEPS * (1.0 - dot(normal, other))) as u32,
    }
}

fn collected(parts: &[Part], n: usize) -> Vec<[usize; 3]> {
    let mut triangles = Vec::with_capacity(n - 2);
    let mut chords = vec![[0, n - 1]];
    while let Some([i, k]) = chords.pop() {
        if k > i + 1 {
            let j = parts[i * n + k].apex;
            triangles.push([k, j, i]);
            chords.extend([[j, k], [i, j]]);
        }
    }
    triangles
}

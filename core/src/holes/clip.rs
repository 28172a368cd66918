//! A loop filled by cutting off ears.
use super::edges::Edges;
use super::loops::Hole;
use crate::vector::{Vector, cross, direction, dot, minus, plus, times};
use alloc::collections::VecDeque;
use alloc::{vec, vec::Vec};

/// A point in the plane in which the loop is seen.
type Point = [f64; 2];

/// What is left of the loop.
struct Clipped<'a> {
    hole: &'a Hole,
    edges: &'a Edges,
    points: Vec<Point>,
    next: Vec<usize>,
    prev: Vec<usize>,
    /// By how much the loop turns left at each corner, in radians; minus infinity at those that cannot be cut off, since
    /// they are gone or the mesh has the edge that would come to be.
    turn: Vec<f64>,
    /// Whether the corner turns right, or straight on: only those can lie in an ear.
    is_reflex: Vec<bool>,
}

/// O(n^2): each corner is looked at once, and twice more for each that is cut off beside it.
pub(super) fn triangles(hole: &Hole, edges: &Edges) -> Option<Vec<[usize; 3]>> {
    let n = hole.points.len();
    let mut left = Clipped::of(hole, edges);
    let mut candidates: VecDeque<usize> = (0..n).collect();
    let mut triangles = Vec::with_capacity(n - 2);
    let mut at = 0;
    while triangles.len() < n - 3 {
        let i = match candidates.pop_front() {
            Some(i) if left.is_ear(i) => i,
            Some(_) => continue,
            None => left.sharpest()?,
        };
        let [before, after] = [left.prev[i], left.next[i]];
        triangles.push([after, i, before]);
        left.cut(i);
        candidates.extend([before, after]);
        at = before;
    }
    triangles.push([left.next[at], at, left.prev[at]]);
    Some(triangles)
}

impl<'a> Clipped<'a> {
    fn of(hole: &'a Hole, edges: &'a Edges) -> Self {
        let n = hole.points.len();
        let mut left = Self {
            hole,
            edges,
            points: seen(&hole.points),
            next: (0..n).map(|i| (i + 1) % n).collect(),
            prev: (0..n).map(|i| (i + n - 1) % n).collect(),
            turn: vec![0.0; n],
            is_reflex: vec![false; n],
        };
        (0..n).for_each(|i| left.look_at(i));
        left
    }

    /// Notes how the loop turns at a corner.
    fn look_at(&mut self, i: usize) {
        let [before, after] = [self.prev[i], self.next[i]];
        let [p, q, r] = [before, i, after].map(|i| self.points[i]);
        let [along, onward] = [[q[0] - p[0], q[1] - p[1]], [r[0] - q[0], r[1] - q[1]]];
        let turn = libm::atan2(
            along[0] * onward[1] - along[1] * onward[0],
            along[0] * onward[0] + along[1] * onward[1],
        );
        self.is_reflex[i] = turn <= 0.0;
        let is_allowed = self.hole.allows(before, after, self.edges);
        self.turn[i] = if is_allowed { turn } else { f64::NEG_INFINITY };
    }

    /// Whether a corner is there, turns left, may be cut off, and holds no other vertex. O(n).
    fn is_ear(&self, i: usize) -> bool {
        if self.turn[i] <= 0.0 {
            return false;
        }
        let [before, after] = [self.prev[i], self.next[i]];
        let corner = [before, i, after].map(|i| self.points[i]);
        let others = core::iter::successors(Some(self.next[after]), |&j| Some(self.next[j]));
        let mut others = others.take_while(|&j| j != before);
        !others.any(|j| self.is_reflex[j] && is_within(self.points[j], corner))
    }

    /// The corner that turns left most among those that may be cut off. O(n).
    fn sharpest(&self) -> Option<usize> {
        let i = (0..self.turn.len()).max_by(|&i, &j| self.turn[i].total_cmp(&self.turn[j]))?;
        (self.turn[i] > f64::NEG_INFINITY).then_some(i)
    }

    fn cut(&mut self, i: usize) {
        let [before, after] = [self.prev[i], self.next[i]];
        (self.next[before], self.prev[after]) = (after, before);
        self.turn[i] = f64::NEG_INFINITY;
        self.look_at(before);
        self.look_at(after);
    }
}

/// The points as they are seen from the direction in which the loop runs counter-clockwise around most area. All at one
/// place where there is no such direction.
fn seen(points: &[Vector]) -> Vec<Point> {
    let from = |p: &Vector| minus(*p, points[0]);
    let sides = points.iter().zip(points.iter().cycle().skip(1));
    let area = sides.map(|(p, q)| cross(from(p), from(q))).fold([0.0; 3], plus);
    let Some(up) = direction(area) else { return vec![[0.0; 2]; points.len()] };
    // The axis farthest from `up` makes the frame that is best to calculate with.
    let [x, y, z] = up.map(f64::abs);
    let axis = if x <= y && x <= z { [1.0, 0.0, 0.0] } else { [0.0, f64::from(y <= z), f64::from(y > z)] };
    let across = direction(minus(axis, times(dot(axis, up), up))).unwrap_or(axis);
    let onward = cross(up, across);
    points.iter().map(from).map(|p| [dot(p, across), dot(p, onward)]).collect()
}

/// Whether a point lies in a triangle that runs counter-clockwise, its border included but not its corners.
fn is_within(p: Point, corners: [Point; 3]) -> bool {
    let [a, b, c] = corners;
    let is_left = |a: Point, b: Point| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]) >= 0.0;
    !corners.contains(&p) && is_left(a, b) && is_left(b, c) && is_left(c, a)
}

//! One deformation in one structure.

use super::record::Point;
use crate::deform::{Load, farthest, sweep};
use crate::on_backend::Work;
use crate::timing::Clock;
use onering::spring::{Options, SpringError};
use onering::vector::{self, Vector};
use onering::{Handle, Incidence, Map};
use onering_io::Triangles;

/// The forces left over where the solver stops, relative to those applied.
pub(crate) const TOLERANCE: f64 = 1e-8;
/// So many vertices in a hundred are held, the farthest ones.
pub(crate) const HELD: f64 = 25.0;
/// Rings that the force is spread over.
pub(crate) const RINGS: usize = 3;
const MAX_ITERATIONS: usize = 100_000;
/// Displacements of two structures may differ by this share of the largest: the order of neighbours is another, and so
/// is the rounding on the way to the tolerance.
const SAME: f64 = 1e-4;

/// Presses the first vertex, at the top, downwards.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Experiment<'a> {
    pub(crate) mesh: &'a Triangles,
    pub(crate) clock: Clock,
}

/// What was measured, and the answers to compare.
#[derive(Clone, Debug)]
pub(crate) struct Compared {
    pub(crate) point: Point,
    /// The sum of all neighbours.
    sum: u64,
    displacements: Vec<Vector>,
}

impl Work for Experiment<'_> {
    type Output = Result<Compared, SpringError>;

    fn on<M: Incidence>(self, mesh: &M) -> Self::Output {
        let positions: Map<M::Vertex, _> = self.mesh.positions.clone().into();
        let fixed = farthest(&positions, M::Vertex::new(0), HELD);
        let options = Options { fixed, ..Options::default() };
        let force = [0.0, -1.0, 0.0];
        let load = Load { at: 0, force, rings: RINGS, tolerance: TOLERANCE, max_iterations: MAX_ITERATIONS };
        let mut sum = 0;
        let neighbours = self.clock.time(|| sum = sweep(mesh));
        let mut last = None;
        let total = self.clock.time(|| last = Some(load.rest(mesh, &positions, &options)));
        let (simulation, solved) = last.expect("the clock runs it at least once")?;
        let displacements = simulation.displacements().as_slice().to_vec();
        Ok(Compared { point: Point { neighbours, total, iterations: solved.iterations }, sum, displacements })
    }
}

impl Compared {
    /// In what it differs from the first structure, if in anything.
    pub(crate) fn mismatch(&self, first: &Self, name: &str, vertices: usize) -> Option<String> {
        let pairs = self.displacements.iter().zip(&first.displacements);
        let difference = pairs.map(|(&a, &b)| vector::length(vector::minus(a, b))).fold(0.0, f64::max);
        let largest = first.displacements.iter().map(|&d| vector::length(d)).fold(0.0, f64::max);
        let what = if self.sum != first.sum {
            "neighbours"
        } else if difference > SAME * largest {
            "displacements"
        } else {
            return None;
        };
        Some(format!("{name} has other {what} than the first structure at {vertices} vertices"))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{made::organ, on_backend};
    use std::time::Duration;

    #[test]
    fn other_answers_are_told() {
        let mesh = organ::of_size(50);
        let clock = Clock { budget: Duration::ZERO, gives_up: true };
        let of = |name| on_backend::run(name, &mesh, Experiment { mesh: &mesh, clock }).unwrap().unwrap();
        let (mut one, other) = (of("che-l2"), of("searched"));
        assert!(one.displacements[0][1] < 0.0 && one.point.iterations > 0);
        assert_eq!(other.mismatch(&one, "searched", 50), None);
        one.displacements[3][0] += 1.0;
        assert!(other.mismatch(&one, "searched", 50).unwrap().contains("displacements"));
        one.sum += 1;
        assert!(other.mismatch(&one, "searched", 50).unwrap().contains("neighbours"));
    }
}

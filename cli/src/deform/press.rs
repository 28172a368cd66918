//! The press itself, on whatever structure.

use super::fix;
use crate::args;
use crate::on_backend::Work;
use onering::spring::{Options, Simulation, Solved, SpringError, Stiffness};
use onering::vector::{self, Vector};
use onering::{Handle, Incidence, Map};
use onering_io::Triangles;
use std::fmt;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// What the mesh gives way by where no force is named, over the diagonal of its box.
const VISIBLE: f64 = 0.125;

/// A force spread over the rings around a vertex, and how to come to rest under it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Load {
    pub(crate) at: usize,
    pub(crate) force: Vector,
    pub(crate) rings: usize,
    pub(crate) tolerance: f64,
    pub(crate) max_iterations: usize,
}

/// What to do to a mesh.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Press<'a> {
    options: &'a args::Deform,
    mesh: &'a Triangles,
    load: Load,
    /// Whether the force is only a direction so far.
    is_free: bool,
}

/// What became of it.
#[derive(Clone, Debug)]
pub(crate) struct Pressed {
    pub(crate) force: Vector,
    /// How many vertices were held.
    pub(crate) held: usize,
    /// Of the solver, or steps in time.
    pub(crate) iterations: usize,
    /// Of the solver: forces left over, relative to those applied.
    pub(crate) residual: Option<f64>,
    pub(crate) displacements: Vec<Vector>,
    pub(crate) positions: Vec<[f32; 3]>,
    /// For asking for the first ring of every vertex.
    pub(crate) queries: Duration,
    /// From the mesh at rest to the displacements, which asks once for every ring too.
    pub(crate) total: Duration,
}

/// Why it could not be pressed.
#[derive(Clone, Debug)]
pub(crate) enum Error {
    Fix(String),
    Spring(SpringError),
    /// A vertex was moved beyond what positions can hold.
    TooFar(usize),
}

impl From<SpringError> for Error {
    fn from(error: SpringError) -> Self {
        Self::Spring(error)
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fix(problem) => f.write_str(problem),
            Self::Spring(error @ SpringError::ZeroLength { .. }) => {
                write!(f, "{error} (--weld makes them one)")
            }
            Self::Spring(error @ SpringError::Unsupported { .. }) => {
                write!(f, "{error} (--fix says which are held)")
            }
            Self::Spring(error @ SpringError::NotConverged { .. }) => {
                write!(f, "{error} (--max-iterations allows more, --tolerance more left over)")
            }
            Self::Spring(error) => error.fmt(f),
            Self::TooFar(v) => {
                write!(
                    f,
                    "vertex {v} would move farther than 32-bit coordinates can say: the force is too large"
                )
            }
        }
    }
}

/// Asks for the first ring of every vertex: the sum of all neighbours.
pub(crate) fn sweep<M: Incidence>(mesh: &M) -> u64 {
    mesh.vertices().flat_map(|v| mesh.neighbours(v)).fold(0, |sum, u| sum.wrapping_add(u.index() as u64))
}

impl Load {
    /// The mesh at rest under the load: every ring is asked for once, then the linear system is solved.
    pub(crate) fn rest<'m, M: Incidence>(
        &self,
        mesh: &'m M,
        positions: &Map<M::Vertex, [f32; 3]>,
        options: &Options<M::Vertex, M::HalfEdge>,
    ) -> Result<(Simulation<'m, M>, Solved), SpringError> {
        let mut simulation = Simulation::new(mesh, positions, options)?;
        simulation.push(M::Vertex::new(self.at), self.force, self.rings)?;
        let solved = simulation.solve(self.tolerance, self.max_iterations)?;
        Ok((simulation, solved))
    }
}

impl<'a> Press<'a> {
    /// `normal` is that of the surface at the vertex, where it has one.
    pub(crate) fn of(
        options: &'a args::Deform,
        mesh: &'a Triangles,
        at: usize,
        normal: Option<Vector>,
    ) -> Self {
        // At a vertex without a normal any direction is as good as another.
        let inwards = vector::times(-1.0, normal.unwrap_or([0.0, 0.0, 1.0]));
        let &args::Deform { rings, tolerance, max_iterations, .. } = options;
        let load = Load { at, force: options.force.unwrap_or(inwards), rings, tolerance, max_iterations };
        Self { options, mesh, load, is_free: options.force.is_none() }
    }

    /// All is in proportion to the force: from what a force of 1 does follows the one that can be seen.
    fn visible<M: Incidence>(
        &self,
        mesh: &M,
        positions: &Map<M::Vertex, [f32; 3]>,
        options: &Options<M::Vertex, M::HalfEdge>,
    ) -> Result<Vector, SpringError> {
        let roughly = Load { tolerance: 1e-3, ..self.load };
        let (simulation, _) = roughly.rest(mesh, positions, options)?;
        let largest = largest(simulation.displacements().as_slice());
        let scale = VISIBLE * diagonal(&self.mesh.positions) / largest;
        Ok(vector::times(if scale.is_finite() { scale } else { 1.0 }, self.load.force))
    }

    /// Moves the mesh in time. Half of what is stable is a step that follows all but the fastest waves.
    fn moved<'m, M: Incidence>(
        load: &Load,
        mesh: &'m M,
        positions: &Map<M::Vertex, [f32; 3]>,
        options: &Options<M::Vertex, M::HalfEdge>,
        steps: usize,
    ) -> Result<Simulation<'m, M>, SpringError> {
        let mut simulation = Simulation::new(mesh, positions, options)?;
        simulation.push(M::Vertex::new(load.at), load.force, load.rings)?;
        let limit = simulation.stable_step();
        let step = if limit.is_finite() { limit / 2.0 } else { 0.0 };
        (0..steps).for_each(|_| simulation.step(step));
        Ok(simulation)
    }
}

impl Work for Press<'_> {
    type Output = Result<Pressed, Error>;

    fn on<M: Incidence>(self, mesh: &M) -> Self::Output {
        let positions: Map<M::Vertex, _> = self.mesh.positions.clone().into();
        let at = M::Vertex::new(self.load.at);
        let fixed = fix::held(&self.options.fix, mesh, &positions, at).map_err(Error::Fix)?;
        let held = fixed.len();
        let &args::Deform { stiffness, damping, steps, .. } = self.options;
        let options = Options { stiffness: Stiffness::Same(stiffness), damping, fixed, ..Options::default() };
        let mut load = self.load;
        if self.is_free {
            load.force = self.visible(mesh, &positions, &options)?;
        }
        let (queries, _) = timed(|| black_box(sweep(mesh)));
        let (total, done) = timed(|| match steps {
            None => load.rest(mesh, &positions, &options).map(|(s, solved)| (s, Some(solved))),
            Some(steps) => Self::moved(&load, mesh, &positions, &options, steps).map(|s| (s, None)),
        });
        let (simulation, solved) = done?;
        let positions: Vec<_> = simulation.positions().as_slice().to_vec();
        if let Some(v) = positions.iter().position(|p| p.iter().any(|x| !x.is_finite())) {
            return Err(Error::TooFar(v));
        }
        Ok(Pressed {
            force: load.force,
            held,
            iterations: solved.map_or(steps.unwrap_or(0), |solved| solved.iterations),
            residual: solved.map(|solved| solved.residual),
            displacements: simulation.displacements().as_slice().to_vec(),
            positions,
            queries,
            total,
        })
    }
}

impl Pressed {
    /// How far each vertex has moved.
    pub(crate) fn lengths(&self) -> Vec<f32> {
        self.displacements.iter().map(|&d| vector::length(d) as f32).collect()
    }

    /// How far the vertex has moved that moved farthest.
    pub(crate) fn largest(&self) -> f64 {
        largest(&self.displacements)
    }
}

pub(crate) fn largest(displacements: &[Vector]) -> f64 {
    displacements.iter().map(|&d| vector::length(d)).fold(0.0, f64::max)
}

fn diagonal(positions: &[[f32; 3]]) -> f64 {
    let side = |axis: usize| {
        let widen = |[least, most]: [f64; 2], x: f64| [least.min(x), most.max(x)];
        let along = positions.iter().map(|p| f64::from(p[axis]));
        let [least, most] = along.fold([f64::INFINITY, f64::NEG_INFINITY], widen);
        most - least
    };
    vector::length(std::array::from_fn(side))
}

fn timed<T>(work: impl FnOnce() -> T) -> (Duration, T) {
    let start = Instant::now();
    let result = work();
    (start.elapsed(), result)
}

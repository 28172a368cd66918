//! Where the mesh comes to rest: the static solution, by conjugate gradients.
use super::{Simulation, SpringError};
use crate::{
    Handle, Incidence, Map,
    vector::{self, Vector},
};
use alloc::vec::Vec;

/// How the static solution was found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solved {
    /// Number of iterations, each with one product of the matrix with a vector.
    pub iterations: usize,
    /// The length of all forces left over, relative to that of the forces applied.
    pub residual: f64,
}

impl<M: Incidence> Simulation<'_, M> {
    /// Moves the vertices to where springs and loads are in balance, and stops them there.
    ///
    /// Conjugate gradients with the diagonal as preconditioner, for all three coordinates at once, from the
    /// displacements as they are (or from none, where that is nearer to the balance). What no springs
    /// join to a fixed vertex stays where it is, if nothing pushes it.
    ///
    /// # Arguments
    /// `tolerance` bounds the forces left over, relative to those applied: the loads, and the pull of fixed vertices that
    /// were [displaced](Self::displace). `max_iterations` bounds the work.
    ///
    /// # Returns
    /// The iterations made, and what is left over, calculated anew from the displacements.
    ///
    /// # Complexity
    /// O(edges) for each iteration. Their number grows with the square root of the ratio of the largest eigenvalue to the
    /// least, on a surface about as the square root of the number of vertices.
    ///
    /// # Errors
    /// [`SpringError::Unsupported`], before anything moves; [`SpringError::NotConverged`], with the vertices at
    /// the last iteration.
    ///
    /// # Source
    /// Biscaro et al. (2016), Eq. (9); Hestenes and Stiefel (1952).
    pub fn solve(&mut self, tolerance: f64, max_iterations: usize) -> Result<Solved, SpringError> {
        let supported = self.supported();
        let loose = |&v: &M::Vertex| !supported[v] && self.load[v] != [0.0; 3];
        if let Some(v) = self.mesh.vertices().find(loose) {
            return Err(SpringError::Unsupported { vertex: v.index() });
        }
        let moving = Map::from_fn(self.mesh.vertex_count(), |v| supported[v] && !self.is_fixed[v]);
        self.conjugate_gradients(&moving, tolerance, max_iterations)
    }

    /// Which vertices springs join to a fixed one.
    fn supported(&self) -> Map<M::Vertex, bool> {
        let mut supported = self.is_fixed.clone();
        let mut reached: Vec<M::Vertex> = self.mesh.vertices().filter(|&v| supported[v]).collect();
        while let Some(v) = reached.pop() {
            for (u, &k) in self.rows.neighbours(v).zip(self.rows.stiffness(v)) {
                if k > 0.0 && !supported[u] {
                    supported[u] = true;
                    reached.push(u);
                }
            }
        }
        supported
    }

    /// Solves for the vertices that are `moving`.
    fn conjugate_gradients(
        &mut self,
        moving: &Map<M::Vertex, bool>,
        tolerance: f64,
        max_iterations: usize,
    ) -> Result<Solved, SpringError> {
        let started = self.displacement.clone();
        self.set(moving, |_| [0.0; 3]);
        let applied = norm(&self.left_over(moving));
        if applied == 0.0 {
            self.stop(moving);
            return Ok(Solved { iterations: 0, residual: 0.0 });
        }
        self.set(moving, |v| started[v]);
        let mut left = self.left_over(moving);
        let is_nearer = norm(&left) <= applied;
        if !is_nearer {
            self.set(moving, |_| [0.0; 3]);
            left = self.left_over(moving);
        }
        let mut iterations = 0;
        loop {
            let residual = norm(&left) / applied;
            if residual <= tolerance {
                self.stop(moving);
                return Ok(Solved { iterations, residual });
            }
            if iterations >= max_iterations || !residual.is_finite() {
                return Err(SpringError::NotConverged { iterations, residual });
            }
            iterations += self.descend(moving, left, tolerance * applied, max_iterations - iterations);
            // What the recurrence says is left over drifts from the truth by rounding.
            left = self.left_over(moving);
        }
    }

    /// One run of conjugate gradients until its recurrence says that no more than `enough` is left over. Gives the
    /// iterations, at least one.
    fn descend(
        &mut self,
        moving: &Map<M::Vertex, bool>,
        mut left: Map<M::Vertex, Vector>,
        enough: f64,
        max_iterations: usize,
    ) -> usize {
        let diagonal: Map<M::Vertex, f64> = self
            .mesh
            .vertices()
            .map(|v| if moving[v] { 1.0 / self.rows.stiffness(v).iter().sum::<f64>() } else { 0.0 })
            .collect();
        let preconditioned = |left: &Map<M::Vertex, Vector>, v| vector::times(diagonal[v], left[v]);
        let mut direction: Map<_, _> = self.mesh.vertices().map(|v| preconditioned(&left, v)).collect();
        let mut product: Map<_, _> = Map::filled(self.mesh.vertex_count(), [0.0; 3]);
        let mut size: f64 =
            self.mesh.vertices().map(|v| vector::dot(left[v], preconditioned(&left, v))).sum();
        for iteration in 1..=max_iterations {
            let mut curvature = 0.0;
            for v in self.mesh.vertices().filter(|&v| moving[v]) {
                let force = self.rows.force(v, self.rows.neighbours(v), direction.as_slice());
                product[v] = vector::times(-1.0, force);
                curvature += vector::dot(direction[v], product[v]);
            }
            let along = size / curvature;
            let (mut next, mut rest) = (0.0, 0.0);
            for v in self.mesh.vertices().filter(|&v| moving[v]) {
                self.displacement[v] = vector::plus(self.displacement[v], vector::times(along, direction[v]));
                left[v] = vector::minus(left[v], vector::times(along, product[v]));
                next += vector::dot(left[v], preconditioned(&left, v));
                rest += vector::dot(left[v], left[v]);
            }
            // What is no number any more goes on nowhere.
            let goes_on = libm::sqrt(rest) > enough;
            if !goes_on {
                return iteration;
            }
            for v in self.mesh.vertices().filter(|&v| moving[v]) {
                direction[v] =
                    vector::plus(preconditioned(&left, v), vector::times(next / size, direction[v]));
            }
            size = next;
        }
        max_iterations
    }

    /// Springs and loads on the vertices that are `moving`, zero on the others.
    fn left_over(&self, moving: &Map<M::Vertex, bool>) -> Map<M::Vertex, Vector> {
        let force = |v| vector::plus(self.load[v], self.spring_force(v));
        self.mesh.vertices().map(|v| if moving[v] { force(v) } else { [0.0; 3] }).collect()
    }

    fn set(&mut self, moving: &Map<M::Vertex, bool>, displacement: impl Fn(M::Vertex) -> Vector) {
        for (v, x) in &mut self.displacement {
            if moving[v] {
                *x = displacement(v);
            }
        }
    }

    fn stop(&mut self, moving: &Map<M::Vertex, bool>) {
        for (v, velocity) in &mut self.velocity {
            if moving[v] {
                *velocity = [0.0; 3];
            }
        }
    }
}

fn norm<V: Handle>(forces: &Map<V, Vector>) -> f64 {
    libm::sqrt(forces.as_slice().iter().map(|&f| vector::dot(f, f)).sum())
}

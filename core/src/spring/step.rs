//! Symplectic Euler steps in time.
use super::Simulation;
use crate::{
    Incidence,
    vector::{self, Vector},
};

impl<M: Incidence> Simulation<'_, M> {
    /// The step that [`step`](Self::step) has to stay below: `2 / ω`, with the bound of Gershgorin for the highest
    /// frequency, `ω² = 2 max Σ k_ij / m` over the free vertices. Infinite where no springs are. O(edges).
    ///
    /// Damping does not change it: see [`step`](Self::step).
    pub fn stable_step(&self) -> f64 {
        let free = self.mesh.vertices().filter(|&v| !self.is_fixed[v]);
        let sums = free.map(|v| self.rows.stiffness(v).iter().sum::<f64>());
        2.0 / libm::sqrt(2.0 * sums.fold(0.0, f64::max) / self.mass)
    }

    /// Moves all vertices on by `dt`.
    ///
    /// Symplectic Euler: first the velocities, by the forces where the vertices are, then the vertices by the new
    /// velocities. Damping acts against the mean of the old and the new velocity. With springs `K`, displacements `x` and
    /// velocities `v`, the quantity `m v v / 2 + x K x / 2 - dt v K x / 2` is then constant without damping, and falls
    /// in each step with it. It is never negative as long as `dt` is below `2 / ω` for the highest frequency `ω`, so
    /// whatever the damping this is the limit: below [`stable_step`](Self::stable_step) nothing grows without bound, but
    /// where a load meets no resistance.
    ///
    /// # Arguments
    /// `dt` is at least 0. From [`stable_step`](Self::stable_step) on, displacements may grow beyond all bounds.
    ///
    /// # Complexity
    /// O(edges), without allocation.
    ///
    /// # Panics
    /// Where `dt` is negative, infinite or no number.
    ///
    /// # Source
    /// Biscaro et al. (2016), Eq. (9), at each instant of time.
    pub fn step(&mut self, dt: f64) {
        self.accelerate(dt, |sim, v| sim.spring_force(v));
    }

    /// The same step, to the last bit, with every first ring walked in the mesh again, as the programs do that Biscaro
    /// et al. (2016) compare. [`step`](Self::step) is faster.
    ///
    /// # Panics
    /// As [`step`](Self::step).
    pub fn step_walking(&mut self, dt: f64) {
        self.accelerate(dt, |sim, v| sim.rows.force(v, sim.mesh.neighbours(v), sim.displacement.as_slice()));
    }

    #[inline(always)]
    fn accelerate(&mut self, dt: f64, spring_force: impl Fn(&Self, M::Vertex) -> Vector) {
        assert!(dt >= 0.0 && dt.is_finite(), "a step of {dt} in time");
        let half = dt * self.damping / self.mass / 2.0;
        let (kept, gained) = ((1.0 - half) / (1.0 + half), dt / self.mass / (1.0 + half));
        for v in self.mesh.vertices() {
            if !self.is_fixed[v] {
                let force = vector::plus(self.load[v], spring_force(self, v));
                self.velocity[v] =
                    vector::plus(vector::times(kept, self.velocity[v]), vector::times(gained, force));
            }
        }
        for (x, &v) in self.displacement.as_mut_slice().iter_mut().zip(self.velocity.as_slice()) {
            *x = vector::plus(*x, vector::times(dt, v));
        }
    }
}

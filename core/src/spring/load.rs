//! Forces from outside, spread over rings.
use super::{Simulation, SpringError};
use crate::{
    Incidence,
    k_ring::KRing,
    vector::{self, Vector},
};

impl<M: Incidence> Simulation<'_, M> {
    /// Lays a force on `v` and the vertices around it, added to what they bear already.
    ///
    /// The share of a vertex falls in equal parts from ring to ring, to nothing just beyond the last: at distance `d` of
    /// `rings` it is in proportion to `rings + 1 - d`. All shares together are `force`, at a boundary too; with 0 rings
    /// `v` bears it alone. What falls on a fixed vertex, its support takes.
    ///
    /// # Complexity
    /// O(vertices), for the search; it stays until [`release`](Self::release).
    ///
    /// # Errors
    /// [`SpringError::NoSuchVertex`], and [`SpringError::Vector`] where the force is no number to calculate with.
    pub fn push(&mut self, v: M::Vertex, force: Vector, rings: usize) -> Result<(), SpringError> {
        self.checked(v, force)?;
        let mut around = KRing::new();
        around.search(self.mesh, v, rings);
        let weight = |d: usize| rings as f64 + 1.0 - d as f64;
        let levels = 0..=around.levels();
        let sum: f64 = levels.clone().map(|d| weight(d) * around.level(d).len() as f64).sum();
        for d in levels {
            let share = vector::times(weight(d) / sum, force);
            for &u in around.level(d) {
                self.load[u] = vector::plus(self.load[u], share);
            }
        }
        Ok(())
    }

    /// Takes all forces off. O(vertices).
    pub fn release(&mut self) {
        self.load.as_mut_slice().fill([0.0; 3]);
    }
}

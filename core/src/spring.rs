//! Soft tissue as masses and springs: a spring along every edge, as Biscaro et al. (2016, section 5.2) deform organs.
//!
//! Hooke's law for one spring is their Eq. (8), `f = -k δ`; on a vertex act the springs of its first ring, Eq. (9):
//! `f_i = Σ k_ij (δ_j - δ_i)` over the neighbours `j`, where `δ` are displacements from the positions at rest. The law
//! is linear in the displacements and the same for each coordinate: a mesh at rest has no forces, whatever its shape,
//! and turning it as a whole does cost energy. There is one spring for each edge, whatever number of faces lies
//! along it; a vertex without faces has none.
//!
//! [`Simulation`] moves the vertices in time ([`step`](Simulation::step)) or finds where they come to rest
//! ([`solve`](Simulation::solve)).
mod error;
mod load;
mod options;
mod rows;
mod simulation;
mod solve;
mod step;

pub use error::SpringError;
pub use options::{Options, Stiffness};
pub use simulation::Simulation;
pub use solve::Solved;

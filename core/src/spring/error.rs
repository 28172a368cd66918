//! [`SpringError`]: what cannot be simulated.
use crate::NotFinite;
use core::{error::Error, fmt};

/// Why a mesh, an option or a load cannot be simulated. Vertices are named by their index.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum SpringError {
    /// A position at rest is infinite or no number.
    Position(NotFinite),
    /// Two neighbours have the same position at rest, so the edge between them has length zero.
    ZeroLength {
        /// The ends of the edge, the lesser first.
        vertices: [usize; 2],
    },
    /// A spring is infinitely stiff, or its stiffness is negative or no number.
    Stiffness {
        /// The ends of the edge, the lesser first.
        vertices: [usize; 2],
        /// Its stiffness.
        value: f64,
    },
    /// The mass of a vertex is not a positive number.
    Mass {
        /// What was asked for.
        value: f64,
    },
    /// The damping is negative, infinite or no number.
    Damping {
        /// What was asked for.
        value: f64,
    },
    /// A vertex was named that does not exist.
    NoSuchVertex {
        /// The vertex.
        vertex: usize,
        /// Number of vertices.
        vertex_count: usize,
    },
    /// A force, a displacement or a velocity is infinite or no number.
    Vector {
        /// The vertex that it was meant for.
        vertex: usize,
    },
    /// A force acts where no springs lead to a fixed vertex, so nothing comes to rest there.
    Unsupported {
        /// The first vertex under such a force.
        vertex: usize,
    },
    /// The static solution was not found within the iterations.
    NotConverged {
        /// Iterations that were made.
        iterations: usize,
        /// The forces left over, relative to those applied; no number where the arithmetic overflowed.
        residual: f64,
    },
}

impl fmt::Display for SpringError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Position(error) => error.fmt(f),
            Self::ZeroLength { vertices: [a, b] } => {
                write!(f, "the edge {a}-{b} has length zero: both vertices have the same position")
            }
            Self::Stiffness { vertices: [a, b], value } => {
                write!(
                    f,
                    "the spring along the edge {a}-{b} has stiffness {value}, which is not finite and at least 0"
                )
            }
            Self::Mass { value } => write!(f, "the mass of a vertex is {value}, which is no positive number"),
            Self::Damping { value } => {
                write!(f, "the damping is {value}, which is not finite and at least 0")
            }
            Self::NoSuchVertex { vertex, vertex_count } => {
                write!(f, "there is no vertex {vertex}: there are {vertex_count} vertices")
            }
            Self::Vector { vertex } => {
                write!(f, "the force, displacement or velocity for vertex {vertex} is infinite or no number")
            }
            Self::Unsupported { vertex } => {
                write!(f, "a force acts on vertex {vertex}, and no springs lead from there to a fixed vertex")
            }
            Self::NotConverged { iterations, residual } => {
                write!(
                    f,
                    "not at rest after {iterations} iterations: {residual:e} of the forces are left over"
                )
            }
        }
    }
}

impl Error for SpringError {}

impl From<NotFinite> for SpringError {
    fn from(error: NotFinite) -> Self {
        Self::Position(error)
    }
}

//! Why a list cannot be repaired.

use crate::BuildError;
use core::fmt;

/// Why [`repair`](super::repair) did not start; no list of faces is beyond repair for what it holds.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RepairError {
    /// More vertices (copies included) or half-edges than handles can name, or no memory.
    Limit(BuildError),
    /// Welding needs a position for every vertex, and no more.
    PositionCount {
        /// How many vertices there are.
        vertices: usize,
        /// How many positions were given.
        positions: usize,
    },
}

impl From<BuildError> for RepairError {
    fn from(error: BuildError) -> Self {
        Self::Limit(error)
    }
}

impl fmt::Display for RepairError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Limit(error) => error.fmt(f),
            Self::PositionCount { vertices, positions } => {
                write!(f, "{positions} positions to weld for {vertices} vertices")
            }
        }
    }
}

impl core::error::Error for RepairError {}

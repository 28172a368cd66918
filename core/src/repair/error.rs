//! Why a list cannot be repaired.

use core::fmt;

/// Why [`repair`](super::repair) did not start; no list of faces is beyond repair for what it holds.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum RepairError {
    /// More faces than there are `u32` numbers for half-edges.
    TooManyFaces {
        /// How many there are.
        faces: usize,
        /// How many there may be.
        limit: usize,
    },
    /// More vertices, copies included, than there are `u32` numbers below the mark for "none".
    TooManyVertices {
        /// How many there would be.
        vertices: usize,
        /// How many there may be.
        limit: usize,
    },
    /// Welding needs a position for every vertex, and no more.
    PositionCount {
        /// How many vertices there are.
        vertices: usize,
        /// How many positions were given.
        positions: usize,
    },
    /// The maps of this many vertices do not fit in memory.
    OutOfMemory {
        /// How many vertices there are.
        vertices: usize,
    },
}

impl fmt::Display for RepairError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooManyFaces { faces, limit } => {
                write!(f, "{faces} faces, and no more than {limit} can be held")
            }
            Self::TooManyVertices { vertices, limit } => {
                write!(f, "{vertices} vertices, and no more than {limit} can be held")
            }
            Self::PositionCount { vertices, positions } => {
                write!(f, "{positions} positions to weld for {vertices} vertices")
            }
            Self::OutOfMemory { vertices } => write!(f, "no memory for the maps of {vertices} vertices"),
        }
    }
}

impl core::error::Error for RepairError {}

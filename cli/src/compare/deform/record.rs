//! What was found, in the shape of its JSON.

use crate::machine::Machine;
use crate::timing::Timing;
use serde::Serialize;

#[derive(Debug, Serialize)]
pub(crate) struct Run {
    pub(crate) version: &'static str,
    pub(crate) machine: Machine,
    pub(crate) budget_ms: u64,
    pub(crate) quadratic_up_to_triangles: usize,
    pub(crate) notes: &'static [&'static str],
    pub(crate) sizes: Vec<Size>,
    pub(crate) lines: Vec<Line>,
    /// Answers that differ. Empty, or a structure is wrong.
    pub(crate) mismatches: Vec<String>,
}

#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Size {
    pub(crate) vertices: usize,
    pub(crate) triangles: usize,
}

/// One structure.
#[derive(Debug, Serialize)]
pub(crate) struct Line {
    pub(crate) name: &'static str,
    /// One for each size; `null` where it was left out.
    pub(crate) points: Vec<Option<Point>>,
}

#[derive(Clone, Copy, Debug, Serialize)]
pub(crate) struct Point {
    /// For asking for the first ring of every vertex.
    pub(crate) neighbours: Timing,
    /// For the whole deformation.
    pub(crate) total: Timing,
    pub(crate) iterations: usize,
}

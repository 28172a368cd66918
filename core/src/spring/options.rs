//! [`Options`] of a simulation.
use crate::Map;
use alloc::vec::Vec;

/// How stiff the springs are: the `k` of Eqs. (8) and (9), force over displacement.
#[derive(Clone, Debug, PartialEq)]
pub enum Stiffness<H> {
    /// The same for every edge, as long or short as it is.
    Same(f64),
    /// This over the length of the edge at rest: rods of one material and thickness, so that a finer mesh of the
    /// same surface is not a stiffer one along a line.
    OverLength(f64),
    /// Each edge its own: the value at the least half-edge along it ([`edges::each`](crate::edges::each)). What stands
    /// at the others is not looked at.
    Each(Map<H, f64>),
}

/// What a simulation is made with, beside the mesh and the positions: `V` names vertices, `H` half-edges.
///
/// ```
/// use onering_core::{HalfEdgeId, Handle, VertexId, spring::Options};
/// let held = Options::<_, HalfEdgeId> { fixed: vec![VertexId::new(0)], ..Options::default() };
/// assert_eq!((held.mass, held.damping), (1.0, 0.0));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Options<V, H> {
    /// The springs; all of stiffness 1 by default.
    pub stiffness: Stiffness<H>,
    /// The mass of each vertex, more than 0; 1 by default.
    pub mass: f64,
    /// Force of the medium against a vertex, over its velocity; 0 by default.
    pub damping: f64,
    /// Vertices that stay where they are, whatever force acts on them. May name one several times; none by default.
    pub fixed: Vec<V>,
}

impl<V, H> Default for Options<V, H> {
    fn default() -> Self {
        Self { stiffness: Stiffness::Same(1.0), mass: 1.0, damping: 0.0, fixed: Vec::new() }
    }
}

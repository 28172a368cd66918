//! parry3d: the half-edge topology of its triangle mesh alone. The mesh itself, with its tree of boxes, is there before;
//! the topology has no iterators, so that its links are walked by hand.

use super::{Structure, walk::Walk};
use crate::mesh::Mesh;
use parry3d::math::Vector;
use parry3d::shape::{TriMesh, TriMeshFlags, TriMeshTopology};

/// Whoever is built has a topology, but it can only be asked for as an option.
pub(super) struct Topology(TriMesh);

pub(super) struct Input(Result<TriMesh, String>);

impl From<&Mesh> for Input {
    fn from(mesh: &Mesh) -> Self {
        let positions = mesh.positions.iter().map(|&[x, y, z]| Vector::new(x, y, z)).collect();
        Self(TriMesh::new(positions, mesh.faces.clone()).map_err(|error| error.to_string()))
    }
}

impl Structure for Topology {
    type Input<'a> = Input;

    fn build(input: Input) -> Result<Self, String> {
        let mut mesh = input.0?;
        mesh.set_flags(TriMeshFlags::HALF_EDGE_TOPOLOGY).map_err(|error| error.to_string())?;
        mesh.topology().ok_or("there is no topology")?;
        Ok(Self(mesh))
    }
}

impl Walk for Topology {
    type Vertex = u32;

    fn vertices(&self) -> impl Iterator<Item = u32> {
        0..self.0.vertices().len() as u32
    }

    #[inline(always)]
    fn index(v: u32) -> u32 {
        v
    }

    #[inline(always)]
    fn ring(&self, v: u32, visit: impl FnMut(u32)) {
        let topology = self.0.topology().expect("found by `build`");
        Ring::of(topology, v).for_each(visit);
    }
}

/// The neighbours of a vertex: counter-clockwise to where it began, or to the boundary and then the other way.
struct Ring<'a> {
    topology: &'a TriMeshTopology,
    start: u32,
    step: Step,
}

#[derive(Clone, Copy)]
enum Step {
    /// The target of this half-edge comes next.
    CounterClockwise(u32),
    /// The origin of this half-edge, the last one in this direction.
    Boundary(u32),
    /// The turn goes on clockwise from this half-edge, whose target has been.
    Clockwise(u32),
    Done,
}

const NONE: u32 = u32::MAX;

impl<'a> Ring<'a> {
    fn of(topology: &'a TriMeshTopology, v: u32) -> Self {
        let start = topology.vertices[v as usize].half_edge;
        let step = if start == NONE { Step::Done } else { Step::CounterClockwise(start) };
        Self { topology, start, step }
    }

    #[inline(always)]
    fn next_of(&self, h: u32) -> u32 {
        self.topology.half_edges[h as usize].next
    }

    #[inline(always)]
    fn twin(&self, h: u32) -> u32 {
        self.topology.half_edges[h as usize].twin
    }

    #[inline(always)]
    fn origin(&self, h: u32) -> u32 {
        self.topology.half_edges[h as usize].vertex
    }
}

impl Iterator for Ring<'_> {
    type Item = u32;

    #[inline]
    fn next(&mut self) -> Option<u32> {
        match self.step {
            Step::CounterClockwise(h) => {
                let next = self.next_of(h);
                let prev = self.next_of(next);
                self.step = match self.twin(prev) {
                    NONE => Step::Boundary(prev),
                    twin if twin == self.start => Step::Done,
                    twin => Step::CounterClockwise(twin),
                };
                Some(self.origin(next))
            }
            Step::Boundary(prev) => {
                self.step = Step::Clockwise(self.start);
                Some(self.origin(prev))
            }
            Step::Clockwise(h) => {
                let twin = self.twin(h);
                if twin == NONE {
                    self.step = Step::Done;
                    return None;
                }
                let next = self.next_of(twin);
                self.step = Step::Clockwise(next);
                Some(self.origin(self.next_of(next)))
            }
            Step::Done => None,
        }
    }
}

//! Primitives to triangles.

use std::collections::HashMap;

use ::gltf::json::mesh::{self, Primitive, Semantic};
use ::gltf::json::validation::Checked;

use super::accessor::Source;
use super::origin::Origin;
use crate::memory::{push, reserve};
use crate::triangles::skip;
use crate::{Error, Place, Reason, Skipped, Triangles};

const DRACO: &str = "KHR_draco_mesh_compression";

/// The ways in which corners make triangles.
#[derive(Clone, Copy)]
enum Mode {
    List,
    Strip,
    Fan,
}

/// A primitive that will be read: its accessors are sound.
struct Plan {
    mode: Mode,
    positions: usize,
    indices: Option<usize>,
    place: Place,
}

/// The mesh so far. All primitives are counted before the first one is decoded: what a document asks for in all
/// is known while it has cost nothing yet.
pub(super) struct Assembly<'a> {
    source: Source<'a>,
    plans: Vec<Plan>,
    vertices: u64,
    faces: u64,
    /// Where the positions of an accessor were put first.
    decoded: HashMap<usize, usize>,
    out: Triangles,
}

impl<'a> Assembly<'a> {
    pub(super) fn new(source: Source<'a>) -> Self {
        let (plans, decoded, out) = (Vec::new(), HashMap::new(), Triangles::default());
        Self { source, plans, vertices: 0, faces: 0, decoded, out }
    }

    /// Counts the vertices and triangles of a primitive, or notes why it has none.
    pub(super) fn plan(&mut self, primitive: &Primitive, place: Place) -> Result<(), Error> {
        let mode = match Mode::of(primitive.mode) {
            Ok(mode) => mode,
            Err(what) => {
                skip(&mut self.out.notes, what, 1, place);
                return Ok(());
            }
        };
        let Some(positions) = primitive.attributes.get(&Checked::Valid(Semantic::Positions)) else {
            skip(&mut self.out.notes, Skipped::NoPositions, 1, place);
            return Ok(());
        };
        let positions = positions.value();
        self.check_draco(primitive, positions, place)?;
        let vertices = self.source.count(positions, place)?;
        self.vertices = self.sum(self.vertices, vertices, place)?;
        self.source.check_positions(positions, place)?;
        let indices = primitive.indices.map(|indices| indices.value());
        let corners = match indices {
            Some(indices) => self.source.count(indices, place)?,
            None => vertices,
        };
        self.faces = self.sum(self.faces, mode.face_count(corners), place)?;
        if let Some(indices) = indices {
            self.source.check_indices(indices, place)?;
        }
        let loose = mode.loose_corners(corners);
        if loose > 0 {
            skip(&mut self.out.notes, Skipped::LooseCorners, loose as usize, place);
        }
        push(&mut self.plans, Plan { mode, positions, indices, place })
    }

    /// Decodes all that was planned.
    pub(super) fn finish(mut self) -> Result<Triangles, Error> {
        self.source.check_proportion(self.vertices.saturating_add(self.faces))?;
        reserve(&mut self.out.positions, self.vertices as usize)?;
        reserve(&mut self.out.faces, self.faces as usize)?;
        let plans = std::mem::take(&mut self.plans);
        plans.iter().try_for_each(|plan| self.add(plan))?;
        if !self.out.faces.is_empty() {
            self.out.polygon_sizes.insert(3, self.out.faces.len());
        }
        self.out.gltf = Some(Origin { primitives: plans.len(), buffers: self.source.buffer_kinds() });
        Ok(self.out)
    }

    /// A primitive may hold its data twice, plain and compressed. Without the plain data it would be read
    /// as vertices that are all zero.
    fn check_draco(&self, primitive: &Primitive, position: usize, place: Place) -> Result<(), Error> {
        let extensions = primitive.extensions.as_ref();
        let has_draco = extensions.is_some_and(|extensions| extensions.others.contains_key(DRACO));
        if !has_draco || self.source.has_data(position, place)? {
            return Ok(());
        }
        Err(Error::Unsupported { format: self.source.format, path: None, place, feature: DRACO.to_owned() })
    }

    fn sum(&self, count: u64, more: u64, place: Place) -> Result<u64, Error> {
        let sum = count.checked_add(more).filter(|sum| *sum <= u64::from(u32::MAX));
        sum.ok_or_else(|| self.source.malformed(place, Reason::TooMany))
    }

    fn add(&mut self, plan: &Plan) -> Result<(), Error> {
        let base = self.out.positions.len();
        self.add_positions(plan)?;
        let count = self.out.positions.len() - base;
        let Some(indices) = plan.indices else {
            self.add_faces(plan.mode, count, |i| (base + i) as u32);
            return Ok(());
        };
        let corners = self.source.indices(indices, plan.place)?;
        self.check_corners(&corners, count, plan.place)?;
        self.add_faces(plan.mode, corners.len(), |i| base as u32 + corners[i]);
        Ok(())
    }

    /// Appends the positions of a primitive; those that other primitives have as well are decoded once.
    fn add_positions(&mut self, plan: &Plan) -> Result<(), Error> {
        let positions = &mut self.out.positions;
        match self.decoded.get(&plan.positions) {
            Some(&first) => {
                let count = self.source.count(plan.positions, plan.place)? as usize;
                positions.extend_from_within(first..first + count);
                Ok(())
            }
            None => {
                self.decoded.insert(plan.positions, positions.len());
                self.source.positions(plan.positions, plan.place, positions)
            }
        }
    }

    fn check_corners(&self, corners: &[u32], count: usize, place: Place) -> Result<(), Error> {
        match corners.iter().find(|corner| **corner as usize >= count) {
            None => Ok(()),
            Some(corner) => {
                let reason = Reason::IndexOutOfRange { index: corner.to_string(), vertices: count };
                Err(self.source.malformed(place, reason))
            }
        }
    }

    /// Appends the triangles of `count` corners, the i-th of which is `corner(i)`.
    fn add_faces(&mut self, mode: Mode, count: usize, corner: impl Fn(usize) -> u32) {
        let faces = mode.face_count(count as u64) as usize;
        self.out.faces.extend((0..faces).map(|i| mode.corners(i).map(&corner)));
    }
}

impl Mode {
    /// How corners make triangles, or why there are none.
    fn of(mode: Checked<mesh::Mode>) -> Result<Self, Skipped> {
        match mode {
            Checked::Valid(mesh::Mode::Triangles) => Ok(Self::List),
            Checked::Valid(mesh::Mode::TriangleStrip) => Ok(Self::Strip),
            Checked::Valid(mesh::Mode::TriangleFan) => Ok(Self::Fan),
            Checked::Valid(other) => Err(Skipped::PrimitiveMode(other.as_gl_enum())),
            Checked::Invalid => Err(Skipped::UnknownModes),
        }
    }

    fn face_count(self, corners: u64) -> u64 {
        match self {
            Self::List => corners / 3,
            Self::Strip | Self::Fan => corners.saturating_sub(2),
        }
    }

    fn loose_corners(self, corners: u64) -> u64 {
        match self {
            Self::List => corners % 3,
            Self::Strip | Self::Fan if corners < 3 => corners,
            Self::Strip | Self::Fan => 0,
        }
    }

    /// The corners of triangle `i`, by the formulas of glTF 2.0, section 3.7.2.1.
    fn corners(self, i: usize) -> [usize; 3] {
        match self {
            Self::List => [3 * i, 3 * i + 1, 3 * i + 2],
            Self::Strip => [i, i + 1 + i % 2, i + 2 - i % 2],
            Self::Fan => [i + 1, i + 2, 0],
        }
    }
}

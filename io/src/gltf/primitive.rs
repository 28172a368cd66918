//! Primitives to triangles.

use ::gltf::json::mesh::{self, Primitive, Semantic};
use ::gltf::json::validation::Checked;

use super::accessor::Source;
use super::origin::Origin;
use crate::memory::reserve;
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

/// The mesh so far.
pub(super) struct Assembly<'a> {
    source: Source<'a>,
    /// How many primitives were read.
    primitives: usize,
    out: Triangles,
}

impl<'a> Assembly<'a> {
    pub(super) fn new(source: Source<'a>) -> Self {
        Self { source, primitives: 0, out: Triangles::default() }
    }

    /// Appends the vertices and triangles of a primitive, or a note on why it has none.
    pub(super) fn add(&mut self, primitive: &Primitive, place: Place) -> Result<(), Error> {
        let mode = match Mode::of(primitive.mode) {
            Ok(mode) => mode,
            Err(what) => {
                skip(&mut self.out.notes, what, 1, place);
                return Ok(());
            }
        };
        let Some(position) = primitive.attributes.get(&Checked::Valid(Semantic::Positions)) else {
            skip(&mut self.out.notes, Skipped::NoPositions, 1, place);
            return Ok(());
        };
        let position = position.value();
        self.primitives += 1;
        self.check_draco(primitive, position, place)?;
        let base = self.out.positions.len();
        self.add_positions(position, place)?;
        let count = self.out.positions.len() - base;
        match primitive.indices {
            Some(indices) => {
                let corners = self.source.indices(indices.value(), place)?;
                self.check_corners(&corners, count, place)?;
                self.add_faces(mode, corners.len(), |i| base as u32 + corners[i], place)
            }
            None => self.add_faces(mode, count, |i| (base + i) as u32, place),
        }
    }

    pub(super) fn finish(mut self) -> Triangles {
        if !self.out.faces.is_empty() {
            self.out.polygon_sizes.insert(3, self.out.faces.len());
        }
        let buffers = self.source.buffer_kinds();
        self.out.gltf = Some(Origin { primitives: self.primitives, buffers });
        self.out
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

    fn add_positions(&mut self, accessor: usize, place: Place) -> Result<(), Error> {
        let more = self.source.count(accessor, place)?;
        self.check_size(self.out.positions.len() as u64, more, place)?;
        self.source.positions(accessor, place, &mut self.out.positions)?;
        self.source.check_proportion(self.element_count(), place)
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
    fn add_faces(
        &mut self,
        mode: Mode,
        count: usize,
        corner: impl Fn(usize) -> u32,
        place: Place,
    ) -> Result<(), Error> {
        let faces = mode.face_count(count);
        self.check_size(self.out.faces.len() as u64, faces as u64, place)?;
        self.source.check_proportion(self.element_count() + faces as u64, place)?;
        reserve(&mut self.out.faces, faces)?;
        self.out.faces.extend((0..faces).map(|i| mode.corners(i).map(&corner)));
        let loose = mode.loose_corners(count);
        if loose > 0 {
            skip(&mut self.out.notes, Skipped::LooseCorners, loose, place);
        }
        Ok(())
    }

    fn element_count(&self) -> u64 {
        (self.out.positions.len() + self.out.faces.len()) as u64
    }

    fn check_size(&self, count: u64, more: u64, place: Place) -> Result<(), Error> {
        if count.saturating_add(more) <= u64::from(u32::MAX) {
            return Ok(());
        }
        Err(self.source.malformed(place, Reason::TooMany))
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

    fn face_count(self, corners: usize) -> usize {
        match self {
            Self::List => corners / 3,
            Self::Strip | Self::Fan => corners.saturating_sub(2),
        }
    }

    fn loose_corners(self, corners: usize) -> usize {
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

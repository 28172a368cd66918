//! What X3D and VRML have in common: their nodes, whichever way they are written down, and how they become a mesh.
//!
//! A reader tells a [`Scene`] of geometry and coordinates as it meets them, and where their numbers lie in the file.
//! The numbers are read at the end, when it is known which coordinates each geometry names.

mod assembly;
mod faces;
mod field;
mod node;

use std::borrow::Cow;
use std::collections::HashMap;

pub(crate) use self::field::Field;
pub(crate) use self::node::{Kind, Node};
use crate::error::quote;
use crate::memory::push;
use crate::triangles::skip;
use crate::words::Words;
use crate::{Error, Format, Note, Place, Reason, Skipped, Triangles};

/// Nodes may lie in one another up to this depth. Real scenes stay below a hundred; each level costs memory.
const MAX_DEPTH: usize = 10_000;

/// A name that is defined by `DEF` and referred to by `USE`.
pub(crate) type Name<'a> = Cow<'a, [u8]>;

/// The nodes of a file that make a mesh, in the file's order.
pub(crate) struct Scene<'a> {
    pub(crate) bytes: &'a [u8],
    /// Those of the file; fewer where it is packed.
    input_bytes: u64,
    format: Format,
    /// Whether `#` begins a comment among numbers.
    has_comments: bool,
    geometries: Vec<Geometry<'a>>,
    /// The points of each Coordinate node.
    points: Vec<Field>,
    names: HashMap<Name<'a>, usize>,
    notes: Vec<Note>,
}

/// A geometry node.
pub(crate) struct Geometry<'a> {
    pub(crate) kind: Kind,
    /// Byte at which it begins.
    pub(crate) at: usize,
    pub(crate) coordinates: Option<Coordinates<'a>>,
    pub(crate) index: Field,
    pub(crate) is_clockwise: bool,
}

/// The coordinates of a geometry node.
pub(crate) enum Coordinates<'a> {
    /// A Coordinate node, by its number.
    Node(usize),
    /// One with this name, which may be defined later. The byte is that of the reference.
    Named(Name<'a>, usize),
}

impl<'a> Scene<'a> {
    pub(crate) fn new(bytes: &'a [u8], input_bytes: u64, format: Format, has_comments: bool) -> Self {
        let (geometries, points, notes) = (Vec::new(), Vec::new(), Vec::new());
        Self { bytes, input_bytes, format, has_comments, geometries, points, names: HashMap::new(), notes }
    }

    /// A geometry node that begins at byte `at`: its number. Its fields may follow.
    pub(crate) fn add_geometry(&mut self, kind: Kind, at: usize) -> Result<usize, Error> {
        let geometry = Geometry { kind, at, coordinates: None, index: Field::default(), is_clockwise: false };
        push(&mut self.geometries, geometry)?;
        Ok(self.geometries.len() - 1)
    }

    pub(crate) fn geometry(&mut self, number: usize) -> &mut Geometry<'a> {
        &mut self.geometries[number]
    }

    /// A Coordinate node: its number.
    pub(crate) fn add_coordinates(&mut self, points: Field) -> Result<usize, Error> {
        push(&mut self.points, points)?;
        Ok(self.points.len() - 1)
    }

    pub(crate) fn set_points(&mut self, number: usize, points: Field) {
        self.points[number] = points;
    }

    /// Names a Coordinate node; a name that was given before is given anew.
    pub(crate) fn define(&mut self, name: Name<'a>, number: usize) -> Result<(), Error> {
        let bytes = self.names.len().saturating_mul(size_of::<(Name<'_>, usize)>());
        self.names.try_reserve(1).map_err(|_| Error::OutOfMemory { path: None, bytes })?;
        self.names.insert(name, number);
        Ok(())
    }

    /// The Coordinate node that has this name by now.
    pub(crate) fn named(&self, name: &Name<'_>, at: usize) -> Result<usize, Error> {
        let unknown = || self.malformed(at, Reason::UnknownName { name: quote(name) });
        self.names.get(name).copied().ok_or_else(unknown)
    }

    /// Counts what is left out. The line is counted from the start of the file, but for the first of its kind only, and
    /// of kinds there are a few dozen: none has its name from the file. So all notes together are linear.
    pub(crate) fn note(&mut self, what: Skipped, count: usize, at: usize) {
        let is_known = self.notes.iter().any(|note| note.what == what);
        let first = if is_known { Place::File } else { self.line(at) };
        skip(&mut self.notes, what, count, first);
    }

    /// Counts a whole node that a `USE` repeats in the scene, but not in the mesh.
    pub(crate) fn note_repeated(&mut self, at: usize) {
        self.note(Skipped::Elements("USE".into()), 1, at);
    }

    /// Counts a node whose content a prototype describes.
    pub(crate) fn note_instance(&mut self, at: usize) {
        self.note(Skipped::Elements("ProtoInstance".into()), 1, at);
    }

    /// Refuses to go deeper than so many levels.
    pub(crate) fn check_depth(&self, depth: usize, at: usize) -> Result<(), Error> {
        if depth < MAX_DEPTH {
            return Ok(());
        }
        Err(self.unsupported(at, format!("more than {MAX_DEPTH} nodes within one another")))
    }

    pub(crate) fn unsupported(&self, at: usize, feature: String) -> Error {
        Error::Unsupported { format: self.format, path: None, place: self.line(at), feature }
    }

    pub(crate) fn malformed(&self, at: usize, reason: Reason) -> Error {
        Error::malformed(self.format, self.line(at), reason)
    }

    /// The line of byte `at`: linear in `at`.
    pub(crate) fn line(&self, at: usize) -> Place {
        Place::Line(Words::new(self.bytes, None).starting_at(at.min(self.bytes.len())).line())
    }

    /// Reads the numbers of all nodes.
    pub(crate) fn into_triangles(self) -> Result<Triangles, Error> {
        assembly::triangles(self)
    }
}

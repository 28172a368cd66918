//! What is written to a file: borrowed arrays.

use std::collections::BTreeMap;
use std::io;

use crate::{Attribute, Error, Format, Place, Reason, Triangles};

/// A mesh to be written: positions and faces, borrowed, and what belongs to them.
///
/// ```
/// let (positions, faces) = ([[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], [[0, 1, 2]]);
/// let mut obj = Vec::new();
/// onering_io::write(&mut obj, onering_io::MeshRef::new(&positions, &faces), onering_io::Format::Obj)?;
/// assert_eq!(onering_io::read(&obj)?.faces, faces);
/// # Ok::<(), onering_io::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default)]
#[non_exhaustive]
pub struct MeshRef<'a> {
    /// `[x, y, z]` of each vertex.
    pub positions: &'a [[f32; 3]],
    /// The three corners of each triangle, each below `positions.len()`.
    pub faces: &'a [[u32; 3]],
    /// The first face of each polygon, as [`Triangles::polygon_starts`] has it: formats with polygons get them back.
    /// Faces from one entry to the next that are no fan around their first corner are written as triangles.
    pub polygon_starts: Option<&'a [u32]>,
    /// Values at the vertices.
    pub vertex_attributes: &'a [Attribute<'a>],
    /// Values at the faces (the triangles, not the polygons).
    pub face_attributes: &'a [Attribute<'a>],
}

impl<'a> MeshRef<'a> {
    /// A mesh without attributes, whose polygons are triangles.
    pub fn new(positions: &'a [[f32; 3]], faces: &'a [[u32; 3]]) -> Self {
        Self { positions, faces, ..Self::default() }
    }

    /// The same mesh with values at its vertices.
    pub fn with_vertex_attributes(self, vertex_attributes: &'a [Attribute<'a>]) -> Self {
        Self { vertex_attributes, ..self }
    }

    /// The same mesh with values at its faces.
    pub fn with_face_attributes(self, face_attributes: &'a [Attribute<'a>]) -> Self {
        Self { face_attributes, ..self }
    }

    /// How many polygons of each corner count a format with polygons gets: as [`Triangles::polygon_sizes`], but for
    /// the faces that are no fan. Linear in the faces.
    pub fn polygon_sizes(&self) -> BTreeMap<usize, usize> {
        let mut sizes = BTreeMap::new();
        if self.polygon_starts.is_none() {
            sizes.extend((!self.faces.is_empty()).then_some((3, self.faces.len())));
            return sizes;
        }
        let counted = self.each_polygon(|corners, _| {
            *sizes.entry(corners.len()).or_default() += 1;
            Ok(())
        });
        debug_assert!(counted.is_ok(), "counting does not fail");
        sizes
    }

    /// Refuses what no file could hold, before anything is written.
    pub(crate) fn check(&self, format: Format) -> Result<(), Error> {
        let vertices = self.positions.len();
        let malformed = |place, reason| Err(Error::malformed(format, place, reason));
        if vertices.max(self.faces.len()) > u32::MAX as usize {
            return malformed(Place::File, Reason::TooMany);
        }
        let beyond = |face: &[u32; 3]| face.iter().find(|corner| **corner as usize >= vertices).copied();
        let bad = self.faces.iter().enumerate().find_map(|(f, face)| Some((f, beyond(face)?)));
        if let Some((face, corner)) = bad {
            return malformed(
                Place::Face(face),
                Reason::IndexOutOfRange { index: corner.to_string(), vertices },
            );
        }
        let of_vertices = self.vertex_attributes.iter().map(|attribute| (attribute, vertices));
        let of_faces = self.face_attributes.iter().map(|attribute| (attribute, self.faces.len()));
        match of_vertices.chain(of_faces).find(|(attribute, needed)| attribute.values.len() != *needed) {
            None => Ok(()),
            Some((Attribute { name, values }, needed)) => {
                let reason = Reason::AttributeLength { name: (*name).into(), needed, found: values.len() };
                malformed(Place::File, reason)
            }
        }
    }

    /// Calls `each` with the corners of every polygon and its first face, in order.
    pub(crate) fn each_polygon(
        &self,
        mut each: impl FnMut(&[u32], usize) -> io::Result<()>,
    ) -> io::Result<()> {
        let Some(starts) = self.polygon_starts else {
            return self.faces.iter().enumerate().try_for_each(|(f, face)| each(face, f));
        };
        let mut corners = Vec::new();
        let mut start = 0;
        // What lies before the first entry is a piece like the others.
        for end in starts.iter().map(|start| *start as usize).chain([self.faces.len()]) {
            let Some(faces) = self.faces.get(start..end) else { continue };
            if is_fan(faces) {
                corners.clear();
                corners.extend(faces[0]);
                corners.extend(faces[1..].iter().map(|face| face[2]));
                each(&corners, start)?;
            } else {
                faces.iter().zip(start..).try_for_each(|(face, f)| each(face, f))?;
            }
            start = end;
        }
        Ok(())
    }
}

/// `a b c`, `a c d`, `a d e`: one polygon or more triangles.
fn is_fan(faces: &[[u32; 3]]) -> bool {
    !faces.is_empty() && faces.windows(2).all(|two| two[0][0] == two[1][0] && two[0][2] == two[1][1])
}

impl<'a> From<&'a Triangles> for MeshRef<'a> {
    fn from(mesh: &'a Triangles) -> Self {
        let polygon_starts = mesh.polygon_starts.as_deref();
        Self { polygon_starts, ..Self::new(&mesh.positions, &mesh.faces) }
    }
}

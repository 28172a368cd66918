//! What a mesh file gives: positions, faces, and notes on what it also held.

use std::collections::BTreeMap;
use std::fmt;
use std::ops::Range;

use crate::{Place, gltf};

/// A list of triangles as read from a file, or to be written to one.
///
/// The readers promise that every corner in `faces` is below `positions.len()`, and that there are at
/// most `u32::MAX` positions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triangles {
    /// `[x, y, z]` of each vertex, in the file's order and in the file's unit.
    pub positions: Vec<[f32; 3]>,
    /// The three corners of each triangle as indices into `positions`, in the file's order and winding.
    pub faces: Vec<[u32; 3]>,
    /// How many polygons of each corner count the faces were cut from: `{3: 32, 4: 468}` is 500 polygons,
    /// and 968 faces. A polygon of n corners is n - 2 consecutive faces.
    pub polygon_sizes: BTreeMap<usize, usize>,
    /// The first face of each polygon, in file order: polygon `p` is the faces from entry `p` to the next one.
    /// `None` where every polygon is a triangle, polygon `f` face `f`.
    pub polygon_starts: Option<Vec<u32>>,
    /// What the file held and this does not, one note for each kind.
    pub notes: Vec<Note>,
    /// What the triangles of a glTF document come from; `None` where they come from elsewhere.
    pub gltf: Option<gltf::Origin>,
}

impl Triangles {
    /// A mesh that was triangles from the start: no polygon was cut, nothing was left out.
    pub fn new(positions: Vec<[f32; 3]>, faces: Vec<[u32; 3]>) -> Self {
        let polygon_sizes = BTreeMap::from_iter((!faces.is_empty()).then_some((3, faces.len())));
        Self { positions, faces, polygon_sizes, ..Self::default() }
    }

    /// Number of polygons in the file, before they were cut into triangles. Linear in the number of
    /// distinct sizes.
    pub fn polygon_count(&self) -> usize {
        self.polygon_sizes.values().sum()
    }

    /// The polygon that face `face` was cut from; `None` if there is no such face. Logarithmic in the number of
    /// polygons.
    pub fn polygon(&self, face: usize) -> Option<usize> {
        if face >= self.faces.len() {
            return None;
        }
        match &self.polygon_starts {
            None => Some(face),
            Some(starts) => starts.partition_point(|start| *start as usize <= face).checked_sub(1),
        }
    }

    /// The faces of each polygon, in file order: a polygon of n corners is n - 2 of them.
    ///
    /// ```
    /// let text = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3\nf 1 2 3 4\n";
    /// let mesh = onering_io::read(text)?;
    /// assert!(mesh.polygons().eq([0..1, 1..3]));
    /// assert_eq!(mesh.polygon(2), Some(1));
    /// # Ok::<(), onering_io::Error>(())
    /// ```
    pub fn polygons(&self) -> impl ExactSizeIterator<Item = Range<usize>> + '_ {
        let starts = self.polygon_starts.as_deref();
        let start = move |p: usize| {
            starts.map_or(p, |starts| starts.get(p).map_or(self.faces.len(), |s| *s as usize))
        };
        (0..starts.map_or(self.faces.len(), <[u32]>::len)).map(move |p| start(p)..start(p + 1))
    }
}

/// Something that a reader left out: what, how often, and where first.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Note {
    /// What was left out.
    pub what: Skipped,
    /// How often.
    pub count: usize,
    /// Where it was met first.
    pub first: Place,
}

/// The kinds of things that readers leave out.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Skipped {
    /// Faces with fewer than three corners.
    ShortFaces,
    /// OBJ elements that are no faces: points, lines, curves, surfaces. Holds the keyword.
    Elements(&'static str),
    /// Lines of OBJ or ASCII STL whose first word is no keyword of the format.
    UnknownStatements,
    /// Bytes behind the last triangle of a binary STL file.
    TrailingBytes,
    /// glTF primitives that are no triangles: holds the mode (0 points, 1 to 3 lines).
    PrimitiveMode(u32),
    /// glTF primitives of a mode that glTF 2.0 does not have.
    UnknownModes,
    /// glTF primitives without positions.
    NoPositions,
    /// Corners at the end of a glTF primitive, too few to make a triangle.
    LooseCorners,
}

impl fmt::Display for Note {
    /// One line, such as `2 faces with fewer than 3 corners skipped, the first at line 7`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { what, count, first } = self;
        let s = if *count == 1 { "" } else { "s" };
        match what {
            Skipped::ShortFaces => write!(f, "{count} face{s} with fewer than 3 corners")?,
            Skipped::Elements(keyword) => write!(f, "{count} element{s} of kind `{keyword}`")?,
            Skipped::UnknownStatements => write!(f, "{count} line{s} with an unknown keyword")?,
            Skipped::TrailingBytes => write!(f, "{count} byte{s} behind the last triangle")?,
            Skipped::PrimitiveMode(mode) => {
                write!(f, "{count} primitive{s} of mode {mode} ({})", mode_name(*mode))?
            }
            Skipped::UnknownModes => write!(f, "{count} primitive{s} of unknown mode")?,
            Skipped::NoPositions => write!(f, "{count} primitive{s} without positions")?,
            Skipped::LooseCorners => write!(f, "{count} corner{s} that make no triangle")?,
        }
        write!(f, " skipped, the first at {first}")
    }
}

fn mode_name(mode: u32) -> &'static str {
    match mode {
        0 => "points",
        1 => "lines",
        2 => "line loop",
        _ => "line strip",
    }
}

/// Counts what is skipped: one note for each kind, in order of first appearance.
pub(crate) fn skip(notes: &mut Vec<Note>, what: Skipped, count: usize, first: Place) {
    match notes.iter_mut().find(|note| note.what == what) {
        Some(note) => note.count += count,
        None => notes.push(Note { what, count, first }),
    }
}

//! Polylines and points, such as contours and minima, to be written to files.

use std::io::{BufWriter, Write};
use std::path::Path;

use crate::memory::push;
use crate::save::{not_written, save_with};
use crate::{Error, Format, Place, Reason, obj, ply};

/// Polylines with a value each, such as contours with their levels. A line of one point is a point.
///
/// | format | points | lines | values |
/// |---|---|---|---|
/// | OBJ | `v`, and `p` for each point that is no line | `l`, a closed one ends with its first point again | no |
/// | PLY, binary | `vertex` | `edge`: `vertex1`, `vertex2` | `float` at the vertices, and `red`, `green`, `blue` |
///
/// Positions and values are kept to the last bit, but for the payload of a NaN in OBJ. Colours are those of an
/// [attribute](crate::Attribute) of scalars.
///
/// ```
/// let mut contours = onering_io::Lines::new("level");
/// contours.push([[0.0, 0.0, 2.0], [1.0, 0.0, 2.0], [0.0, 1.0, 2.0]], true, 2.0)?;
/// let mut obj = Vec::new();
/// contours.write(&mut obj, onering_io::Format::Obj)?;
/// assert_eq!(obj, b"v 0.0 0.0 2.0\nv 1.0 0.0 2.0\nv 0.0 1.0 2.0\nl 1 2 3 1\n");
/// # Ok::<(), onering_io::Error>(())
/// ```
#[derive(Clone, Debug, Default)]
pub struct Lines {
    /// What the values are called.
    name: String,
    positions: Vec<[f32; 3]>,
    /// Where each line ends among the positions.
    ends: Vec<usize>,
    is_closed: Vec<bool>,
    values: Vec<f32>,
}

/// One of [`Lines`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Line<'a> {
    /// `[x, y, z]` of its points, in order.
    pub points: &'a [[f32; 3]],
    /// The index of its first point among those of all lines.
    pub start: usize,
    /// Whether it goes on from its last point to its first one, which it does not repeat.
    pub is_closed: bool,
    /// The value, the same at all its points.
    pub value: f32,
}

impl Lines {
    /// No lines yet; what files call their values, such as `level`.
    pub fn new(value_name: impl Into<String>) -> Self {
        Self { name: value_name.into(), ..Self::default() }
    }

    /// Adds a line. One without points is none, and is not added. Linear in its points.
    ///
    /// # Errors
    /// [`Error::OutOfMemory`].
    pub fn push(
        &mut self,
        points: impl IntoIterator<Item = [f32; 3]>,
        is_closed: bool,
        value: f32,
    ) -> Result<(), Error> {
        let start = self.positions.len();
        points.into_iter().try_for_each(|point| push(&mut self.positions, point))?;
        if self.positions.len() == start {
            return Ok(());
        }
        push(&mut self.ends, self.positions.len())?;
        push(&mut self.is_closed, is_closed)?;
        push(&mut self.values, value)
    }

    /// How many there are.
    pub fn len(&self) -> usize {
        self.ends.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.ends.is_empty()
    }

    /// The lines, in the order in which they were added.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = Line<'_>> {
        (0..self.len()).map(|i| {
            let start = i.checked_sub(1).map_or(0, |before| self.ends[before]);
            let points = &self.positions[start..self.ends[i]];
            Line { points, start, is_closed: self.is_closed[i], value: self.values[i] }
        })
    }

    /// Writes them to the file at `path`, in the format that its extension names; with `.gz` behind it, packed with
    /// gzip. The file appears whole or not at all: see [`Replacement`](crate::Replacement).
    ///
    /// # Errors
    /// [`Error::UnknownFormat`] for the extension, [`Error::NoLines`] for a format other than OBJ and PLY,
    /// [`Error::Malformed`] for more points than a file can name, [`Error::Write`] where the system refuses.
    pub fn save(&self, path: impl AsRef<Path>) -> Result<(), Error> {
        let path = path.as_ref();
        let format =
            Format::of_extension(path).ok_or(Error::UnknownFormat { path: Some(path.to_owned()) })?;
        // Before a file is opened: a format without lines is no reason to touch one.
        writer(format)
            .and_then(|_| save_with(path, |file| self.write(file, format)))
            .map_err(|error| error.in_file(path))
    }

    /// Writes them to `out`, through a buffer.
    ///
    /// # Errors
    /// As [`save`](Self::save), but for the extension.
    pub fn write(&self, out: impl Write, format: Format) -> Result<(), Error> {
        let writer = writer(format)?;
        if u32::try_from(self.positions.len()).is_err() {
            return Err(Error::malformed(format, Place::File, Reason::TooMany));
        }
        let mut out = BufWriter::with_capacity(1 << 16, out);
        writer(self, &mut out).and_then(|()| out.flush()).map_err(not_written)
    }

    /// What the values are called.
    pub(crate) fn value_name(&self) -> &str {
        &self.name
    }

    /// The points of all lines.
    pub(crate) fn positions(&self) -> &[[f32; 3]] {
        &self.positions
    }

    /// The value of each line.
    pub(crate) fn values(&self) -> &[f32] {
        &self.values
    }
}

impl Line<'_> {
    /// Pairs of points, by index among those of all lines, that are next to each other.
    pub(crate) fn edges(&self) -> impl Iterator<Item = [usize; 2]> {
        let end = self.start + self.points.len();
        let closing = (self.is_closed && self.points.len() > 1).then_some([end - 1, self.start]);
        (self.start + 1..end).map(|i| [i - 1, i]).chain(closing)
    }
}

/// How lines are written in a format.
type Writer = fn(&Lines, &mut dyn Write) -> std::io::Result<()>;

fn writer(format: Format) -> Result<Writer, Error> {
    match format {
        Format::Obj => Ok(obj::write_lines),
        Format::Ply => Ok(ply::write_lines),
        _ => Err(Error::NoLines { format, path: None }),
    }
}

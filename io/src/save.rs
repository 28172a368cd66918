//! Meshes to files, whatever the format.

use std::io::{self, BufWriter, Write};
use std::path::Path;

use flate2::{Compression, write::GzEncoder};

use crate::{Error, Format, MeshRef, Replacement};

/// What a caller may choose of how files are written.
///
/// ```
/// let mut options = onering_io::SaveOptions::default();
/// options.ascii = true;
/// let mut ply = Vec::new();
/// options.write(&mut ply, onering_io::MeshRef::new(&[[0.0; 3]], &[]), onering_io::Format::Ply)?;
/// assert!(ply.ends_with(b"end_header\n0.0 0.0 0.0\n"));
/// # Ok::<(), onering_io::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default)]
#[non_exhaustive]
pub struct SaveOptions {
    /// Text instead of bytes, in a format that has both, such as PLY. Others are written as always.
    pub ascii: bool,
}

impl SaveOptions {
    /// [`save`] with these options.
    ///
    /// # Errors
    /// As [`save`].
    pub fn save<'a>(&self, path: impl AsRef<Path>, mesh: impl Into<MeshRef<'a>>) -> Result<(), Error> {
        let path = path.as_ref();
        let format = Format::of_extension(path);
        self.save_as(path, mesh, format.ok_or(Error::UnknownFormat { path: Some(path.to_owned()) })?)
    }

    /// [`save_as`] with these options.
    ///
    /// # Errors
    /// As [`save`].
    pub fn save_as<'a>(
        &self,
        path: impl AsRef<Path>,
        mesh: impl Into<MeshRef<'a>>,
        format: Format,
    ) -> Result<(), Error> {
        let path = path.as_ref();
        save_with(path, |file| self.write(file, mesh, format)).map_err(|error| error.in_file(path))
    }

    /// [`write()`] with these options.
    ///
    /// # Errors
    /// As [`write()`].
    pub fn write<'a>(
        &self,
        out: impl Write,
        mesh: impl Into<MeshRef<'a>>,
        format: Format,
    ) -> Result<(), Error> {
        let writer = format.writer().ok_or(Error::ReadOnly { format, path: None })?;
        let mesh = mesh.into();
        mesh.check(format)?;
        let mut out = BufWriter::with_capacity(1 << 16, out);
        writer(&mesh, &mut out, *self).and_then(|()| out.flush()).map_err(not_written)
    }
}

/// Writes the mesh to the file at `path`, in the format that its extension names; with `.gz` behind it, packed with
/// gzip. The file appears whole or not at all: see [`Replacement`].
///
/// Positions are kept to the last bit, but for the payload of a NaN in a text format. What else a file keeps:
///
/// | format | vertices | polygons | attributes |
/// |---|---|---|---|
/// | OBJ | all | yes | no |
/// | PLY | all | yes, but where faces have values | yes |
/// | STL | those of faces, again for each corner | no | no |
/// | OFF | all | yes | no |
/// | GLB | all; without faces they are points, which [`load`](crate::load) skips; where faces have values, three for each face | no | yes |
///
/// GLB holds finite numbers only, and at most 4 GiB.
///
/// # Errors
/// [`Error::UnknownFormat`] or [`Error::ReadOnly`] for the extension, [`Error::Malformed`] for a corner that is no
/// vertex, an attribute of the wrong length, or a mesh that the format cannot hold, [`Error::Write`] where the system
/// refuses. Whatever it is, what was at `path` before is still there.
pub fn save<'a>(path: impl AsRef<Path>, mesh: impl Into<MeshRef<'a>>) -> Result<(), Error> {
    SaveOptions::default().save(path, mesh)
}

/// [`save`] in this format, whatever the name of the file; `.gz` still has it packed.
///
/// # Errors
/// As [`save`].
pub fn save_as<'a>(
    path: impl AsRef<Path>,
    mesh: impl Into<MeshRef<'a>>,
    format: Format,
) -> Result<(), Error> {
    SaveOptions::default().save_as(path, mesh, format)
}

/// Writes the mesh to `out`, through a buffer.
///
/// # Errors
/// [`Error::ReadOnly`], [`Error::Malformed`] or [`Error::Write`], as [`save`].
pub fn write<'a>(out: impl Write, mesh: impl Into<MeshRef<'a>>, format: Format) -> Result<(), Error> {
    SaveOptions::default().write(out, mesh, format)
}

/// Has `write` fill the file that takes the place of the one at `path`.
pub(crate) fn save_with(
    path: &Path,
    write: impl FnOnce(&mut dyn Write) -> Result<(), Error>,
) -> Result<(), Error> {
    let mut file = Replacement::create(path).map_err(not_written)?;
    if path.extension().is_some_and(|end| end.eq_ignore_ascii_case("gz")) {
        let mut packed = GzEncoder::new(&mut file, Compression::default());
        write(&mut packed)?;
        packed.finish().map_err(not_written)?;
    } else {
        write(&mut file)?;
    }
    file.finish().map_err(not_written)
}

/// A writer that refuses the mesh itself says so within.
pub(crate) fn not_written(error: io::Error) -> Error {
    error.downcast().unwrap_or_else(|source| Error::Write { path: None, source })
}

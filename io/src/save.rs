//! Meshes to files, whatever the format.

use std::io::{self, BufWriter, Write};
use std::path::Path;

use flate2::{Compression, write::GzEncoder};

use crate::{Error, Format, MeshRef, Replacement};

/// Writes the mesh to the file at `path`, in the format that its extension names; with `.gz` behind it, packed with
/// gzip. The file appears whole or not at all: see [`Replacement`].
///
/// Positions are kept to the last bit, but for the payload of a NaN in a text format. STL knows no vertices, so only
/// the corners of faces are in it.
///
/// # Errors
/// [`Error::UnknownFormat`] or [`Error::ReadOnly`] for the extension, [`Error::Malformed`] for a corner that is no
/// vertex or an attribute of the wrong length, [`Error::Write`] where the system refuses. Whatever it is, what was at
/// `path` before is still there.
pub fn save<'a>(path: impl AsRef<Path>, mesh: impl Into<MeshRef<'a>>) -> Result<(), Error> {
    let path = path.as_ref();
    let format = Format::of_extension(path).ok_or(Error::UnknownFormat { path: Some(path.to_owned()) })?;
    save_as(path, mesh, format)
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
    let path = path.as_ref();
    save_with(path, |file| write(file, mesh, format)).map_err(|error| error.in_file(path))
}

/// Writes the mesh to `out`, through a buffer.
///
/// # Errors
/// [`Error::ReadOnly`], [`Error::Malformed`] or [`Error::Write`], as [`save`].
pub fn write<'a>(out: impl Write, mesh: impl Into<MeshRef<'a>>, format: Format) -> Result<(), Error> {
    let writer = format.writer().ok_or(Error::ReadOnly { format, path: None })?;
    let mesh = mesh.into();
    mesh.check(format)?;
    let mut out = BufWriter::with_capacity(1 << 16, out);
    writer(&mesh, &mut out).and_then(|()| out.flush()).map_err(not_written)
}

/// Has `write` fill the file that takes the place of the one at `path`.
fn save_with(path: &Path, write: impl FnOnce(&mut dyn Write) -> Result<(), Error>) -> Result<(), Error> {
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

fn not_written(source: io::Error) -> Error {
    Error::Write { path: None, source }
}

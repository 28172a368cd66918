//! Files and bytes to triangles, whatever the format.

use std::fs;
use std::io;
use std::path::Path;

use crate::{Error, Format, Triangles, gltf, obj};

/// Reads the mesh in the file at `path`; the format is [`Format::of`] its content and its extension.
///
/// No other file is opened, but for the buffers that a glTF document names in its own folder (see
/// [`gltf::read_beside`]).
///
/// # Errors
/// [`Error::Io`] if the file cannot be read or is a directory, [`Error::UnknownFormat`], or what the
/// format's reader says. All of them name the file.
pub fn load(path: impl AsRef<Path>) -> Result<Triangles, Error> {
    let path = path.as_ref();
    let bytes = read_file(path)?;
    let folder = path.parent().unwrap_or(Path::new(""));
    Format::of(path, &bytes)
        .ok_or(Error::UnknownFormat { path: None })
        .and_then(|format| dispatch(&bytes, format, Some(folder)))
        .map_err(|error| error.in_file(path))
}

/// Reads the mesh in `bytes`; the format is [`Format::of_content`].
///
/// # Errors
/// [`Error::UnknownFormat`], or what the format's reader says.
pub fn read(bytes: &[u8]) -> Result<Triangles, Error> {
    read_as(bytes, Format::of_content(bytes).ok_or(Error::UnknownFormat { path: None })?)
}

/// Reads the mesh in `bytes`, which are of this format.
///
/// # Errors
/// What the format's reader says: see [`obj::read`] and [`gltf::read`].
pub fn read_as(bytes: &[u8], format: Format) -> Result<Triangles, Error> {
    dispatch(bytes, format, None)
}

/// The one place where a format meets its reader.
fn dispatch(bytes: &[u8], format: Format, folder: Option<&Path>) -> Result<Triangles, Error> {
    match format {
        Format::Obj => obj::read(bytes),
        Format::Gltf | Format::Glb => gltf::read_format(bytes, format, folder),
    }
}

pub(crate) fn read_file(path: &Path) -> Result<Vec<u8>, Error> {
    // Reading a directory fails on some systems only, and in words of their own.
    if path.is_dir() {
        let source = io::Error::new(io::ErrorKind::IsADirectory, "this is a directory, not a mesh file");
        return Err(Error::Io { path: path.to_owned(), source });
    }
    fs::read(path).map_err(|source| Error::Io { path: path.to_owned(), source })
}

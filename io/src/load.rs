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
/// [`Error::Io`] if the file cannot be read or is not a regular one, [`Error::UnknownFormat`], or what the
/// format's reader says. All of them name the file.
pub fn load(path: impl AsRef<Path>) -> Result<Triangles, Error> {
    let path = path.as_ref();
    read_at(&bytes_of(path)?, path)
}

/// All bytes of the file at `path`, for [`read_at`] and whatever else they are wanted for.
///
/// # Errors
/// [`Error::Io`] if the file cannot be read or is not a regular one: a pipe or a device might never end.
pub fn bytes_of(path: impl AsRef<Path>) -> Result<Vec<u8>, Error> {
    let path = path.as_ref();
    check_file(path).and_then(|()| fs::read(path)).map_err(|source| Error::Io {
        path: path.to_owned(),
        named_in: None,
        source,
    })
}

/// Reads the mesh in `bytes`, which are the content of the file at `path`: just what [`load`] does, where the
/// bytes are at hand. The file itself is not opened.
///
/// # Errors
/// As [`load`].
pub fn read_at(bytes: &[u8], path: impl AsRef<Path>) -> Result<Triangles, Error> {
    let path = path.as_ref();
    let folder = path.parent().unwrap_or(Path::new(""));
    Format::of(path, bytes)
        .ok_or(Error::UnknownFormat { path: None })
        .and_then(|format| dispatch(bytes, format, Some(folder)))
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

/// Regular files only, in words of our own: systems differ in what they say of a directory.
fn check_file(path: &Path) -> io::Result<()> {
    let kind = fs::metadata(path)?.file_type();
    if kind.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "this is a directory, not a mesh file"));
    }
    if !kind.is_file() {
        let problem = "this is not a regular file; a pipe or a device may have no end";
        return Err(io::Error::new(io::ErrorKind::InvalidInput, problem));
    }
    Ok(())
}

//! Files and bytes to triangles, whatever the format.

use std::fs;
use std::io;
use std::path::Path;

use crate::{Error, Format, Place, Triangles, gltf, obj};

/// Reads the mesh in the file at `path`; the format is [`Format::of`] its content and its extension.
///
/// No other file is opened, but for the buffers that a glTF document names in its own folder (see
/// [`gltf::read_beside`]).
///
/// # Time and memory
/// Linear in the bytes of the file and its buffers, whatever is in them; they are in memory as a whole while
/// they are read. The result has at most 6 bytes for each byte of an OBJ file, and 48 for each byte of a glTF
/// document and its files, or 800 kB: see [`gltf::read_beside`]. While it is made, memory besides the file is
/// at most 20 bytes for each byte of an OBJ file. For a glTF document it is at most 100 for each of its bytes
/// and of its files, and 140 more for each byte of JSON; few files come near that.
///
/// # Errors
/// [`Error::Io`] if the file cannot be read, is a directory or a device, [`Error::UnknownFormat`], or what the
/// format's reader says. All of them name the file.
pub fn load(path: impl AsRef<Path>) -> Result<Triangles, Error> {
    let path = path.as_ref();
    read_at(&bytes_of(path)?, path)
}

/// All bytes of the file at `path`, for [`read_at`] and whatever else they are wanted for. A pipe is read to its
/// end.
///
/// # Errors
/// [`Error::Io`] if the file cannot be read, or is a directory or a device: a device might never end. The null
/// device is empty.
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
        Format::Ring => Err(Error::Unsupported {
            format,
            path: None,
            place: Place::File,
            feature: "to be opened with `onering::ring`".into(),
        }),
    }
}

/// Refuses directories, in words of our own since systems differ in theirs, and devices.
fn check_file(path: &Path) -> io::Result<()> {
    let about = fs::metadata(path)?;
    if about.is_dir() {
        return Err(io::Error::new(io::ErrorKind::IsADirectory, "this is a directory, not a mesh file"));
    }
    if is_device(&about) {
        return Err(io::Error::new(io::ErrorKind::InvalidInput, "this is a device, which may have no end"));
    }
    Ok(())
}

/// Whether it is a device, and not the null device.
#[cfg(unix)]
fn is_device(about: &fs::Metadata) -> bool {
    use std::os::unix::fs::{FileTypeExt, MetadataExt};
    let kind = about.file_type();
    let is_null = || fs::metadata("/dev/null").is_ok_and(|null| null.rdev() == about.rdev());
    kind.is_block_device() || kind.is_char_device() && !is_null()
}

/// Other systems have no devices among their files.
#[cfg(not(unix))]
fn is_device(_: &fs::Metadata) -> bool {
    false
}

//! Files and bytes to triangles, whatever the format.

use std::fs::{self, File};
use std::io::{self, Read};
use std::path::Path;

use crate::text::without_byte_order_mark;
use crate::{Error, Format, Triangles, gzip, obj, stl};

/// What a caller may choose of how files are read.
///
/// ```
/// let mut options = onering_io::Options::default();
/// options.weld_stl = false;
/// ```
#[derive(Clone, Copy, Debug)]
#[non_exhaustive]
pub struct Options {
    /// Merge the corners of an STL file that have equal coordinates, in order of first appearance. An STL file has
    /// no vertices, only corners, so this is on by default. -0 and 0 are equal; a NaN is equal to nothing.
    pub weld_stl: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self { weld_stl: true }
    }
}

/// Bytes of a file that is worth reading in pieces.
const LARGE: u64 = 1 << 20;

/// Bytes that show the format of such a file.
const START: usize = 1 << 16;

/// A file whose bytes are shown to `seen` when they are read.
struct Shown<S> {
    file: File,
    seen: S,
}

impl<S: FnMut(&[u8])> Read for Shown<S> {
    fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
        let length = self.file.read(buffer)?;
        (self.seen)(&buffer[..length]);
        Ok(length)
    }
}

/// What the reader of a format is asked for, besides the bytes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Request<'a> {
    pub(crate) format: Format,
    /// Where files may lie that this one names; `None` where it may name none.
    pub(crate) folder: Option<&'a Path>,
    /// What a mesh that names the same data many times is measured by: the size of the file, of a packed one as it is.
    pub(crate) input_bytes: u64,
    pub(crate) options: Options,
}

impl Options {
    /// [`load`] with these options.
    ///
    /// # Errors
    /// As [`load`].
    pub fn load(&self, path: impl AsRef<Path>) -> Result<Triangles, Error> {
        let path = path.as_ref();
        match self.load_in_pieces(path, |_| ()) {
            Some((mesh, _)) => Ok(mesh),
            None => self.read_at(&bytes_of(path)?, path),
        }
    }

    /// The mesh and the format of a large OBJ or binary STL file, of which only a piece at a time is in memory; `seen`
    /// is shown all its bytes on the way, in order, such as for a checksum. `None` for any other file, and for one with
    /// something wrong: that is to be read as a whole, and what was seen of it to be forgotten. [`load`] does so.
    ///
    /// With the feature `parallel`, `seen` is called under a lock by a thread of the pool: it may not wait for other work of
    /// rayon.
    pub fn load_in_pieces(
        &self,
        path: impl AsRef<Path>,
        mut seen: impl FnMut(&[u8]) + Send,
    ) -> Option<(Triangles, Format)> {
        let path = path.as_ref();
        let about = fs::metadata(path).ok().filter(fs::Metadata::is_file)?;
        let length = about.len();
        if length < LARGE {
            return None;
        }
        let mut file = File::open(path).ok()?;
        let mut start = vec![0; START];
        file.read_exact(&mut start).ok()?;
        if gzip::is_packed(&start) || matches!(Format::of_content(&start), Some(Format::Glb | Format::Ring)) {
            return None;
        }
        if stl::has_binary_length(&start, length) {
            seen(&start);
            let file = start.as_slice().chain(Shown { file, seen });
            return Some((stl::pieces::read(file, length, self.weld_stl)?, Format::Stl));
        }
        // The last word of what is only the start of a file may be only the start of a word.
        let lines = &start[..memchr::memrchr(b'\n', &start).map_or(0, |end| end + 1)];
        if Format::of_content(lines) != Some(Format::Obj) {
            return None;
        }
        seen(&start);
        let file = without_byte_order_mark(&start).chain(Shown { file, seen });
        Some((obj::pieces::read(file)?, Format::Obj))
    }

    /// [`read_at`] with these options.
    ///
    /// # Errors
    /// As [`load`].
    pub fn read_at(&self, bytes: &[u8], path: impl AsRef<Path>) -> Result<Triangles, Error> {
        let path = path.as_ref();
        let folder = Some(path.parent().unwrap_or(Path::new("")));
        self.dispatch(bytes, |bytes| Format::of(path, bytes), folder).map_err(|error| error.in_file(path))
    }

    /// [`read`] with these options.
    ///
    /// # Errors
    /// As [`read`].
    pub fn read(&self, bytes: &[u8]) -> Result<Triangles, Error> {
        self.dispatch(bytes, Format::of_content, None)
    }

    /// [`read_as`] with these options.
    ///
    /// # Errors
    /// As [`read_as`].
    pub fn read_as(&self, bytes: &[u8], format: Format) -> Result<Triangles, Error> {
        self.dispatch(bytes, |_| Some(format), None)
    }

    /// The one place where bytes meet the reader of their format.
    fn dispatch(
        &self,
        bytes: &[u8],
        format_of: impl FnOnce(&[u8]) -> Option<Format>,
        folder: Option<&Path>,
    ) -> Result<Triangles, Error> {
        let input_bytes = bytes.len() as u64;
        let bytes = gzip::unpacked(bytes)?;
        let format = format_of(&bytes).ok_or(Error::UnknownFormat { path: None })?;
        format.read(&bytes, &Request { format, folder, input_bytes, options: *self })
    }
}

/// Reads the mesh in the file at `path`; the format is [`Format::of`] its content and its extension. A file that is
/// packed with gzip is unpacked first, whatever its name.
///
/// No other file is opened, but for the buffers that a glTF document names in its own folder (see
/// [`gltf::read_beside`](crate::gltf::read_beside)).
///
/// # Time and memory
/// Linear in the bytes of the file and its buffers, whatever is in them; they are in memory as a whole while
/// they are read. Of an OBJ or binary STL file of 1 MiB or more only a piece is, unless something is wrong with
/// it: mostly less than 1 MiB and at most 48, with the feature `parallel` for each thread. A gzip file counts as what is
/// in it, which is at most 100 times as large, or 16 MiB; but where data can be named again and again, as the packed
/// file. For each byte of the file, the result has at most so many:
///
/// | format | bytes | reached by |
/// |---|---|---|
/// | STL | 2 | ASCII, every number a digit; less than 1 for binary |
/// | OBJ, OFF | 6 | a polygon of many corners of a digit each |
/// | PLY | 16 | a binary strip of a byte for each corner, in a file with other polygons |
/// | glTF and its buffers | 48, or 800 kB in all | lists of points that are named again and again |
/// | X3D, VRML | 54, or 900 kB in all | the same, in a file with other polygons |
///
/// While it is made, memory besides the file is at most 20 bytes for each byte of an OBJ file. For a glTF document it is
/// at most 100 for each of its bytes and of its files, and 140 more for each byte of JSON (see
/// [`gltf::read_beside`](crate::gltf::read_beside)); few files come near that. In the other formats each array of the
/// result may take three times its size while it grows, and besides: [`stl::read`](crate::stl::read) says what welding
/// takes, a PLY header 40 bytes for each of its own, and X3D and VRML up to 100 for each node or bracket.
///
/// # Errors
/// [`Error::Io`] if the file cannot be read, is a directory or a device, [`Error::UnknownFormat`], or what the
/// format's reader says. All of them name the file.
pub fn load(path: impl AsRef<Path>) -> Result<Triangles, Error> {
    Options::default().load(path)
}

/// What [`load`] makes of a large file of these bytes, with so many bytes of it (triangles of STL) in a piece: for the
/// fuzz targets, whose files are small. `None` where [`load`] reads it as a whole.
#[doc(hidden)]
pub fn read_in_pieces(bytes: &[u8], format: Format, size: usize) -> Option<Triangles> {
    match format {
        Format::Obj => obj::pieces::read_pieces(without_byte_order_mark(bytes), size),
        Format::Stl => stl::pieces::read_pieces(bytes, bytes.len() as u64, true, size),
        _ => None,
    }
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
    Options::default().read_at(bytes, path)
}

/// Reads the mesh in `bytes`, which may be packed with gzip; the format is [`Format::of_content`].
///
/// # Errors
/// [`Error::UnknownFormat`], or what the format's reader says.
pub fn read(bytes: &[u8]) -> Result<Triangles, Error> {
    Options::default().read(bytes)
}

/// Reads the mesh in `bytes`, which are of this format and may be packed with gzip.
///
/// # Errors
/// What the format's reader says, such as [`obj::read`](crate::obj::read).
pub fn read_as(bytes: &[u8], format: Format) -> Result<Triangles, Error> {
    Options::default().read_as(bytes, format)
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

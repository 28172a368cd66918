//! [`File`]: an open file, and the meshes that borrow from it.
use super::bytes::{Bytes, Failed};
use super::head::{self, Head, Section};
use super::problem::{Problem, of_header, of_section};
use crate::columns::{Columns, FromColumns, Invalid, Source};
use crate::storage::{Borrowed, Element, Owned, Storage};
use alloc::{borrow::ToOwned, boxed::Box, format};
use core::fmt;
use onering_io::Error;
use std::fs;
use std::path::{Path, PathBuf};

/// The section of positions.
pub(super) const POSITIONS: &str = "positions";

/// An open `.ring` file: what its meshes borrow their columns from. See the [module](super).
pub struct File {
    bytes: Bytes,
    head: Head,
    path: Option<PathBuf>,
    /// Whether meshes are handed out without a look at their columns.
    is_trusted: bool,
}

impl File {
    /// Reads the file at `path` into memory and checks its header and all its checksums. O(bytes).
    ///
    /// # Errors
    /// [`Error::Io`], [`Error::Malformed`] with the byte at fault, [`Error::OutOfMemory`]. Of a file that is no `.ring`
    /// file, only the header is read.
    pub fn read(path: impl AsRef<Path>) -> Result<Self, Error> {
        let path = path.as_ref();
        let bytes = Bytes::read(&open(path)?).map_err(|failed| failed.error(path))?;
        Self::checked(bytes, Some(path))
    }

    /// The file with these bytes, which are copied to where columns may begin. O(bytes).
    ///
    /// # Errors
    /// As [`read`](Self::read), without [`Error::Io`].
    pub fn from_bytes(bytes: &[u8]) -> Result<Self, Error> {
        let copied = Head::parse(bytes).and_then(|_| Bytes::copied(bytes));
        Self::checked(copied.map_err(|problem| problem.error(None))?, None)
    }

    /// Maps the file at `path` into memory and checks its header and all its checksums. O(bytes), of which none is
    /// copied.
    ///
    /// # Safety
    /// As long as the [`File`] lives, nobody may change the file or cut it short: not this process, and no other. What
    /// is in it does not matter. [`save`](super::save) never changes a file that is there, as it puts another
    /// one in its place. Where others may write to the file, [`read`](Self::read) it.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    #[cfg(feature = "mmap")]
    #[expect(
        unsafe_code,
        reason = "the file may not be changed while it is mapped, which only the caller can know"
    )]
    pub unsafe fn open(path: impl AsRef<Path>) -> Result<Self, Error> {
        let path = path.as_ref();
        // SAFETY: the caller promises that the file does not change.
        let bytes = unsafe { map(path, true) }?;
        Self::checked(bytes, Some(path))
    }

    /// Maps the file at `path` into memory and checks nothing but its header: no checksum, and no mesh that it gives.
    /// O(1), whatever the size of the file, of which only what is asked for is ever read.
    ///
    /// # Safety
    /// As for [`open`](Self::open), and the file is one that [`save`](super::save) or [`write`](super::write) made, every
    /// byte as it was written.
    ///
    /// What can go wrong where that does not hold: accessors check bounds and every pattern of bits is a value of its
    /// column, so wrong columns by themselves give wrong answers, panics and walks that do not end, and a
    /// caller may not build on either of these. A file that changes under the map is undefined behaviour, and
    /// one that is cut short ends the process with a signal.
    ///
    /// # Errors
    /// [`Error::Io`], and [`Error::Malformed`] for the header.
    #[cfg(feature = "mmap")]
    #[expect(unsafe_code, reason = "nothing of the file is looked at, so the caller has to know what it is")]
    pub unsafe fn open_trusted(path: impl AsRef<Path>) -> Result<Self, Error> {
        let path = path.as_ref();
        // SAFETY: the caller promises that the file does not change.
        let bytes = unsafe { map(path, false) }?;
        let head = Head::parse(&bytes).map_err(|problem| problem.error(Some(path)))?;
        Ok(Self { bytes, head, path: Some(path.to_owned()), is_trusted: true })
    }

    fn checked(bytes: Bytes, path: Option<&Path>) -> Result<Self, Error> {
        let head = Head::parse(&bytes).map_err(|problem| problem.error(path))?;
        let file = Self { bytes, head, path: path.map(Path::to_owned), is_trusted: false };
        file.check_sections().map_err(|problem| file.error(problem))?;
        Ok(file)
    }

    /// Every byte after the head is one of a section with a good checksum, or a zero between two of them.
    fn check_sections(&self) -> Result<(), Problem> {
        let mut end = self.head.sections.first().map_or(0, |first| first.bytes.start);
        for section in &self.head.sections {
            if self.bytes[end..section.bytes.start].iter().any(|&byte| byte != 0) {
                return Err(of_section(&section.name, end, "has something before it"));
            }
            if head::checksum(&self.bytes[section.bytes.clone()]) != section.checksum {
                return Err(of_section(&section.name, section.bytes.start, "its checksum does not match"));
            }
            end = section.bytes.end;
        }
        match self.head.named(POSITIONS) {
            Some(section) if section.bytes.len() != 12 * self.head.vertices || section.element_size != 12 => {
                Err(of_section(POSITIONS, section.bytes.start, "has not one element for each vertex"))
            }
            _ => Ok(()),
        }
    }

    /// The name of the structure in the file, as in the registry: `che-l2`.
    pub fn backend(&self) -> &str {
        &self.head.backend
    }

    /// Number of vertices.
    pub fn vertex_count(&self) -> usize {
        self.head.vertices
    }

    /// Number of faces; 0 where the structure knows none.
    pub fn face_count(&self) -> usize {
        self.head.faces
    }

    /// `[x, y, z]` of each vertex; `None` where the file has no positions.
    pub fn positions(&self) -> Option<&[[f32; 3]]> {
        let section = self.head.named(POSITIONS)?;
        bytemuck::try_cast_slice(&self.bytes[section.bytes.clone()]).ok()
    }

    /// The mesh in the file, its columns those of the file: `file.mesh::<CheL2>()` is a `CheL2<Borrowed>`. They are
    /// [validated](Columns::validate), unless the file was opened as a trusted one: O(elements), or O(1).
    ///
    /// # Errors
    /// [`Error::Malformed`] where the file has another structure than `M`, and where it is not what traversal relies on;
    /// [`Error::OutOfMemory`] for the scratch of validation.
    pub fn mesh<M: FromColumns>(&self) -> Result<M::Over<Borrowed<'_>>, Error> {
        self.make::<M, Borrowed<'_>>(|sections| M::from_columns::<Borrowed<'_>>(sections))
    }

    /// As [`mesh`](Self::mesh), with a copy of the columns, which outlives the file.
    ///
    /// # Errors
    /// As [`mesh`](Self::mesh).
    pub fn owned_mesh<M: FromColumns>(&self) -> Result<M::Over<Owned>, Error> {
        self.make::<M, Owned>(|sections| M::from_columns::<Owned>(sections))
    }

    fn make<'a, M: FromColumns, S: Storage>(
        &'a self,
        from: impl FnOnce(&Sections<'a>) -> Result<M::Over<S>, Invalid>,
    ) -> Result<M::Over<S>, Error> {
        let (found, asked) = (&self.head.backend, M::backend_name());
        if *found != asked {
            return Err(self.error(of_header(48, format!("the structure is {found}, not {asked}"))));
        }
        let place = |name: &str| {
            self.head.named(name).map_or((0, 0), |section| (section.bytes.start, section.element_size))
        };
        let error = |invalid: Invalid| self.error(Problem::of(&invalid, place));
        let mesh = from(&Sections { file: self }).map_err(error)?;
        if !self.is_trusted {
            mesh.validate().map_err(error)?;
        }
        Ok(mesh)
    }

    pub(super) fn error(&self, problem: Problem) -> Error {
        problem.error(self.path.as_deref())
    }
}

impl fmt::Debug for File {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (backend, bytes) = (self.backend(), self.bytes.len());
        write!(f, "File {{ backend: {backend}, bytes: {bytes}, path: {:?} }}", self.path)
    }
}

impl Failed {
    fn error(self, path: &Path) -> Error {
        match self {
            Self::System(source) => Error::Io { path: path.to_owned(), named_in: None, source },
            Self::Problem(problem) => problem.error(Some(path)),
        }
    }
}

fn open(path: &Path) -> Result<fs::File, Error> {
    fs::File::open(path).map_err(|source| Failed::System(source).error(path))
}

/// # Safety
/// Nobody may change the file or cut it short as long as it is mapped.
#[cfg(feature = "mmap")]
#[expect(unsafe_code, reason = "the only way to map a file")]
unsafe fn map(path: &Path, whole: bool) -> Result<Bytes, Error> {
    let error = |source| Failed::System(source).error(path);
    let file = open(path)?;
    if !file.metadata().map_err(error)?.is_file() {
        let source = std::io::Error::new(std::io::ErrorKind::InvalidInput, "this is no regular file");
        return Err(error(source));
    }
    let mut options = memmap2::MmapOptions::new();
    if whole {
        // All pages at once instead of a fault for every few.
        options.populate();
    }
    // SAFETY: the caller promises that the file does not change while it is mapped.
    unsafe { options.map(&file) }.map(Bytes::Map).map_err(error)
}

/// The sections of a file as columns.
struct Sections<'a> {
    file: &'a File,
}

impl<'a> Sections<'a> {
    fn cells<T: Element>(&self, column: &'static str, length: Option<usize>) -> Result<&'a [T], Invalid> {
        let section: &Section = self.file.head.named(column).ok_or(Invalid::Missing { column })?;
        if section.element_size != size_of::<T>() {
            return Err(Invalid::column(column, "has elements of another size"));
        }
        let cells = bytemuck::try_cast_slice(&self.file.bytes[section.bytes.clone()]);
        let cells: &[T] = cells.map_err(|_| Invalid::column(column, "is not aligned"))?;
        match length {
            Some(length) if length != cells.len() => Err(Invalid::column(column, "is of another length")),
            _ => Ok(cells),
        }
    }
}

impl<'a> Source<Borrowed<'a>> for Sections<'a> {
    fn vertex_count(&self) -> usize {
        self.file.vertex_count()
    }

    fn face_count(&self) -> usize {
        self.file.face_count()
    }

    fn column<T: Element>(&self, name: &'static str, length: Option<usize>) -> Result<&'a [T], Invalid> {
        self.cells(name, length)
    }
}

impl Source<Owned> for Sections<'_> {
    fn vertex_count(&self) -> usize {
        self.file.vertex_count()
    }

    fn face_count(&self) -> usize {
        self.file.face_count()
    }

    fn column<T: Element>(&self, name: &'static str, length: Option<usize>) -> Result<Box<[T]>, Invalid> {
        let cells = self.cells::<T>(name, length)?;
        Ok(crate::memory::collected(cells.iter().copied())?.into())
    }
}

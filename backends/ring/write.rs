//! Structures to files.
use super::file::POSITIONS;
use super::head::{ALIGNMENT, Head};
use crate::columns::Columns;
use alloc::{borrow::ToOwned, format, vec::Vec};
use onering_io::Error;
use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// Writes `mesh`, and a position for each of its vertices where there are any, as a `.ring` file. O(bytes).
///
/// # Errors
/// Those of `out`; [`InvalidInput`](io::ErrorKind::InvalidInput) where there is not one position for each vertex, and
/// where a structure that is not in the registry has a name that a file cannot have;
/// [`Unsupported`](io::ErrorKind::Unsupported) on a big-endian machine.
pub fn write(
    out: &mut impl Write,
    mesh: &(impl Columns + ?Sized),
    positions: Option<&[[f32; 3]]>,
) -> io::Result<()> {
    if cfg!(target_endian = "big") {
        return Err(io::Error::new(io::ErrorKind::Unsupported, "a .ring file is little-endian"));
    }
    let counts = mesh.counts();
    if positions.is_some_and(|positions| positions.len() != counts.0) {
        return Err(invalid("there is not one position for each vertex"));
    }
    let columns = mesh.columns();
    let mut contents: Vec<_> = columns.iter().map(|c| (c.name, c.element_size, c.bytes)).collect();
    contents.extend(positions.map(|positions| (POSITIONS, 12, bytemuck::cast_slice(positions))));
    let head = Head::bytes(&mesh.backend(), counts, &contents);
    let head = head.ok_or_else(|| invalid("the structure has names that a .ring file cannot have"))?;
    out.write_all(&head)?;
    let mut at = head.len();
    for (_, _, bytes) in contents {
        let start = at.next_multiple_of(ALIGNMENT);
        out.write_all(&[0; ALIGNMENT][..start - at])?;
        out.write_all(bytes)?;
        at = start + bytes.len();
    }
    Ok(())
}

/// Writes `mesh` to the file at `path`, beside it first: whoever opens the file never sees half of it, one that is mapped
/// does not change, and what was there stays where this fails. O(bytes).
///
/// # Errors
/// [`Error::Io`], with what [`write`] says as its source.
pub fn save(
    path: impl AsRef<Path>,
    mesh: &(impl Columns + ?Sized),
    positions: Option<&[[f32; 3]]>,
) -> Result<(), Error> {
    let path = path.as_ref();
    let written = Beside::create(path).and_then(|mut beside| {
        write(&mut beside.file, mesh, positions)?;
        beside.rename()
    });
    written.map_err(|source| Error::Io { path: path.to_owned(), named_in: None, source })
}

fn invalid(problem: &'static str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, problem)
}

/// A file beside its target, which it takes the place of at the end.
struct Beside {
    file: File,
    name: PathBuf,
    target: PathBuf,
    is_done: bool,
}

impl Beside {
    fn create(path: &Path) -> io::Result<Self> {
        // A link stays one: what it leads to is replaced.
        let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        if fs::metadata(&target).is_ok_and(|found| !found.is_file()) {
            return Err(invalid("this is no regular file"));
        }
        let name = target.file_name().ok_or_else(|| invalid("this names no file"))?;
        let mut hidden = OsString::from(".");
        hidden.push(name);
        hidden.push(format!(".{}.tmp", std::process::id()));
        let name = target.with_file_name(hidden);
        let file = File::options().write(true).create_new(true).open(&name)?;
        Ok(Self { file, name, target, is_done: false })
    }

    fn rename(mut self) -> io::Result<()> {
        self.file.sync_all()?;
        fs::rename(&self.name, &self.target)?;
        self.is_done = true;
        Ok(())
    }
}

/// Leaves nothing behind where the file was not finished.
impl Drop for Beside {
    fn drop(&mut self) {
        if !self.is_done {
            let _ = fs::remove_file(&self.name);
        }
    }
}

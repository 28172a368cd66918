//! Structures to files.
use super::file::POSITIONS;
use super::head::{ALIGNMENT, Head};
use crate::columns::Columns;
use alloc::{borrow::ToOwned, vec::Vec};
use onering_io::{Error, Replacement};
use std::io::{self, Write};
use std::path::Path;

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
/// [`Error::Write`], with what [`write()`] says as its source.
pub fn save(
    path: impl AsRef<Path>,
    mesh: &(impl Columns + ?Sized),
    positions: Option<&[[f32; 3]]>,
) -> Result<(), Error> {
    let path = path.as_ref();
    let written = Replacement::create(path).and_then(|mut file| {
        write(&mut file, mesh, positions)?;
        file.finish()
    });
    written.map_err(|source| Error::Write { path: Some(path.to_owned()), source })
}

fn invalid(problem: &'static str) -> io::Error {
    io::Error::new(io::ErrorKind::InvalidInput, problem)
}

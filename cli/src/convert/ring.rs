//! `.ring` files: a mesh in the arrays of one backend.

use super::holds::Holds;
use crate::failure::Failure;
use onering::BuildError;
use onering::columns::Columns;
use onering::ring;
use onering_io::{Format, MeshRef};
use std::borrow::Cow;
use std::io;
use std::path::Path;

/// The backend where none is named.
pub(crate) use crate::on_backend::DEFAULT;

/// What becomes of a mesh in such a file.
pub(crate) const HOLDS: Holds =
    Holds { polygons: false, isolated_vertices: true, equal_positions: true, attributes: false };

/// Whether the name is that of such a file.
pub(crate) fn is_named(path: &Path) -> bool {
    Format::of_extension(path) == Some(Format::Ring) && !is_packed(path)
}

/// Whether the name is that of a packed file, which could not be mapped into memory.
pub(crate) fn is_packed(path: &Path) -> bool {
    path.extension().is_some_and(|end| end.eq_ignore_ascii_case("gz"))
}

/// Builds the structure and writes it to the file, or to standard output.
pub(crate) fn write(path: Option<&Path>, mesh: MeshRef<'_>, backend: &str) -> Result<(), Failure> {
    let structure = build(mesh, backend).map_err(|error| refused(path, backend, &error))?;
    match path {
        Some(path) => ring::save(path, &*structure, Some(mesh.positions))
            .map_err(|error| Failure::Output(error.to_string())),
        None => ring::write(&mut io::stdout().lock(), &*structure, Some(mesh.positions))
            .map_err(Failure::Standard),
    }
}

fn build(mesh: MeshRef<'_>, backend: &str) -> Result<Box<dyn Columns>, BuildError> {
    let built = ring::build(backend, mesh.positions.len(), Cow::Borrowed(mesh.faces));
    built.expect("the command line takes names of the registry only")
}

fn refused(path: Option<&Path>, backend: &str, error: &BuildError) -> Failure {
    let name = path.map_or("standard output".into(), |path| path.display().to_string());
    Failure::Output(format!(
        "{name}: {backend} cannot hold the mesh: {error} (--repair makes one that every backend holds)"
    ))
}

//! Meshes from files, and from standard input where the name is `-`.

use crate::args::MeshFile;
use crate::convert::Change;
use crate::failure::Failure;
use crate::made::Made;
use onering::ring::{self, File};
use onering_io::{Error, Format, Options, Triangles};
use std::io::{self, Read};
use std::path::Path;

/// The one mesh that a command works on.
#[derive(Debug)]
pub(crate) struct Input {
    /// What to call it.
    pub(crate) name: String,
    pub(crate) mesh: Triangles,
    /// `None` where it was made.
    pub(crate) format: Option<Format>,
}

impl Input {
    /// The mesh of the command line, welded and repaired where that is asked for; `made` where no file is named.
    pub(crate) fn read(options: &MeshFile, made: Made) -> Result<Self, Failure> {
        let Some(path) = &options.file else {
            return Ok(Self { name: made.name.into(), mesh: (made.mesh)(), format: None });
        };
        let (mut mesh, format) = mesh_of(path, options.from, Options::default()).map_err(Failure::Input)?;
        let name = name_of(path);
        Change::apply(options.weld, options.repair, &name, &mut mesh)?;
        Ok(Self { name, mesh, format: Some(format) })
    }
}

/// Whether this names standard input or output, and no file.
pub(crate) fn is_standard(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// What to call it: a file goes by its path.
pub(crate) fn name_of(path: &Path) -> String {
    if is_standard(path) { "standard input".into() } else { path.display().to_string() }
}

/// All of it, as it is there.
///
/// # Errors
/// A line that names what could not be read. Standard input of no bytes is one: whoever should have written to it
/// has failed.
pub(crate) fn bytes_of(path: &Path) -> Result<Vec<u8>, String> {
    if !is_standard(path) {
        return onering_io::bytes_of(path).map_err(|error| error.to_string());
    }
    let mut bytes = Vec::new();
    match io::stdin().lock().read_to_end(&mut bytes) {
        Err(error) => Err(format!("standard input: {error}")),
        Ok(0) => Err("standard input: it is empty".into()),
        Ok(_) => Ok(bytes),
    }
}

/// The mesh of a file, or of standard input, which is of this format where one is given; and the format.
///
/// # Errors
/// As [`bytes_of`] and [`mesh_in`].
pub(crate) fn mesh_of(
    path: &Path,
    format: Option<Format>,
    options: Options,
) -> Result<(Triangles, Format), String> {
    match in_pieces(path, format, options, |_| ()) {
        Some(read) => Ok(read),
        None => mesh_in(&bytes_of(path)?, path, format, options),
    }
}

/// The same for the large files of which only a piece at a time need be in memory; `seen` is shown all their bytes.
/// `None` for all others, and where something is wrong: their bytes are to be read as a whole.
pub(crate) fn in_pieces(
    path: &Path,
    format: Option<Format>,
    options: Options,
    seen: impl FnMut(&[u8]) + Send,
) -> Option<(Triangles, Format)> {
    let tells_its_format = format.is_none() && !is_standard(path);
    tells_its_format.then(|| options.load_in_pieces(path, seen))?
}

/// The mesh in the bytes of a file, or of standard input, which are of this format where one is given; and the format.
/// Only a file whose format is told by the file itself may refer to others beside it.
///
/// # Errors
/// A line that names the file, and the place in it.
pub(crate) fn mesh_in(
    bytes: &[u8],
    path: &Path,
    format: Option<Format>,
    options: Options,
) -> Result<(Triangles, Format), String> {
    let named = |error: Error| format!("{}: {error}", name_of(path));
    let bytes = onering_io::unpacked(bytes).map_err(named)?;
    let Some(found) = format.or_else(|| Format::of(path, &bytes)) else {
        let hint = if is_standard(path) { " (or say --from)" } else { "" };
        return Err(named(Error::UnknownFormat { path: None }) + hint);
    };
    let mesh = match format {
        _ if found == Format::Ring => File::from_bytes(&bytes).and_then(|file| ring::triangles(&file)),
        None if !is_standard(path) => {
            return match options.read_at(&bytes, path) {
                Ok(mesh) => Ok((mesh, found)),
                Err(error) => Err(error.to_string()),
            };
        }
        _ => options.read_as(&bytes, found),
    };
    Ok((mesh.map_err(named)?, found))
}

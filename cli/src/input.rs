//! Meshes from files, and from standard input where the name is `-`.

use crate::convert::ring::is_packed;
use onering::ring;
use onering_io::{Format, Options, Triangles};
use std::io::{self, Read};
use std::path::Path;

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

/// The mesh in the bytes of a file, or of standard input, which are of this format where one is given. Only a file
/// whose format is told by the file itself may refer to others beside it.
///
/// # Errors
/// A line that names the file, and the place in it.
pub(crate) fn mesh_in(
    bytes: &[u8],
    path: &Path,
    format: Option<Format>,
    options: Options,
) -> Result<Triangles, String> {
    let named = |error: onering_io::Error| format!("{}: {error}", name_of(path));
    if format_of(bytes, path, format) == Some(Format::Ring) {
        if is_packed(path) && !bytes.starts_with(&onering_io::ring::MAGIC) {
            return Err(format!("{}: a .ring file is not read packed: unpack it first", name_of(path)));
        }
        return ring::File::from_bytes(bytes).and_then(|file| ring::triangles(&file)).map_err(named);
    }
    match format {
        Some(format) => options.read_as(bytes, format).map_err(named),
        None if is_standard(path) => options.read(bytes).map_err(named),
        None => options.read_at(bytes, path).map_err(|error| error.to_string()),
    }
}

/// The format that [`mesh_in`] takes the bytes for; `None` also where that shows only once they are unpacked.
pub(crate) fn format_of(bytes: &[u8], path: &Path, format: Option<Format>) -> Option<Format> {
    format.or_else(|| Format::of(path, bytes))
}

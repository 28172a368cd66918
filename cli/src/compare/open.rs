//! Files of results: opened before the work, for one that cannot be written is better known then than after it.

use crate::failure::Failure;
use onering_io::Replacement;
use std::io::Write;
use std::path::Path;

/// A file that is ready to be written, and its name.
pub(super) type Open<'a> = Option<(&'a Path, Replacement)>;

pub(super) fn open(path: Option<&Path>) -> Result<Open<'_>, Failure> {
    let Some(path) = path else { return Ok(None) };
    match Replacement::create(path) {
        Ok(file) => Ok(Some((path, file))),
        Err(error) => Err(Failure::Usage(format!("{}: {error}", path.display()))),
    }
}

pub(super) fn finish(open: Open<'_>, text: &str) -> Result<(), Failure> {
    let Some((path, mut file)) = open else { return Ok(()) };
    let written = file.write_all(text.as_bytes()).and_then(|()| file.finish());
    written.map_err(|error| Failure::Output(format!("{}: {error}", path.display())))
}

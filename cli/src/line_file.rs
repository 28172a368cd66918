//! Files of lines and points.

use crate::failure::Failure;
use onering_io::{Error, Lines};
use std::path::Path;

/// Refuses a name that tells no format for lines, which is better known before the work than after it.
pub(crate) fn check_name(path: Option<&Path>) -> Result<(), Failure> {
    match path.map(|path| (path, Lines::format_of(path))) {
        Some((path, Err(Error::UnknownFormat { .. }))) => Err(Failure::Usage(format!(
            "{}: its name tells no format; lines and points are written as .obj and .ply",
            path.display()
        ))),
        Some((_, Err(error))) => Err(Failure::Usage(error.to_string())),
        _ => Ok(()),
    }
}

/// Writes them.
pub(crate) fn save(lines: &Lines, path: &Path) -> Result<(), Failure> {
    lines.save(path).map_err(|error| Failure::Output(error.to_string()))
}

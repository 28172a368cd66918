//! Files of lines and points.

use crate::failure::Failure;
use onering_io::Lines;
use std::path::Path;

/// Refuses a name that tells no format for lines, which is better known before the work than after it.
pub(crate) fn check_name(path: Option<&Path>) -> Result<(), Failure> {
    let format = path.map(Lines::format_of).transpose();
    format.map(|_| ()).map_err(|error| Failure::Usage(error.to_string()))
}

/// Writes them.
pub(crate) fn save(lines: &Lines, path: &Path) -> Result<(), Failure> {
    lines.save(path).map_err(|error| Failure::Output(error.to_string()))
}

//! `.ring` files: a mesh in the arrays of one backend.

use super::failure::Failure;
use std::path::Path;

/// Whether the name is that of such a file.
pub(crate) fn is_named(path: &Path) -> bool {
    path.extension().is_some_and(|end| end.eq_ignore_ascii_case("ring"))
}

pub(crate) fn refusal(path: &Path) -> Failure {
    Failure::Usage(format!("{}: `.ring` files are not written by this version", path.display()))
}

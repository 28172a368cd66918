//! What is wrong with a file, before it is known which file it is.
use crate::BuildError;
use crate::columns::Invalid;
use alloc::{borrow::ToOwned, format, string::String};
use onering_io::{Error, Format, Place, Reason};
use std::path::Path;

/// What is wrong, and where.
#[derive(Debug)]
pub(super) enum Problem {
    /// At a byte, in the header or in a section.
    At { byte: usize, part: String, problem: String },
    /// An array has no room.
    OutOfMemory { bytes: usize },
}

/// A problem of the header.
pub(super) fn of_header(byte: usize, problem: impl Into<String>) -> Problem {
    Problem::At { byte, part: "header".to_owned(), problem: problem.into() }
}

/// A problem of the section `name`.
pub(super) fn of_section(name: &str, byte: usize, problem: impl Into<String>) -> Problem {
    Problem::At { byte, part: format!("section `{name}`"), problem: problem.into() }
}

impl Problem {
    /// What is wrong with columns, where `place` is the first byte and the element size of each.
    pub(super) fn of(invalid: &Invalid, place: impl Fn(&str) -> (usize, usize)) -> Self {
        match invalid {
            Invalid::Missing { column } => of_section(column, 0, "is missing"),
            Invalid::Column { column, problem } => of_section(column, place(column).0, *problem),
            Invalid::Element { column, index, problem } => {
                let (start, size) = place(column);
                of_section(column, start + index * size, format!("element {index} {problem}"))
            }
            Invalid::Build(BuildError::OutOfMemory { bytes }) => Self::OutOfMemory { bytes: *bytes },
            Invalid::Build(error) => of_header(24, format!("{error}")),
        }
    }

    /// The error of the file at `path`, where it is known.
    pub(super) fn error(self, path: Option<&Path>) -> Error {
        let path = path.map(Path::to_owned);
        match self {
            Self::At { byte, part, problem } => Error::Malformed {
                format: Format::Ring,
                path,
                place: Place::Byte(byte),
                reason: Reason::Ring { part, problem },
            },
            Self::OutOfMemory { bytes } => Error::OutOfMemory { path, bytes },
        }
    }
}

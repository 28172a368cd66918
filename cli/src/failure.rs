//! How a command can fail, and what that means for the end of the run.

use crate::output::{self, Status};
use onering_io::Error;
use std::io;

/// Why nothing was made.
#[derive(Debug)]
pub(crate) enum Failure {
    /// What was asked for makes no sense.
    Usage(String),
    /// The mesh could not be read.
    Input(String),
    /// The mesh could not be made, or written to its file.
    Output(String),
    /// Standard output failed; nobody may be there any more to read it.
    Standard(io::Error),
}

impl Failure {
    /// What became of an attempt to write to standard output.
    pub(crate) fn of_standard_output(error: Error) -> Self {
        match error {
            Error::Write { source, .. } => Self::Standard(source),
            other => Self::Output(format!("standard output: {other}")),
        }
    }

    /// Says so; how the run ends then.
    pub(crate) fn end(self) -> io::Result<Status> {
        let (message, status) = match self {
            Self::Standard(error) => return Err(error),
            Self::Usage(message) | Self::Input(message) => (message, Status::Nothing),
            Self::Output(message) => (message, Status::Partly),
        };
        output::complain(&message);
        Ok(status)
    }
}

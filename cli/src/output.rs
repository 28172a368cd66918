//! How a run ends, and what goes to the terminal.

use onering_io::one_line;
use std::io::{self, Write};
use std::process::ExitCode;

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Status {
    /// All was done: 0.
    Done,
    /// Some files could not be read, or some answers were wrong: 1.
    Partly,
    /// No file could be read: 2, as for wrong usage.
    Nothing,
}

impl From<Status> for ExitCode {
    fn from(status: Status) -> Self {
        ExitCode::from(status as u8)
    }
}

impl Status {
    /// The status after so many files were read and so many were not.
    pub(crate) fn of(read: usize, unread: usize) -> Self {
        match (read, unread) {
            (_, 0) => Self::Done,
            (0, _) => Self::Nothing,
            _ => Self::Partly,
        }
    }
}

/// One line on standard error. A name with a line break in it does not make two.
pub(crate) fn complain(message: &str) {
    // Where standard error is closed, nobody is left to be told.
    let _ = writeln!(io::stderr(), "onering: {}", one_line(message));
}

/// Lines on standard error that are no complaint.
pub(crate) fn tell(lines: &str) {
    let text: String = lines.lines().map(|line| one_line(line) + "\n").collect();
    let _ = io::stderr().write_all(text.as_bytes());
}

/// Writes to standard output at once, so that what is done is seen while the rest is under way.
pub(crate) fn print(text: &str) -> io::Result<()> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes())?;
    out.flush()
}

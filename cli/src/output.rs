//! How a run ends, what goes to the terminal, and files that appear whole or not at all.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
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
    let line: String = message.chars().map(|c| if c.is_control() { '\u{fffd}' } else { c }).collect();
    // Where standard error is closed, nobody is left to be told.
    let _ = writeln!(io::stderr(), "onering: {line}");
}

/// Writes to standard output at once, so that what is done is seen while the rest is under way.
pub(crate) fn print(text: &str) -> io::Result<()> {
    let mut out = io::stdout().lock();
    out.write_all(text.as_bytes())?;
    out.flush()
}

/// A file that is written beside its name and renamed at the end: whoever reads it never sees half of it, and
/// what was there stays if this run fails.
#[derive(Debug)]
pub(crate) struct Replacement {
    file: File,
    /// `None` where the name is no regular file, such as a pipe, which has to be written to directly.
    beside: Option<PathBuf>,
    target: PathBuf,
}

impl Replacement {
    /// Fails where the file could not be written, before there is something to write.
    pub(crate) fn create(path: &Path) -> io::Result<Self> {
        // A link stays one: what it leads to is replaced.
        let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
        match fs::metadata(&target) {
            Ok(found) if !found.is_file() => {
                let file = File::options().write(true).open(&target)?;
                Ok(Self { file, beside: None, target })
            }
            _ => {
                let beside = name_beside(&target)?;
                let file = File::options().write(true).create_new(true).open(&beside)?;
                Ok(Self { file, beside: Some(beside), target })
            }
        }
    }

    /// Writes everything and takes the place of the old file.
    pub(crate) fn finish(mut self, bytes: &[u8]) -> io::Result<()> {
        self.file.write_all(bytes)?;
        if let Some(beside) = &self.beside {
            self.file.sync_all()?;
            fs::rename(beside, &self.target)?;
            self.beside = None;
        }
        Ok(())
    }
}

/// Leaves nothing behind where the run ended early.
impl Drop for Replacement {
    fn drop(&mut self) {
        if let Some(beside) = &self.beside {
            let _ = fs::remove_file(beside);
        }
    }
}

fn name_beside(target: &Path) -> io::Result<PathBuf> {
    let name = target.file_name().ok_or(io::ErrorKind::InvalidInput)?;
    let mut hidden = OsString::from(".");
    hidden.push(name);
    hidden.push(format!(".{}.tmp", std::process::id()));
    Ok(target.with_file_name(hidden))
}

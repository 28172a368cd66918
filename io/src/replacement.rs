//! Files that appear whole or not at all.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// A file that is written beside its name and renamed at the end: whoever reads it never sees half of it, and what
/// was there stays if this run fails. A pipe or a device has no name to take, and is written to directly.
///
/// Dropped before [`finish`](Self::finish), it leaves nothing behind.
#[derive(Debug)]
pub struct Replacement {
    file: File,
    /// `None` where the name is no regular file, such as a pipe, which has to be written to directly.
    beside: Option<PathBuf>,
    target: PathBuf,
}

impl Replacement {
    /// Opens a new file beside `path`. A link stays one: what it leads to is replaced.
    ///
    /// # Errors
    /// Where the file could not be written, before there is something to write.
    pub fn create(path: &Path) -> io::Result<Self> {
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

    /// Has all of it on the disk, and takes the place of the old file.
    ///
    /// # Errors
    /// Where the disk is full or the name cannot be taken; the old file is still there then.
    pub fn finish(mut self) -> io::Result<()> {
        if let Some(beside) = &self.beside {
            self.file.sync_all()?;
            fs::rename(beside, &self.target)?;
            self.beside = None;
        }
        Ok(())
    }
}

impl Write for Replacement {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

impl Drop for Replacement {
    fn drop(&mut self) {
        if let Some(beside) = &self.beside {
            let _ = fs::remove_file(beside);
        }
    }
}

/// A name that no other file of this or another process has.
fn name_beside(target: &Path) -> io::Result<PathBuf> {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let name = target.file_name().ok_or(io::ErrorKind::InvalidInput)?;
    let mut hidden = OsString::from(".");
    hidden.push(name);
    hidden.push(format!(".{}-{}.tmp", std::process::id(), COUNT.fetch_add(1, Ordering::Relaxed)));
    Ok(target.with_file_name(hidden))
}

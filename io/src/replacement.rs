//! Files that appear whole or not at all.

use std::fs::{self, File, Metadata};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicUsize, Ordering};

/// A file that is written beside its name and renamed at the end: whoever reads it never sees half of it, and what
/// was there stays if this run fails. A pipe or a device has no name to take, and is written to directly.
///
/// The new file has the permissions of the old one, and on Unix its owner where the system allows that. Other hard
/// links of the old file keep the old content. The last of two runs at once has the name in the end.
///
/// Dropped before [`finish`](Self::finish), it leaves nothing behind, nor does a panic; a process that is killed may
/// leave a file `.onering-*.tmp`.
#[derive(Debug)]
pub struct Replacement {
    file: File,
    /// `None` where the name is no regular file, such as a pipe, which has to be written to directly.
    beside: Option<PathBuf>,
    target: PathBuf,
}

impl Replacement {
    /// Opens a new file beside `path`. A link stays one: what it leads to is replaced, or made.
    ///
    /// # Errors
    /// Where the file could not be written, before there is something to write: a folder that is not there or may
    /// not be written to, a directory of this name, an old file that may not be written to, or one that is named as an
    /// open file, such as `/dev/stdout` where that was redirected: what others wrote to it would be lost.
    pub fn create(path: &Path) -> io::Result<Self> {
        match fs::metadata(path) {
            Ok(old) if old.is_dir() => {
                Err(io::Error::new(io::ErrorKind::IsADirectory, "this is a directory, not a file"))
            }
            Ok(old) if !old.is_file() => {
                let file = File::options().write(true).open(path)?;
                Ok(Self { file, beside: None, target: path.to_owned() })
            }
            Ok(_) if is_descriptor(path)? => Err(io::Error::new(
                io::ErrorKind::InvalidInput,
                "this is an open file by another name, which others write to as well: it is not replaced",
            )),
            Ok(old) => {
                let target = fs::canonicalize(path)?;
                // Renaming asks for no right to the old file, but who made it read-only meant it.
                File::options().write(true).open(&target)?;
                let new = Self::beside(target)?;
                // Before there is content that others should not see.
                new.take_after(&old)?;
                Ok(new)
            }
            Err(error) if error.kind() == io::ErrorKind::NotFound => Self::beside(end_of_links(path)?),
            Err(error) => Err(error),
        }
    }

    fn beside(target: PathBuf) -> io::Result<Self> {
        if target.file_name().is_none() {
            return Err(io::Error::new(io::ErrorKind::InvalidInput, "this is not the name of a file"));
        }
        loop {
            let beside = name_beside(&target);
            match File::options().write(true).create_new(true).open(&beside) {
                Ok(file) => return Ok(Self { file, beside: Some(beside), target }),
                // Left by a process that was killed and had the same number, as the first one of a container has.
                Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {}
                Err(error) => return Err(error),
            }
        }
    }

    /// Permissions and owner of the old file.
    fn take_after(&self, old: &Metadata) -> io::Result<()> {
        #[cfg(unix)]
        {
            use std::os::unix::fs::{MetadataExt, fchown};
            // Only the superuser may give files away; others keep what they make.
            let _ = fchown(&self.file, Some(old.uid()), Some(old.gid()));
        }
        self.file.set_permissions(old.permissions())
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
            sync_folder(&self.target);
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

/// Where links lead to whose end does not exist yet. The system has found that they are no circle.
fn end_of_links(path: &Path) -> io::Result<PathBuf> {
    let mut end = path.to_owned();
    while let Some(next) = next_link(&end)? {
        end = next;
    }
    Ok(end)
}

/// Whether the path leads through the list of a process's open files, as `/dev/stdout` and `/dev/fd/1` do. What stands
/// there looks like a link, but is the open file itself.
fn is_descriptor(path: &Path) -> io::Result<bool> {
    let mut at = Some(path.to_owned());
    while let Some(path) = at {
        let folder = path.parent().map(fs::canonicalize);
        if folder.is_some_and(|folder| folder.is_ok_and(|folder| folder.starts_with("/proc"))) {
            return Ok(true);
        }
        at = next_link(&path)?;
    }
    Ok(false)
}

/// What the link at this path says; `None` where it is none.
fn next_link(path: &Path) -> io::Result<Option<PathBuf>> {
    if !path.is_symlink() {
        return Ok(None);
    }
    let mut next = path.to_owned();
    // A relative one starts from the folder that it is in.
    next.pop();
    next.push(fs::read_link(path)?);
    Ok(Some(next))
}

/// A name that no other file of this process has. It does not grow with the target's, which may be as long as names
/// can be.
fn name_beside(target: &Path) -> PathBuf {
    static COUNT: AtomicUsize = AtomicUsize::new(0);
    let count = COUNT.fetch_add(1, Ordering::Relaxed);
    target.with_file_name(format!(".onering-{}-{count}.tmp", std::process::id()))
}

/// Has the new name on the disk too. Where that fails, the new file is in its place all the same, so there is no
/// error to tell: some file systems cannot do it.
#[cfg(unix)]
fn sync_folder(target: &Path) {
    let folder = target.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let _ = File::open(folder).and_then(|folder| folder.sync_all());
}

/// Other systems do not open folders as files.
#[cfg(not(unix))]
fn sync_folder(_: &Path) {}

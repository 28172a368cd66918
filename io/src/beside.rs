//! Opening a file that another file names, only where it lies in the same folder.

use std::borrow::Cow;
use std::fs::File;
use std::io::{self, Read};
use std::path::{Path, PathBuf};

/// Why a reference was not read.
#[derive(Debug)]
pub(crate) enum Refusal {
    /// The reference is not one to a file in the folder.
    Uri(&'static str),
    /// The file could not be opened or read.
    Io(PathBuf, io::Error),
}

/// A file in the folder.
pub(crate) struct Found {
    /// As the folder and the reference say it, for errors.
    path: PathBuf,
    /// Without links, the same however the reference is spelt.
    pub(crate) real: PathBuf,
}

/// The first `limit` bytes of the file that `uri` names, as [`find`] finds it.
#[cfg(feature = "tobj")]
pub(crate) fn read(folder: &Path, uri: &str, limit: u64) -> Result<Vec<u8>, Refusal> {
    find(folder, uri)?.read(limit)
}

/// The file that `uri` names in `folder` or below it.
///
/// Hostile files name `/etc/passwd`, `../../secret` or `http://...`: only plain relative names are
/// followed, and no link that leads out of the folder.
pub(crate) fn find(folder: &Path, uri: &str) -> Result<Found, Refusal> {
    let name = percent_decoded(uri).ok_or(Refusal::Uri("bad percent encoding"))?;
    check_name(&name).map_err(Refusal::Uri)?;
    let path = folder.join(&*name);
    let io = |source| Refusal::Io(path.clone(), source);
    let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
    let real = path.canonicalize().map_err(io)?;
    if !real.starts_with(folder.canonicalize().map_err(io)?) {
        return Err(Refusal::Uri("it leads out of the folder"));
    }
    // A pipe or a device would be read for ever.
    if !path.metadata().map_err(io)?.is_file() {
        return Err(Refusal::Uri("it is not a regular file"));
    }
    Ok(Found { path, real })
}

impl Found {
    /// The first `limit` bytes.
    pub(crate) fn read(&self, limit: u64) -> Result<Vec<u8>, Refusal> {
        let mut bytes = Vec::new();
        let read = File::open(&self.path).and_then(|file| file.take(limit).read_to_end(&mut bytes));
        read.map_err(|source| Refusal::Io(self.path.clone(), source))?;
        Ok(bytes)
    }
}

/// Bytes that a name may have: most file systems allow no more.
const NAME: usize = 255;

fn check_name(name: &str) -> Result<(), &'static str> {
    // `:` covers schemes and Windows drives, `\` Windows folders; errors print names as they are.
    if name.is_empty() || name.contains([':', '\\']) || name.contains(char::is_control) {
        return Err("only plain relative file names are");
    }
    if name.len() > NAME {
        return Err("names of more than 255 bytes are not");
    }
    if name.starts_with('/') {
        return Err("absolute paths are not");
    }
    if name.split('/').any(|part| part == "..") {
        return Err("it climbs out of the folder");
    }
    Ok(())
}

fn percent_decoded(uri: &str) -> Option<Cow<'_, str>> {
    if !uri.contains('%') {
        return Some(uri.into());
    }
    let mut out = Vec::with_capacity(uri.len());
    let mut rest = uri.as_bytes();
    while let Some((&byte, tail)) = rest.split_first() {
        let (decoded, tail) = match (byte, tail) {
            (b'%', [high, low, tail @ ..]) => (hex(*high)? << 4 | hex(*low)?, tail),
            (b'%', _) => return None,
            _ => (byte, tail),
        };
        out.push(decoded);
        rest = tail;
    }
    String::from_utf8(out).ok().map(Cow::Owned)
}

fn hex(digit: u8) -> Option<u8> {
    char::from(digit).to_digit(16).map(|value| value as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_stay_in_the_folder_pass() {
        for name in ["a.bin", "sub/a.bin", "a..b.bin", "./a.bin"] {
            assert_eq!(check_name(name), Ok(()), "{name}");
        }
    }

    #[test]
    fn names_that_leave_the_folder_do_not() {
        for name in
            ["", "/etc/passwd", "../a", "a/../../b", "http://x/y", "file:a", "C:a", "..\\a", "a\0", "\x1b[2J"]
        {
            assert!(check_name(name).is_err(), "{name}");
        }
    }

    #[test]
    fn percent_encoding_is_undone_before_the_check() {
        assert_eq!(percent_decoded("a%20b.bin").as_deref(), Some("a b.bin"));
        assert_eq!(percent_decoded("%2e%2E/x").as_deref(), Some("../x"));
        for broken in ["%", "%4", "%zz", "%ff"] {
            assert_eq!(percent_decoded(broken), None, "{broken}");
        }
    }
}

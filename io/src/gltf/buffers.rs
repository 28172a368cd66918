//! The bytes of each buffer: from the BIN chunk, a data URI, or a file in the document's folder.

use std::borrow::Cow;
use std::collections::{BTreeSet, HashMap};
use std::path::{Path, PathBuf};

use ::gltf::json::Buffer;
use base64::Engine;
use base64::engine::{DecodePaddingMode, GeneralPurpose, GeneralPurposeConfig};

use super::origin::BufferKind;
use crate::beside::{self, Refusal};
use crate::error::quote;
use crate::{Error, Format, Item, Place, Reason};

/// The buffers that were asked for so far; a buffer that no mesh uses is never read.
pub(super) struct Buffers<'a> {
    buffers: &'a [Buffer],
    format: Format,
    bin: Option<&'a [u8]>,
    folder: Option<&'a Path>,
    loaded: Vec<Option<Bytes<'a>>>,
    /// What was read of each file. Buffers that name the same file share it: a hostile document names a large
    /// one a thousand times.
    files: Vec<Vec<u8>>,
    file_of: HashMap<PathBuf, usize>,
}

/// The bytes of a buffer, or the number of the file that begins with them.
enum Bytes<'a> {
    Here(Cow<'a, [u8]>),
    File(usize),
}

impl<'a> Buffers<'a> {
    pub(super) fn new(
        buffers: &'a [Buffer],
        format: Format,
        bin: Option<&'a [u8]>,
        folder: Option<&'a Path>,
    ) -> Self {
        let loaded = buffers.iter().map(|_| None).collect();
        Self { buffers, format, bin, folder, loaded, files: Vec::new(), file_of: HashMap::new() }
    }

    pub(super) fn count(&self) -> usize {
        self.buffers.len()
    }

    /// Bytes of the files that were read so far; all other buffers are part of the document.
    pub(super) fn file_bytes(&self) -> u64 {
        self.files.iter().map(|file| file.len() as u64).sum()
    }

    /// The kinds of the buffers so far.
    pub(super) fn kinds(&self) -> BTreeSet<BufferKind> {
        let loaded = self.buffers.iter().zip(&self.loaded).filter(|(_, bytes)| bytes.is_some());
        loaded.map(|(buffer, _)| BufferKind::of(buffer.uri.as_deref())).collect()
    }

    /// Makes sure that the buffer is there, with all of its `byteLength`.
    pub(super) fn load(&mut self, i: usize) -> Result<(), Error> {
        if self.loaded[i].is_some() {
            return Ok(());
        }
        let bytes = self.fetch(i)?;
        let (needed, available) = (self.buffers[i].byte_length.0, self.all(&bytes).len() as u64);
        if available < needed {
            return Err(self.malformed(i, Reason::TooShort { item: Item::Buffer(i), needed, available }));
        }
        self.loaded[i] = Some(bytes);
        Ok(())
    }

    /// The bytes of a buffer after [`load`](Self::load).
    pub(super) fn bytes(&self, i: usize) -> &[u8] {
        // What follows is padding of the chunk, or belongs to another buffer.
        let bytes = self.loaded[i]
            .as_ref()
            .and_then(|bytes| self.all(bytes).get(..self.buffers[i].byte_length.0 as usize));
        bytes.unwrap_or_default()
    }

    fn all<'b>(&'b self, bytes: &'b Bytes<'a>) -> &'b [u8] {
        match bytes {
            Bytes::Here(bytes) => bytes,
            Bytes::File(file) => &self.files[*file],
        }
    }

    fn fetch(&mut self, i: usize) -> Result<Bytes<'a>, Error> {
        let buffers: &'a [Buffer] = self.buffers;
        let Some(uri) = buffers[i].uri.as_deref() else {
            return self.chunk(i).map(|chunk| Bytes::Here(chunk.into()));
        };
        let refuse = |buffers: &Self, problem| {
            buffers.malformed(i, Reason::Uri { uri: quote(uri.as_bytes()), problem })
        };
        if let Some(data) = data_of(uri) {
            let decoded = decode(data).map_err(|problem| refuse(self, problem))?;
            return Ok(Bytes::Here(decoded.into()));
        }
        let folder =
            self.folder.ok_or_else(|| refuse(self, "bytes in memory have no folder to find it in"))?;
        self.file(folder, uri, buffers[i].byte_length.0).map(Bytes::File).map_err(|refusal| match refusal {
            Refusal::Uri(problem) => refuse(self, problem),
            Refusal::Io(path, source) => Error::Io { path, named_in: None, source },
        })
    }

    /// The number of a file, of which `needed` bytes are read if it has as many.
    fn file(&mut self, folder: &Path, uri: &str, needed: u64) -> Result<usize, Refusal> {
        let found = beside::find(folder, uri)?;
        match self.file_of.get(&found.real) {
            None => {
                self.files.push(found.read(needed)?);
                self.file_of.insert(found.real, self.files.len() - 1);
                Ok(self.files.len() - 1)
            }
            Some(&file) => {
                if (self.files[file].len() as u64) < needed {
                    // As much as any buffer may need: no file is read a third time.
                    let most = self.buffers.iter().map(|buffer| buffer.byte_length.0).max();
                    self.files[file] = Vec::new();
                    self.files[file] = found.read(most.unwrap_or(needed))?;
                }
                Ok(file)
            }
        }
    }

    /// The BIN chunk, which only the first buffer may stand for.
    fn chunk(&self, i: usize) -> Result<&'a [u8], Error> {
        let problem = "it has no uri, and there is no BIN chunk for it";
        let missing = || self.malformed(i, Reason::BadItem { item: Item::Buffer(i), problem });
        self.bin.filter(|_| i == 0).ok_or_else(missing)
    }

    fn malformed(&self, i: usize, reason: Reason) -> Error {
        Error::malformed(self.format, Place::Buffer(i), reason)
    }
}

/// What follows `data:` in a data URI; schemes are the same in upper and lower case.
pub(super) fn data_of(uri: &str) -> Option<&str> {
    uri.split_once(':').filter(|(scheme, _)| scheme.eq_ignore_ascii_case("data")).map(|(_, data)| data)
}

/// The bytes of a data URI behind `data:`.
fn decode(data: &str) -> Result<Vec<u8>, &'static str> {
    let (kind, text) = data.split_once(',').ok_or("the data URI has no comma")?;
    if !kind.rsplit_once(';').is_some_and(|(_, encoding)| encoding.eq_ignore_ascii_case("base64")) {
        return Err("only data URIs in base64 are read");
    }
    let padding = GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent);
    let base64 = GeneralPurpose::new(&base64::alphabet::STANDARD, padding);
    base64.decode(text.trim_ascii()).map_err(|_| "the data URI is not base64")
}

//! The bytes of each buffer: from the BIN chunk, a data URI, or a file in the document's folder.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::path::Path;

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
    loaded: Vec<Option<Cow<'a, [u8]>>>,
    loaded_bytes: u64,
}

impl<'a> Buffers<'a> {
    pub(super) fn new(
        buffers: &'a [Buffer],
        format: Format,
        bin: Option<&'a [u8]>,
        folder: Option<&'a Path>,
    ) -> Self {
        let loaded = buffers.iter().map(|_| None).collect();
        Self { buffers, format, bin, folder, loaded, loaded_bytes: 0 }
    }

    pub(super) fn count(&self) -> usize {
        self.buffers.len()
    }

    /// Bytes of the buffers so far.
    pub(super) fn loaded_bytes(&self) -> u64 {
        self.loaded_bytes
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
        let mut bytes = self.fetch(i)?;
        let (needed, available) = (self.buffers[i].byte_length.0, bytes.len() as u64);
        if available < needed {
            return Err(self.malformed(i, Reason::TooShort { item: Item::Buffer(i), needed, available }));
        }
        // What follows is padding of the chunk.
        match &mut bytes {
            Cow::Borrowed(bytes) => *bytes = &bytes[..needed as usize],
            Cow::Owned(bytes) => bytes.truncate(needed as usize),
        }
        self.loaded_bytes += needed;
        self.loaded[i] = Some(bytes);
        Ok(())
    }

    /// The bytes of a buffer after [`load`](Self::load).
    pub(super) fn bytes(&self, i: usize) -> &[u8] {
        self.loaded[i].as_deref().unwrap_or_default()
    }

    fn fetch(&self, i: usize) -> Result<Cow<'a, [u8]>, Error> {
        let refuse =
            |uri: &str, problem| self.malformed(i, Reason::Uri { uri: quote(uri.as_bytes()), problem });
        let buffers: &'a [Buffer] = self.buffers;
        let Some(uri) = buffers[i].uri.as_deref() else {
            return self.chunk(i).map(Cow::Borrowed);
        };
        if let Some(data) = uri.strip_prefix("data:") {
            return decode(data).map(Cow::Owned).map_err(|problem| refuse(uri, problem));
        }
        let folder =
            self.folder.ok_or_else(|| refuse(uri, "bytes in memory have no folder to find it in"))?;
        beside::read(folder, uri, buffers[i].byte_length.0).map(Cow::Owned).map_err(|refusal| match refusal {
            Refusal::Uri(problem) => refuse(uri, problem),
            Refusal::Io(path, source) => Error::Io { path, named_in: None, source },
        })
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

/// The bytes of a data URI behind `data:`.
fn decode(data: &str) -> Result<Vec<u8>, &'static str> {
    let (kind, text) = data.split_once(',').ok_or("the data URI has no comma")?;
    if !kind.ends_with(";base64") {
        return Err("only data URIs in base64 are read");
    }
    let padding = GeneralPurposeConfig::new().with_decode_padding_mode(DecodePaddingMode::Indifferent);
    let base64 = GeneralPurpose::new(&base64::alphabet::STANDARD, padding);
    base64.decode(text.trim_ascii()).map_err(|_| "the data URI is not base64")
}

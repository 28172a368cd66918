//! The GLB container: a header of 12 bytes, then chunks.

use super::MAGIC;
use crate::{Error, Format, Item, Place, Reason};

/// What a GLB holds.
pub(super) struct Parts<'a> {
    pub(super) json: &'a [u8],
    pub(super) bin: Option<&'a [u8]>,
}

/// The first JSON and the first BIN chunk; other kinds of chunks are skipped, as the standard asks.
pub(super) fn split(bytes: &[u8]) -> Result<Parts<'_>, Error> {
    let body = body(bytes)?;
    let (mut at, mut json, mut bin) = (HEADER, None, None);
    for number in 0.. {
        let Some((header, data)) = body[at..].split_at_checked(8) else { break };
        let length = u32_at(header, 0) as usize;
        let chunk =
            data.get(..length).ok_or_else(|| too_short(at, Item::Chunk(number), length, data.len()))?;
        match &header[4..] {
            b"JSON" => json = json.or(Some(chunk)),
            b"BIN\0" => bin = bin.or(Some(chunk)),
            _ => {}
        }
        at += 8 + length;
    }
    let json =
        json.ok_or_else(|| malformed(HEADER, Reason::NotThisFormat { expected: "a GLB with a JSON chunk" }))?;
    Ok(Parts { json, bin })
}

const HEADER: usize = 12;

/// The bytes up to the length that the header claims.
fn body(bytes: &[u8]) -> Result<&[u8], Error> {
    if !bytes.starts_with(MAGIC) {
        return Err(malformed(0, Reason::NotThisFormat { expected: "a GLB: it does not begin with `glTF`" }));
    }
    if bytes.len() < HEADER {
        return Err(too_short(0, Item::Header, HEADER, bytes.len()));
    }
    let (version, length) = (u32_at(bytes, 4), u32_at(bytes, 8) as usize);
    if version != 2 {
        return Err(malformed(4, Reason::Version { version: version.to_string() }));
    }
    if length < HEADER {
        return Err(too_short(8, Item::Header, HEADER, length));
    }
    bytes.get(..length).ok_or_else(|| too_short(8, Item::File, length, bytes.len()))
}

fn u32_at(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(std::array::from_fn(|i| bytes[at + i]))
}

fn too_short(at: usize, item: Item, needed: usize, available: usize) -> Error {
    malformed(at, Reason::TooShort { item, needed: needed as u64, available: available as u64 })
}

fn malformed(at: usize, reason: Reason) -> Error {
    Error::malformed(Format::Glb, Place::Byte(at), reason)
}

//! Files packed with gzip (RFC 1952).

use std::borrow::Cow;
use std::io::Read;

use flate2::read::MultiGzDecoder;

use crate::Error;
use crate::memory::reserve;

/// What every gzip file begins with, and the one method of compression that there is.
const MAGIC: &[u8] = &[0x1F, 0x8B, 8];

/// Meshes shrink to a quarter, flat binary ones to a twentieth. What grows by more than this, and beyond
/// [`SMALL`], was made to fill memory: gzip can pack 1000 to 1.
const MOST_GROWTH: usize = 100;
const SMALL: usize = 16 << 20;

/// The bytes themselves, or what is packed in them by gzip. Every reader of this crate begins with this; what is
/// unpacked already stays as it is.
///
/// # Errors
/// [`Error::Gzip`] where they are damaged, or grow beyond all measure: to more than 100 times their size, and 16 MiB.
pub fn unpacked(bytes: &[u8]) -> Result<Cow<'_, [u8]>, Error> {
    if !is_packed(bytes) {
        return Ok(Cow::Borrowed(bytes));
    }
    let limit = bytes.len().saturating_mul(MOST_GROWTH).max(SMALL);
    let mut packed = MultiGzDecoder::new(bytes);
    let mut unpacked = Vec::new();
    let mut piece = [0; 1 << 16];
    loop {
        let length = packed.read(&mut piece).map_err(|source| damaged(source.to_string()))?;
        if length == 0 && unpacked.starts_with(MAGIC) {
            // Each time over it might grow by as much again.
            return Err(damaged("what is packed is itself packed with gzip".into()));
        }
        if length == 0 {
            return Ok(Cow::Owned(unpacked));
        }
        if unpacked.len() + length > limit {
            return Err(damaged(format!("it unpacks to more than {limit} bytes, out of all proportion")));
        }
        reserve(&mut unpacked, length)?;
        unpacked.extend_from_slice(&piece[..length]);
    }
}

/// Whether a file that begins like this is packed.
pub(crate) fn is_packed(start: &[u8]) -> bool {
    start.starts_with(MAGIC)
}

fn damaged(problem: String) -> Error {
    Error::Gzip { path: None, problem }
}

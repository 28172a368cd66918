//! The layout of a file, written apart from the library: what a file is made of, and checksums for one that was changed.
use twox_hash::XxHash3_64;

/// Where a section says of itself what it is.
pub(crate) struct Section {
    /// The first byte of its entry in the table.
    pub(crate) entry: usize,
    pub(crate) name: String,
    pub(crate) offset: usize,
    pub(crate) length: usize,
}

pub(crate) fn u32_at(bytes: &[u8], at: usize) -> u32 {
    u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap())
}

fn u64_at(bytes: &[u8], at: usize) -> usize {
    u64::from_le_bytes(bytes[at..at + 8].try_into().unwrap()) as usize
}

pub(crate) fn sections(bytes: &[u8]) -> Vec<Section> {
    let section = |i: usize| {
        let entry = 128 + 64 * i;
        let name = bytes[entry..entry + 24].iter().take_while(|&&byte| byte != 0);
        Section {
            entry,
            name: name.map(|&byte| byte as char).collect(),
            offset: u64_at(bytes, entry + 32),
            length: u64_at(bytes, entry + 40),
        }
    };
    (0..u32_at(bytes, 40) as usize).map(section).collect()
}

/// Gives a file whose sections were changed the checksums that belong to them.
pub(crate) fn seal(bytes: &mut [u8]) {
    for section in sections(bytes) {
        let hash = XxHash3_64::oneshot(&bytes[section.offset..section.offset + section.length]);
        bytes[section.entry + 48..section.entry + 56].copy_from_slice(&hash.to_le_bytes());
    }
    seal_head(bytes);
}

/// The same where only the head was changed.
pub(crate) fn seal_head(bytes: &mut [u8]) {
    let end = 128 + 64 * u32_at(bytes, 40) as usize;
    let hash = XxHash3_64::oneshot(&bytes[..end]);
    bytes[end..end + 8].copy_from_slice(&hash.to_le_bytes());
}

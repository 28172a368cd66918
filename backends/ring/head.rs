//! The head of a file: what it is, and where its sections are.
use super::problem::{Problem, of_header};
use alloc::{format, string::String, vec::Vec};
use bytemuck::{Pod, Zeroable};
use core::ops::Range;
use onering_io::ring::MAGIC;

/// The version of the format that is written and read.
pub const VERSION: u32 = 1;

/// Sections begin at multiples of this.
pub(super) const ALIGNMENT: usize = 64;

/// More sections than any structure has with all that may be kept beside it.
const MAX_SECTIONS: usize = 64;

/// `0x01020304` in the byte order of the file.
const BYTE_ORDER: u32 = 0x0102_0304;

#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
struct RawHeader {
    magic: [u8; 8],
    version: u32,
    byte_order: u32,
    file_length: u64,
    vertices: u64,
    faces: u64,
    sections: u32,
    zero: u32,
    backend: [u8; 64],
    zeros: [u8; 16],
}

#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C)]
struct RawSection {
    name: [u8; 24],
    element_size: u32,
    zero: u32,
    offset: u64,
    length: u64,
    checksum: u64,
    zeros: u64,
}

pub(super) const HEADER: usize = size_of::<RawHeader>();
const SECTION: usize = size_of::<RawSection>();
const _: () = assert!(HEADER == 128 && SECTION == 64 && SECTION == ALIGNMENT);

/// What the head says, in terms of this machine.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Head {
    pub(super) backend: String,
    pub(super) vertices: usize,
    pub(super) faces: usize,
    pub(super) sections: Vec<Section>,
}

/// One array of the file.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Section {
    pub(super) name: String,
    pub(super) element_size: usize,
    pub(super) bytes: Range<usize>,
    pub(super) checksum: u64,
}

pub(super) fn checksum(bytes: &[u8]) -> u64 {
    twox_hash::XxHash3_64::oneshot(bytes)
}

/// The least multiple of [`ALIGNMENT`] that is not below `at`.
fn aligned(at: usize) -> Option<usize> {
    at.checked_next_multiple_of(ALIGNMENT)
}

/// Where the first section begins.
fn head_length(sections: usize) -> usize {
    HEADER + SECTION * sections + ALIGNMENT
}

/// Whether the first bytes of a file of this length can be those of a `.ring` file, and its number of sections. To be
/// asked before the rest is read.
pub(super) fn check_header(bytes: &[u8], file_length: u64) -> Result<usize, Problem> {
    if !bytes.starts_with(&MAGIC) {
        return Err(of_header(0, "this is no .ring file"));
    }
    let Some(header) = bytes.get(..HEADER) else {
        return Err(of_header(bytes.len(), "the file ends in its header"));
    };
    let header: RawHeader = bytemuck::pod_read_unaligned(header);
    if header.byte_order != BYTE_ORDER {
        return Err(of_header(12, "its numbers are not little-endian, or this machine's are not"));
    }
    if header.version != VERSION {
        let found = header.version;
        return Err(of_header(8, format!("it is of version {found}, and only {VERSION} is read")));
    }
    if header.file_length != file_length {
        let said = header.file_length;
        return Err(of_header(16, format!("the file should have {said} bytes, but has {file_length}")));
    }
    let sections = header.sections as usize;
    if sections > MAX_SECTIONS || head_length(sections) as u64 > file_length {
        return Err(of_header(40, format!("{sections} sections are too many")));
    }
    Ok(sections)
}

impl Head {
    /// The head of the file with these bytes; its sections lie one after the other, and end where the file does.
    pub(super) fn parse(bytes: &[u8]) -> Result<Self, Problem> {
        let sections = check_header(bytes, bytes.len() as u64)?;
        let end = HEADER + SECTION * sections;
        let (head, rest) = (&bytes[..end], &bytes[end..head_length(sections)]);
        if rest[..8] != checksum(head).to_le_bytes() || rest[8..].iter().any(|&byte| byte != 0) {
            return Err(of_header(end, "its checksum does not match"));
        }
        let header: RawHeader = bytemuck::pod_read_unaligned(&head[..HEADER]);
        let mut parsed = Self {
            backend: name(&header.backend).ok_or_else(|| of_header(48, "the structure has no name"))?,
            vertices: count(header.vertices).ok_or_else(|| of_header(24, "too many vertices"))?,
            faces: count(header.faces).ok_or_else(|| of_header(32, "too many faces"))?,
            sections: Vec::with_capacity(sections),
        };
        if header.zero != 0 || header.zeros != [0; 16] {
            return Err(of_header(44, "what should be 0 is not"));
        }
        let mut at = head_length(sections);
        for (i, raw) in head[HEADER..].chunks_exact(SECTION).enumerate() {
            let section = parsed.section(&bytemuck::pod_read_unaligned(raw), at, bytes.len());
            let section = section.map_err(|problem| of_header(HEADER + SECTION * i, problem))?;
            at = section.bytes.end;
            parsed.sections.push(section);
        }
        if at != bytes.len() {
            return Err(of_header(16, "there is something after the last section"));
        }
        Ok(parsed)
    }

    /// The section that begins after byte `after`.
    fn section(&self, raw: &RawSection, after: usize, file_length: usize) -> Result<Section, &'static str> {
        let name = name(&raw.name).ok_or("a section has no name")?;
        if self.sections.iter().any(|section| section.name == name) {
            return Err("two sections have the same name");
        }
        if raw.zero != 0 || raw.zeros != 0 {
            return Err("what should be 0 is not");
        }
        let start = aligned(after).filter(|&start| start as u64 == raw.offset);
        let start = start.ok_or("a section does not begin where the one before it ends")?;
        let end = usize::try_from(raw.length).ok().and_then(|length| start.checked_add(length));
        let end = end.filter(|&end| end <= file_length).ok_or("a section ends after the file")?;
        let element_size = raw.element_size as usize;
        if element_size == 0 || (end - start) % element_size != 0 {
            return Err("a section is not a whole number of elements");
        }
        Ok(Section { name, element_size, bytes: start..end, checksum: raw.checksum })
    }

    /// The section of this name.
    pub(super) fn named(&self, name: &str) -> Option<&Section> {
        self.sections.iter().find(|section| section.name == name)
    }

    /// The head as bytes, for sections with the given names, element sizes and contents; `None` where a name is not one
    /// that a file can have.
    pub(super) fn bytes(
        backend: &str,
        (vertices, faces): (usize, usize),
        contents: &[(&str, usize, &[u8])],
    ) -> Option<Vec<u8>> {
        let mut at = head_length(contents.len());
        let mut table = Vec::new();
        for (name, element_size, bytes) in contents {
            let offset = aligned(at)?;
            at = offset.checked_add(bytes.len())?;
            let raw = RawSection {
                name: padded(name)?,
                element_size: u32::try_from(*element_size).ok()?,
                zero: 0,
                offset: offset as u64,
                length: bytes.len() as u64,
                checksum: checksum(bytes),
                zeros: 0,
            };
            table.extend_from_slice(bytemuck::bytes_of(&raw));
        }
        let header = RawHeader {
            magic: MAGIC,
            version: VERSION,
            byte_order: BYTE_ORDER,
            file_length: at as u64,
            vertices: vertices as u64,
            faces: faces as u64,
            sections: u32::try_from(contents.len()).ok().filter(|&n| n as usize <= MAX_SECTIONS)?,
            zero: 0,
            backend: padded(backend)?,
            zeros: [0; 16],
        };
        let mut head = Vec::from(bytemuck::bytes_of(&header));
        head.extend(table);
        head.extend(checksum(&head).to_le_bytes());
        head.resize(head_length(contents.len()), 0);
        Some(head)
    }
}

/// At most as many as handles can name.
fn count(count: u64) -> Option<usize> {
    usize::try_from(count).ok().filter(|&count| count <= u32::MAX as usize)
}

/// Lower-case letters, digits, dashes and underscores, and then zeros.
fn name(bytes: &[u8]) -> Option<String> {
    let end = bytes.iter().position(|&byte| byte == 0).unwrap_or(bytes.len());
    let (name, zeros) = bytes.split_at(end);
    let is_padded = !name.is_empty() && zeros.iter().all(|&byte| byte == 0);
    let name = core::str::from_utf8(name).ok().filter(|name| is_padded && is_name(name))?;
    Some(name.into())
}

fn is_name(name: &str) -> bool {
    name.bytes().all(|byte| byte.is_ascii_lowercase() || byte.is_ascii_digit() || b"-_".contains(&byte))
}

/// A name as a file has it.
fn padded<const N: usize>(name: &str) -> Option<[u8; N]> {
    let mut bytes = [0; N];
    bytes
        .get_mut(..name.len())
        .filter(|_| !name.is_empty() && is_name(name))?
        .copy_from_slice(name.as_bytes());
    Some(bytes)
}

//! The bytes of a file in memory: in a buffer, or mapped.
use super::head::{self, ALIGNMENT};
use super::problem::Problem;
use alloc::boxed::Box;
use bytemuck::{Pod, Zeroable};
use std::fs::File;
use std::io::{self, Read};

/// So many bytes, where a section may begin.
#[derive(Clone, Copy, Pod, Zeroable)]
#[repr(C, align(64))]
pub(super) struct Block([u8; ALIGNMENT]);

/// The bytes of a file, the first at a multiple of [`ALIGNMENT`].
pub(super) enum Bytes {
    /// Read, with the number of them.
    Buffer(Box<[Block]>, usize),
    /// Mapped.
    #[cfg(feature = "mmap")]
    Map(memmap2::Mmap),
}

/// Why there are no bytes.
pub(super) enum Failed {
    System(io::Error),
    Problem(Problem),
}

impl From<io::Error> for Failed {
    fn from(error: io::Error) -> Self {
        Self::System(error)
    }
}

impl Bytes {
    fn zeros(length: usize) -> Result<(Box<[Block]>, usize), Problem> {
        let blocks = bytemuck::allocation::try_zeroed_slice_box(length.div_ceil(ALIGNMENT));
        Ok((blocks.map_err(|()| Problem::OutOfMemory { bytes: length })?, length))
    }

    /// A copy of these bytes.
    pub(super) fn copied(bytes: &[u8]) -> Result<Self, Problem> {
        let (mut blocks, length) = Self::zeros(bytes.len())?;
        bytemuck::cast_slice_mut(&mut blocks)[..length].copy_from_slice(bytes);
        Ok(Self::Buffer(blocks, length))
    }

    /// All bytes of a file, after a look at its header: of a foreign file no more is read.
    pub(super) fn read(mut file: &File) -> Result<Self, Failed> {
        let about = file.metadata()?;
        if !about.is_file() {
            return Err(io::Error::new(io::ErrorKind::InvalidInput, "this is no regular file").into());
        }
        let mut header = [0; head::HEADER];
        let mut begun = 0;
        while begun < header.len() {
            match file.read(&mut header[begun..])? {
                0 => break,
                more => begun += more,
            }
        }
        head::check_header(&header[..begun], about.len()).map_err(Failed::Problem)?;
        let length = usize::try_from(about.len()).unwrap_or(usize::MAX);
        let (mut blocks, length) = Self::zeros(length).map_err(Failed::Problem)?;
        let bytes = &mut bytemuck::cast_slice_mut(&mut blocks)[..length];
        bytes[..begun].copy_from_slice(&header);
        file.read_exact(&mut bytes[begun..])?;
        Ok(Self::Buffer(blocks, length))
    }
}

impl core::ops::Deref for Bytes {
    type Target = [u8];

    fn deref(&self) -> &[u8] {
        match self {
            Self::Buffer(blocks, length) => &bytemuck::cast_slice(blocks)[..*length],
            #[cfg(feature = "mmap")]
            Self::Map(map) => map,
        }
    }
}

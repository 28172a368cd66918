//! Small records, handed on in large pieces.

use std::io::{self, Write};

/// A piece is handed on when it has this many bytes: a call for each number would take longer than the number.
const FULL: usize = 1 << 16;

/// Bytes on their way to `out`.
pub(crate) struct Block<'a> {
    bytes: Vec<u8>,
    out: &'a mut dyn Write,
}

impl<'a> Block<'a> {
    pub(crate) fn new(out: &'a mut dyn Write) -> Self {
        // Room for a record beyond the mark.
        Self { bytes: Vec::with_capacity(FULL + 1024), out }
    }

    /// Where the next bytes go.
    #[inline(always)]
    pub(crate) fn bytes(&mut self) -> &mut Vec<u8> {
        &mut self.bytes
    }

    /// To be called often, such as after each record.
    #[inline(always)]
    pub(crate) fn pass_on(&mut self) -> io::Result<()> {
        if self.bytes.len() < FULL { Ok(()) } else { self.empty() }
    }

    /// All records, one after the other.
    #[inline(always)]
    pub(crate) fn put_all<const N: usize>(
        &mut self,
        mut records: impl Iterator<Item = [u8; N]>,
    ) -> io::Result<()> {
        records.try_for_each(|record| {
            self.bytes.extend_from_slice(&record);
            self.pass_on()
        })
    }

    /// Hands on the rest.
    pub(crate) fn finish(mut self) -> io::Result<()> {
        self.empty()
    }

    #[cold]
    fn empty(&mut self) -> io::Result<()> {
        self.out.write_all(&self.bytes)?;
        self.bytes.clear();
        Ok(())
    }
}

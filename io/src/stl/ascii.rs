//! ASCII STL.

use super::malformed;
use crate::error::quote;
use crate::memory::push;
use crate::number::f32_of;
use crate::triangles::skip;
use crate::words::Words;
use crate::{Error, Item, Note, Place, Reason, Skipped};

/// Whether the first word begins with `solid`, in upper or lower case. A name may follow without a blank.
pub(super) fn begins_with_solid(bytes: &[u8]) -> bool {
    let word = Words::new(bytes, None).next().unwrap_or_default();
    word.first_chunk::<5>().is_some_and(|start| start.eq_ignore_ascii_case(b"solid"))
}

/// The corners of the triangles, three by three, and notes on what was skipped.
pub(super) fn read(bytes: &[u8]) -> Result<(Vec<[f32; 3]>, Vec<Note>), Error> {
    let mut reader =
        Reader { words: Words::new(bytes, None), corners: Vec::new(), in_loop: 0, notes: Vec::new() };
    // The first word is the one that made this STL.
    if reader.words.next().is_some() {
        reader.words.end_line();
    }
    while let Some(word) = reader.words.next() {
        reader.statement(word)?;
    }
    reader.finish()
}

struct Reader<'a> {
    words: Words<'a>,
    corners: Vec<[f32; 3]>,
    /// Vertices of the loop so far.
    in_loop: usize,
    notes: Vec<Note>,
}

impl Reader<'_> {
    #[inline(always)]
    fn statement(&mut self, word: &[u8]) -> Result<(), Error> {
        let is = |keyword: &[u8]| word.eq_ignore_ascii_case(keyword);
        if is(b"vertex") {
            self.vertex()?;
        } else if is(b"endloop") {
            self.end_loop()?;
        } else if is(b"normal") {
            self.normal();
        } else if is(b"solid") || is(b"endsolid") {
            self.words.end_line();
        } else if !(is(b"facet") || is(b"outer") || is(b"loop") || is(b"endfacet")) {
            let line = Place::Line(self.words.line());
            skip(&mut self.notes, Skipped::UnknownStatements, 1, line);
            self.words.end_line();
        }
        Ok(())
    }

    #[inline(always)]
    fn vertex(&mut self) -> Result<(), Error> {
        let mut position = [0.0; 3];
        for (found, coordinate) in position.iter_mut().enumerate() {
            let Some(word) = self.words.next() else {
                return Err(self.malformed(Reason::TooFewCoordinates { found }));
            };
            let Some(number) = f32_of(word) else {
                return Err(self.malformed(Reason::BadNumber { word: quote(word) }));
            };
            *coordinate = number;
        }
        self.in_loop += 1;
        push(&mut self.corners, position)
    }

    fn end_loop(&mut self) -> Result<(), Error> {
        match std::mem::take(&mut self.in_loop) {
            3 => Ok(()),
            found => Err(self.malformed(Reason::LoopSize { found })),
        }
    }

    /// Steps over the three words of a normal, which need not be numbers (`-nan(ind)`), or be there.
    fn normal(&mut self) {
        for _ in 0..3 {
            match self.words.next() {
                Some(word) if !word.eq_ignore_ascii_case(b"outer") => {}
                _ => return,
            }
        }
    }

    fn finish(mut self) -> Result<(Vec<[f32; 3]>, Vec<Note>), Error> {
        if self.in_loop > 0 {
            let item = Item::Face((self.corners.len() - self.in_loop) / 3);
            return Err(self.malformed(Reason::Ends { item }));
        }
        match self.notes.first() {
            Some(note) if self.corners.is_empty() => {
                let expected = "an STL file: it has no vertex, but lines with unknown keywords";
                Err(malformed(note.first, Reason::NotThisFormat { expected }))
            }
            _ => Ok((self.corners, self.notes)),
        }
    }

    #[cold]
    fn malformed(&mut self, reason: Reason) -> Error {
        malformed(Place::Line(self.words.line()), reason)
    }
}

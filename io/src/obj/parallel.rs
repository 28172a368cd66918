//! Large files in parts, which all threads read at once.

use std::io::Read;

use rayon::prelude::*;

use super::Reader;
use super::append::append;
use super::numbering::{Numbering, settle};
use super::pieces::{Piece, Pieces, is_line_end};
use crate::text::without_byte_order_mark;
use crate::triangles::skip;
use crate::{Place, Triangles};

/// Bytes of a part. What it holds stays in the cache until it is copied to its place.
const PART: usize = 1 << 19;

/// Parts for each thread in a round: the threads that are done first take what is left.
const SHARE: usize = 4;

/// Reads a file as a reader of lines in order would; `None` if that one is to read it, since the file is small,
/// something is wrong with it, or memory ran out.
///
/// Besides the result, what a round of parts holds is in memory. A part ends with a line feed: a file that has none, as
/// on very old systems, is one part.
pub(super) fn read(bytes: &[u8]) -> Option<Triangles> {
    let threads = rayon::current_num_threads();
    if threads < 2 || bytes.len() < 2 * PART {
        return None;
    }
    let mut parts = Parts::new(PART, SHARE * threads);
    // Within the pool a round begins without waking a thread for it first.
    rayon::scope(|_| parts.read(without_byte_order_mark(bytes)))?;
    parts.finish()
}

/// The same from the file itself, behind its byte order mark: one thread reads what the next round parses.
pub(super) fn read_file(file: impl Read + Send) -> Option<Triangles> {
    let round = SHARE * rayon::current_num_threads();
    rayon::scope(|_| read_pieces(file, PART, round))
}

fn read_pieces(file: impl Read + Send, size: usize, round: usize) -> Option<Triangles> {
    let mut parts = Parts::new(size, round);
    let mut pieces = Pieces::new(file, size.max(1) * round);
    let (mut piece, mut next) = (Piece::default(), Piece::default());
    pieces.fill(&mut piece, b"").ok()?;
    while !piece.is_empty() {
        let (filled, read) =
            rayon::join(|| pieces.fill(&mut next, piece.rest()), || parts.read(piece.lines()));
        filled.ok().and(read)?;
        std::mem::swap(&mut piece, &mut next);
    }
    parts.finish()
}

/// What was read in parts, and the readers of a round of them.
struct Parts {
    all: Reader,
    readers: Vec<Reader>,
    /// Bytes of a part.
    size: usize,
}

impl Parts {
    fn new(size: usize, round: usize) -> Self {
        let readers = (0..round).map(|_| Reader::new(Numbering::of_part())).collect();
        Self { all: Reader::new(Numbering::of_file(u32::MAX)), readers, size }
    }

    /// Reads the next lines of the file.
    fn read(&mut self, mut rest: &[u8]) -> Option<()> {
        while !rest.is_empty() {
            let mut parts = Vec::with_capacity(self.readers.len());
            while parts.len() < self.readers.len() && !rest.is_empty() {
                let part;
                (part, rest) = split(rest, self.size);
                parts.push(part);
            }
            let readers = &mut self.readers[..parts.len()];
            readers
                .par_iter_mut()
                .zip(parts)
                .try_for_each(|(reader, part)| reader.restart().lines(part).ok())?;
            self.all.append(readers)?;
        }
        Some(())
    }

    fn finish(self) -> Option<Triangles> {
        self.all.has_all_corners().then(|| self.all.finish().ok())?
    }
}

/// The first `size` bytes or so, to the end of a line that is not joined to the next one; and the rest.
fn split(bytes: &[u8], size: usize) -> (&[u8], &[u8]) {
    let from = size.min(bytes.len());
    let mut ends = memchr::memchr_iter(b'\n', &bytes[from..]).map(|end| from + end);
    let end = ends.find(|end| is_line_end(bytes, *end));
    bytes.split_at(end.map_or(bytes.len(), |end| end + 1))
}

impl Reader {
    /// Empties the reader, for another part of the file; the memory stays.
    fn restart(&mut self) -> &mut Self {
        self.next_line = 1;
        self.positions.clear();
        self.polygons.clear();
        self.corner_bound = 0;
        self.lowest_skipped = u32::MAX;
        self.notes.clear();
        self.statements = 0;
        self
    }

    /// Takes what was read in the next parts.
    fn append(&mut self, parts: &mut [Self]) -> Option<()> {
        let mut vertices = self.positions.len();
        let mut before = Vec::with_capacity(parts.len());
        for part in &*parts {
            before.push(u32::try_from(vertices).ok()?);
            vertices += part.positions.len();
        }
        let all_exist = |part: &mut Self, before| {
            settle(part.polygons.corners_mut(), before)
                && settle(std::iter::once(&mut part.lowest_skipped), before)
        };
        if !parts.par_iter_mut().zip(before).all(|(part, before)| all_exist(part, before)) {
            return None;
        }
        let positions: Vec<_> = parts.iter().map(|part| part.positions.as_slice()).collect();
        append(&mut self.positions, &positions).ok()?;
        let polygons: Vec<_> = parts.iter().map(|part| &part.polygons).collect();
        self.polygons.append(&polygons, append).ok()?;
        for part in parts {
            for note in &part.notes {
                // Lines of a part are counted from 1.
                let Place::Line(first) = note.first else { continue };
                skip(&mut self.notes, note.what.clone(), note.count, Place::Line(self.next_line + first - 1));
            }
            self.corner_bound = self.corner_bound.max(part.corner_bound);
            self.statements += part.statements;
            self.next_line += part.next_line - 1;
        }
        Some(())
    }
}

#[cfg(test)]
mod tests {
    use super::super::read_in_order;
    use super::*;
    use proptest::prelude::*;

    /// In parts of all small sizes, the text gives what it gives in order, or is left to the reader in order.
    fn check(text: &str) {
        let expected = read_in_order(text.as_bytes()).ok();
        for (size, round) in [(0, 1), (0, 3), (1, 2), (7, 2), (20, 5), (100, 2)] {
            let mut parts = Parts::new(size, round);
            let read = parts.read(without_byte_order_mark(text.as_bytes())).and_then(|()| parts.finish());
            assert_eq!(read, expected, "parts of {size} in {text:?}");
            let read = read_pieces(without_byte_order_mark(text.as_bytes()), size, round);
            assert_eq!(read, expected, "pieces of {size} in {text:?}");
        }
    }

    #[test]
    fn parts_know_what_is_before_them() {
        let corners = "v 0 0 0\nv 1 0 0\r\nv 1 1 0\nv 0 1 0\n";
        for text in [
            "f 1 2 3\nf -4 -3 -2 -1\nv 2 2 2\nf -1 -2 -5\nf 1 5 2\n",
            "f 1 2 3\nl 1\nf 1 2\nwhat\nf 2 3 4 1\nl 2\nf 1\nhow\nf 1 2 3",
            "f 1 \\\n2 3\n# \\ \r\n f 1 2 9\nf 1 2 4\n",
            "f 1 2 6\nv 0 0 0\nv 0 0 0",
            "f 1 2 6",
            "f 1 2 3\n\u{FEFF}f 1 2 3\n",
            "f 1 2 -5\n",
            "f -5 -5\n",
            "f -1\nf -1 -2\n",
        ] {
            check(&format!("{corners}{text}"));
        }
        check("what\nhow\ng\n");
    }

    #[test]
    fn a_part_ends_with_a_line_that_is_not_joined() {
        for (text, end) in
            [("a\nb", 2), ("a\\\nb\nc", 5), ("a\\ \r\nb\nc", 7), ("a\\ \r\r\nc", 6), ("a\rb", 3)]
        {
            assert_eq!(split(text.as_bytes(), 0).0.len(), end, "{text:?}");
        }
    }

    #[test]
    fn a_large_file_is_read_in_parts() {
        let text = "v 0.25 -1e3 2\nv 1 1 1\nv 0 0 0\nf -1 -2 -3\n".repeat(40_000);
        let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
        let expected = Some(read_in_order(text.as_bytes()).unwrap());
        assert_eq!(pool.install(|| read(text.as_bytes())), expected);
        assert_eq!(pool.install(|| read_file(text.as_bytes())), expected);
    }

    proptest! {
        #[test]
        fn parts_give_what_the_whole_gives(
            lines in prop::collection::vec("(v( -?[0-9.]{1,3}){3}|f( -?[1-9]){2,5}|[vflgx#]( [0-9]{1,2}){0,3})[ \\\\]{0,2}(\r|\n|\r\n)", 0..30)
        ) {
            check(&lines.concat());
        }

        #[test]
        fn parts_of_plain_files_give_what_the_whole_gives(
            lines in prop::collection::vec("(v( [0-9]\\.[0-9]{1,3}){3}|f( [1-5]){3,5}|f( -[1-5]){3}|p 1)\r?\n", 0..40)
        ) {
            check(&("v 0 0 0\n".repeat(5) + &lines.concat()));
        }
    }
}

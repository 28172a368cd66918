//! Large files in parts, which all threads read at once.

use rayon::prelude::*;

use super::Reader;
use super::append::append;
use super::numbering::{Numbering, settle};
use crate::text::{Scanner, is_joined};
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
    // Within the pool a round begins without waking a thread for it first.
    rayon::scope(|_| read_parts(bytes, PART, SHARE * threads))
}

fn read_parts(bytes: &[u8], size: usize, round: usize) -> Option<Triangles> {
    let (first, mut rest) = split(bytes, size);
    let mut all = Reader::new(first, Numbering::of_file(u32::MAX)).run().ok()?;
    let mut line = all.scanner.line();
    let mut readers: Vec<_> = (0..round).map(|_| Reader::new(b"", Numbering::of_part())).collect();
    while !rest.is_empty() {
        let mut parts = Vec::with_capacity(round);
        while parts.len() < round && !rest.is_empty() {
            let part;
            (part, rest) = split(rest, size);
            parts.push(part);
        }
        let readers = &mut readers[..parts.len()];
        readers.par_iter_mut().zip(parts).try_for_each(|(reader, part)| reader.restart(part).lines().ok())?;
        line = all.append(readers, line)?;
    }
    let exist = all.corner_bound as usize <= all.positions.len();
    exist.then(|| all.finish().ok())?
}

/// The first `size` bytes or so, to the end of a line that is not joined to the next one; and the rest.
fn split(bytes: &[u8], size: usize) -> (&[u8], &[u8]) {
    let from = size.min(bytes.len());
    let mut ends = memchr::memchr_iter(b'\n', &bytes[from..]).map(|end| from + end);
    let end = ends.find(|end| {
        let line = &bytes[..*end];
        !is_joined(line.strip_suffix(b"\r").unwrap_or(line))
    });
    bytes.split_at(end.map_or(bytes.len(), |end| end + 1))
}

impl<'a> Reader<'a> {
    /// Empties the reader, for another part of the file; the memory stays.
    fn restart(&mut self, part: &'a [u8]) -> &mut Self {
        self.scanner = Scanner::of_part(part);
        self.positions.clear();
        self.polygons.clear();
        self.corner_bound = 0;
        self.notes.clear();
        self.statements = 0;
        self
    }

    /// Takes what was read in the next parts, of which the first begins at `line`; the line behind them.
    fn append(&mut self, parts: &mut [Self], mut line: usize) -> Option<usize> {
        let mut vertices = self.positions.len();
        let mut before = Vec::with_capacity(parts.len());
        for part in &*parts {
            before.push(u32::try_from(vertices).ok()?);
            vertices += part.positions.len();
        }
        let pairs = parts.par_iter_mut().zip(before);
        if !pairs.all(|(part, before)| settle(part.polygons.corners_mut(), before)) {
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
                skip(&mut self.notes, note.what.clone(), note.count, Place::Line(line + first - 1));
            }
            self.corner_bound = self.corner_bound.max(part.corner_bound);
            self.statements += part.statements;
            line += part.scanner.line() - 1;
        }
        Some(line)
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
            assert_eq!(read_parts(text.as_bytes(), size, round), expected, "parts of {size} in {text:?}");
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
        let mesh = pool.install(|| read(text.as_bytes()));
        assert_eq!(mesh, Some(read_in_order(text.as_bytes()).unwrap()));
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

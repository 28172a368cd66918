//! Large files, of which only a piece at a time is in memory.

use std::io::{self, Read};

use super::Reader;
use super::numbering::Numbering;
use crate::Triangles;
use crate::memory::reserve;
use crate::text::is_joined;

/// Bytes of a piece: they are in the cache still when they are parsed.
const PIECE: usize = 1 << 18;

/// A file with a line of more bytes is not read in pieces.
const LONGEST: usize = 1 << 24;

/// Reads a file, from behind its byte order mark on, as [`read`](super::read) would. `None` if that one is to read it,
/// since something is wrong with it, it cannot be read, has a line of more than 16 MiB, or memory ran out.
pub(crate) fn read(file: impl Read + Send) -> Option<Triangles> {
    #[cfg(feature = "parallel")]
    if rayon::current_num_threads() > 1 {
        return super::parallel::read_file(file);
    }
    read_pieces(file, PIECE)
}

pub(crate) fn read_pieces(file: impl Read, size: usize) -> Option<Triangles> {
    let mut reader = Reader::new(Numbering::of_file(u32::MAX));
    let mut pieces = Pieces::new(file, size);
    let (mut piece, mut next) = (Piece::default(), Piece::default());
    pieces.fill(&mut piece, b"").ok()?;
    while !piece.is_empty() {
        reader.lines(piece.lines()).ok()?;
        pieces.fill(&mut next, piece.rest()).ok()?;
        std::mem::swap(&mut piece, &mut next);
    }
    reader.has_all_corners().then(|| reader.finish().ok())?
}

/// Whole lines of a file, and the beginning of the next one.
#[derive(Default)]
pub(super) struct Piece {
    bytes: Vec<u8>,
    /// Where the last line that is here as a whole ends.
    end: usize,
}

impl Piece {
    pub(super) fn is_empty(&self) -> bool {
        self.bytes.is_empty()
    }

    /// The lines. There may be none, if the next one is long.
    pub(super) fn lines(&self) -> &[u8] {
        &self.bytes[..self.end]
    }

    /// What the next piece begins with.
    pub(super) fn rest(&self) -> &[u8] {
        &self.bytes[self.end..]
    }
}

/// A file that is read through two pieces of memory, which take turns.
pub(super) struct Pieces<R> {
    file: R,
    size: usize,
    /// Once the file has ended, it has no more, even if it grows: what comes behind an empty piece is empty.
    is_at_end: bool,
}

impl<R: Read> Pieces<R> {
    pub(super) fn new(file: R, size: usize) -> Self {
        Self { file, size, is_at_end: false }
    }

    /// Fills the next piece, which begins with the rest of the one before; it is empty at the end of the file.
    pub(super) fn fill(&mut self, piece: &mut Piece, rest: &[u8]) -> io::Result<()> {
        if rest.len() > LONGEST {
            return Err(io::ErrorKind::FileTooLarge.into());
        }
        // What is read grows with the line that has no end, so that it is not copied again and again.
        let room = rest.len() + self.size.max(rest.len());
        let bytes = &mut piece.bytes;
        reserve(bytes, room.saturating_sub(bytes.len())).map_err(|_| io::ErrorKind::OutOfMemory)?;
        // What is there already need not be filled with zeros once more.
        bytes.resize(room, 0);
        bytes[..rest.len()].copy_from_slice(rest);
        let mut length = rest.len();
        while length < room && !self.is_at_end {
            match self.file.read(&mut bytes[length..]) {
                Ok(0) => self.is_at_end = true,
                Ok(more) => length += more,
                Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
                Err(error) => return Err(error),
            }
        }
        bytes.truncate(length);
        piece.end = if self.is_at_end { length } else { end_of_lines(bytes) };
        Ok(())
    }
}

/// Behind the last line end that joins nothing; 0 if there is none.
fn end_of_lines(bytes: &[u8]) -> usize {
    let mut ends = memchr::memrchr_iter(b'\n', bytes);
    ends.find(|at| is_line_end(bytes, *at)).map_or(0, |at| at + 1)
}

/// Whether the line feed there ends a line that is not joined to the next one.
fn is_line_end(bytes: &[u8], at: usize) -> bool {
    let line = &bytes[..at];
    !is_joined(line.strip_suffix(b"\r").unwrap_or(line))
}

#[cfg(test)]
mod tests {
    use super::super::read_in_order;
    use super::*;
    use crate::text::without_byte_order_mark;
    use proptest::prelude::*;

    /// Gives a few bytes at a time, and is interrupted each time before.
    struct Trickle<'a>(&'a [u8], bool);

    impl Read for Trickle<'_> {
        fn read(&mut self, buffer: &mut [u8]) -> io::Result<usize> {
            self.1 = !self.1;
            if self.1 {
                return Err(io::ErrorKind::Interrupted.into());
            }
            let few = buffer.len().min(3);
            self.0.read(&mut buffer[..few])
        }
    }

    /// In pieces of all small sizes, the text gives what it gives as a whole, or is left to whoever reads it as that.
    fn check(text: &str) {
        let expected = read_in_order(text.as_bytes()).ok();
        let text = without_byte_order_mark(text.as_bytes());
        for size in [1, 2, 7, 20, 64, 1000] {
            assert_eq!(read_pieces(text, size), expected, "pieces of {size} in {text:?}");
        }
        assert_eq!(read_pieces(Trickle(text, false), 7), expected, "{text:?}");
    }

    #[test]
    fn borders_lie_anywhere() {
        let corners = "v 0 0 0\nv 1 0 0\r\nv 1 1 0\nv 0 1 0\n";
        for text in [
            "",
            "f 1 2 3\nf -4 -3 -2 -1\nv 2 2 2\nf -1 -2 -5\nf 1 5 2\n",
            "f 1 2 3\nl 1\nf 1 2\nwhat\nf 2 3 4 1\nl 2\nf 1\nhow\nf 1 2 3",
            "f 1 \\\n2 3\n# \\ \r\n f 1 2 9\nf 1 2 4\n",
            "f 1 2 3\\",
            "f 1 2 6\nv 0 0 0\nv 0 0 0",
            "f 1 2 6",
            "f 1 2 3\n\u{FEFF}f 1 2 3\n",
            "f 1 2 x\n",
            "f 1 2\rf 1 2 3\r",
        ] {
            check(&format!("{corners}{text}"));
            check(&format!("\u{FEFF}{corners}{text}"));
        }
        check("what\nhow\ng\n");
    }

    #[test]
    fn a_piece_ends_with_a_line_that_is_not_joined() {
        for (text, end) in [("a\nb\nc", 4), ("a\nb\\\nc", 2), ("a\nb\\ \r\nc", 2), ("a\rb", 0), ("\n", 1)] {
            assert_eq!(end_of_lines(text.as_bytes()), end, "{text:?}");
        }
    }

    /// What is in memory of a file without line feeds is bounded.
    #[test]
    fn long_lines_are_left_to_the_reader_of_the_whole() {
        let endless = io::repeat(b' ');
        assert_eq!(read_pieces(b"v 1 2 3\n".chain(endless), 1000), None);
        let text = format!("v 1 2 3 {}\nv 0 0 0\n", " ".repeat(100_000));
        assert_eq!(read_pieces(text.as_bytes(), 1000).map(|mesh| mesh.positions.len()), Some(2));
    }

    proptest! {
        #[test]
        fn pieces_give_what_the_whole_gives(
            lines in prop::collection::vec("(v( -?[0-9.]{1,3}){3}|f( -?[1-9]){2,5}|[vflgx#]( [0-9]{1,2}){0,3})[ \\\\]{0,2}(\r|\n|\r\n)", 0..30)
        ) {
            check(&lines.concat());
        }

        #[test]
        fn pieces_of_plain_files_give_what_the_whole_gives(
            lines in prop::collection::vec("(v( [0-9]\\.[0-9]{1,3}){3}|f( [1-5]){3,5}|f( -[1-5]){3}|p 1)\r?\n", 0..40)
        ) {
            check(&("v 0 0 0\n".repeat(5) + &lines.concat()));
        }
    }
}

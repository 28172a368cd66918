//! Large files in parts, which all threads read at once.

use std::io::Read;
use std::sync::Mutex;

use super::Reader;
use super::lists::{Lists, Needed, Rooms};
use super::numbering::Numbering;
use super::pieces::{Piece, Pieces};
use super::turns::{Alarm, Turns};
use crate::memory::reserve;
use crate::text::without_byte_order_mark;
use crate::triangles::skip;
use crate::{Place, Triangles};

/// Bytes of a part. They and what they hold stay in the cache of a processor until that is copied to its place.
const PART: usize = 1 << 18;

/// Reads a file as a reader of lines in order would; `None` if that one is to read it, since the file is small,
/// something is wrong with it, or memory ran out.
pub(super) fn read(bytes: &[u8]) -> Option<Triangles> {
    if rayon::current_num_threads() < 2 || bytes.len() < 4 * PART {
        return None;
    }
    read_file(without_byte_order_mark(bytes))
}

/// The same from the file itself, behind its byte order mark.
pub(super) fn read_file(file: impl Read + Send) -> Option<Triangles> {
    read_parts(file, PART, rayon::current_num_threads())
}

/// Each thread takes the next part of the file, parses it, waits for its turn to be given a share of the lists, and
/// fills that while others have their turns. Once there is too little room, they all stop, and go on with more.
fn read_parts(file: impl Read + Send, size: usize, threads: usize) -> Option<Triangles> {
    let source = Mutex::new(Source { pieces: Pieces::new(file, size.max(1)), rest: Vec::new(), parts: 0 });
    let mut workers = Vec::from_iter((0..threads.max(1)).map(|_| Worker::new()));
    let (mut all, mut lists) = (Reader::new(Numbering::of_file(u32::MAX)), Lists::default());
    let mut placed = 0;
    loop {
        // Those that wait come first, in the order of their parts.
        workers.sort_by_key(|worker| worker.number.unwrap_or(usize::MAX));
        let first = workers.first().filter(|worker| worker.number.is_some());
        let needed = first.map_or(Needed::default(), |worker| Needed::by(&worker.part));
        let fill = |rooms: &mut Rooms<'_>| work(&mut workers, &source, Turns::new(placed, rooms, &mut all));
        let has_room;
        (placed, has_room) = lists.with_room(&needed, fill).ok()??;
        if has_room {
            break;
        }
    }
    all.positions = lists.positions;
    all.polygons.put_lists(lists.faces, lists.starts);
    all.has_all_corners().then(|| all.finish().ok())?
}

/// How many parts have their places now, and whether there is room left: if so, that was all. `None` if anything is
/// wrong.
fn work(
    workers: &mut [Worker],
    source: &Mutex<Source<impl Read + Send>>,
    turns: Turns<'_, '_>,
) -> Option<(usize, bool)> {
    // Not by the threads: nobody knows how many of them there are to wait for each other.
    let _ = workers
        .iter_mut()
        .filter(|worker| worker.number.is_some())
        .try_for_each(|worker| worker.place(&turns));
    rayon::scope(|scope| {
        for worker in workers {
            scope.spawn(|_| {
                let _alarm = Alarm(&turns);
                while worker.place(&turns).is_some() && worker.parse(source, &turns).is_some() {}
            });
        }
    });
    turns.end()
}

/// Where parts come from, one after the other.
struct Source<R> {
    pieces: Pieces<R>,
    /// What the next part begins with.
    rest: Vec<u8>,
    /// How many were given away.
    parts: usize,
}

impl<R: Read> Source<R> {
    /// The number of the next part, now in `piece`, which is empty at the end of the file.
    fn next(&mut self, piece: &mut Piece) -> Option<usize> {
        self.pieces.fill(piece, &self.rest).ok()?;
        self.rest.clear();
        reserve(&mut self.rest, piece.rest().len()).ok()?;
        self.rest.extend_from_slice(piece.rest());
        self.parts += 1;
        Some(self.parts - 1)
    }
}

/// Reads parts.
struct Worker {
    piece: Piece,
    part: Reader,
    /// The number of the part that was parsed and has no place yet.
    number: Option<usize>,
}

impl Worker {
    fn new() -> Self {
        Self { piece: Piece::default(), part: Reader::new(Numbering::of_part()), number: None }
    }

    /// Parses the next part; `None` if there is none, or if it is wrong.
    fn parse(&mut self, source: &Mutex<Source<impl Read>>, turns: &Turns<'_, '_>) -> Option<()> {
        let number = turns.right(source.lock().ok()?.next(&mut self.piece))?;
        if self.piece.is_empty() {
            return None;
        }
        turns.right(self.part.restart().lines(self.piece.lines()).ok())?;
        self.number = Some(number);
        Some(())
    }

    /// Puts the part that was parsed, if there is one, to its place; `None` if that is not possible.
    fn place(&mut self, turns: &Turns<'_, '_>) -> Option<()> {
        let Some(number) = self.number else { return turns.go_on() };
        let share = turns.share(number, &self.part)?;
        self.number = None;
        turns.right(share.fill(&self.part).then_some(()))
    }
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

    /// Takes what was read in the next part, but for its lists.
    pub(super) fn count(&mut self, part: &Self) {
        for note in &part.notes {
            // Lines of a part are counted from 1.
            let Place::Line(first) = note.first else { continue };
            skip(&mut self.notes, note.what.clone(), note.count, Place::Line(self.next_line + first - 1));
        }
        self.polygons.count(&part.polygons);
        self.corner_bound = self.corner_bound.max(part.corner_bound);
        self.statements += part.statements;
        self.next_line += part.next_line - 1;
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
        for (size, threads) in [(0, 1), (0, 3), (1, 2), (7, 2), (20, 5), (100, 2)] {
            let read = read_parts(without_byte_order_mark(text.as_bytes()), size, threads);
            assert_eq!(read, expected, "parts of {size} in {text:?}");
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

    /// Room is made several times, for polygons that are no triangles after many that are as well.
    #[test]
    fn a_large_file_is_read_in_parts() {
        let text = "v 0.25 -1e3 2\nv 1 1 1\nv 0 0 0\nf -1 -2 -3\n".repeat(200_000);
        let text = text.clone() + &"f 1 2 3 4\n".repeat(200_000) + &text;
        let pool = rayon::ThreadPoolBuilder::new().num_threads(3).build().unwrap();
        let expected = Some(read_in_order(text.as_bytes()).unwrap());
        assert_eq!(pool.install(|| read(text.as_bytes())), expected);
        for (size, threads) in [(1 << 14, 1), (1 << 14, 7), (1 << 22, 2)] {
            assert_eq!(pool.install(|| read_parts(text.as_bytes(), size, threads)), expected);
        }
    }

    /// The last part is wrong, or the corners that it counts back do not exist.
    #[test]
    fn what_is_wrong_stops_all() {
        let text = "v 1 2 3\nf -1 -1 -1\n".repeat(100_000);
        for end in ["f 1 2 x\n", "f -1 -1 -100001\n", "f 100001 1 1\n"] {
            assert_eq!(read_parts((text.clone() + end).as_bytes(), 5000, 4), None);
        }
    }

    /// Gives one of these at a time, and the end of the file where one is empty.
    struct Growing(std::collections::VecDeque<Vec<u8>>);

    impl Read for Growing {
        fn read(&mut self, buffer: &mut [u8]) -> std::io::Result<usize> {
            let bytes = self.0.pop_front().unwrap_or_default();
            buffer[..bytes.len()].copy_from_slice(&bytes);
            Ok(bytes.len())
        }
    }

    /// What is behind the end, once that was met, is not read. Nobody waits for the part that was empty.
    #[test]
    fn a_file_that_grows_ends_where_it_ended() {
        let text = || b"v 1 2 3\n".repeat(100);
        let (tell, told) = std::sync::mpsc::channel();
        std::thread::spawn(move || {
            let file = Growing([text(), vec![], vec![], text()].into());
            let pool = rayon::ThreadPoolBuilder::new().num_threads(2).build().unwrap();
            let read = pool.install(|| read_parts(file, 5000, 2));
            tell.send(read.map(|mesh| mesh.positions.len()))
        });
        let read = told.recv_timeout(std::time::Duration::from_secs(60)).expect("it comes to an end");
        assert_eq!(read, Some(100));
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

//! Words of a text format in which line ends are blanks, over bytes.

use crate::text::without_byte_order_mark;

/// Reads words across lines. Where the format has comments, their first byte hides the rest of the line.
#[derive(Clone, Debug)]
pub(crate) struct Words<'a> {
    bytes: &'a [u8],
    at: usize,
    comment: Option<u8>,
    /// Where the word read last began.
    last: usize,
    /// A line that was asked for, and where it was: the next one is counted from there.
    counted: (usize, usize),
}

impl<'a> Words<'a> {
    /// At the first word of `bytes`, behind a byte order mark.
    pub(crate) fn new(bytes: &'a [u8], comment: Option<u8>) -> Self {
        let at = bytes.len() - without_byte_order_mark(bytes).len();
        Self { bytes, at, comment, last: at, counted: (1, 0) }
    }

    /// The same words from byte `at` on; lines are still counted from the beginning.
    pub(crate) fn starting_at(mut self, at: usize) -> Self {
        (self.at, self.last) = (at, at);
        self
    }

    /// The next word.
    #[inline(always)]
    pub(crate) fn next(&mut self) -> Option<&'a [u8]> {
        self.skip_blanks();
        let rest = &self.bytes[self.at..];
        let ends = |byte: &u8| is_blank(*byte) || Some(*byte) == self.comment;
        let length = rest.iter().position(ends).unwrap_or(rest.len());
        self.last = self.at;
        self.at += length;
        (length > 0).then(|| &rest[..length])
    }

    /// The next word if it is on the same line as the last one.
    pub(crate) fn next_on_line(&mut self) -> Option<&'a [u8]> {
        while matches!(self.bytes.get(self.at), Some(b' ' | b'\t' | 0x0B | 0x0C)) {
            self.at += 1;
        }
        match self.bytes.get(self.at) {
            None | Some(b'\n' | b'\r') => None,
            byte if byte.copied() == self.comment => None,
            _ => self.next(),
        }
    }

    /// Steps over what is left of the line of the last word.
    pub(crate) fn end_line(&mut self) {
        let rest = &self.bytes[self.at..];
        self.at += memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
    }

    /// Byte at which the next word is looked for.
    pub(crate) fn at(&self) -> usize {
        self.at
    }

    /// Number of the line on which the last word began, from 1; LF, CRLF and CR end one. Counts from where it was
    /// asked last: all calls together are linear in the bytes.
    pub(crate) fn line(&mut self) -> usize {
        let (line, from) = self.counted;
        let ends_one = |i: &usize| match self.bytes[*i] {
            b'\n' => *i == 0 || self.bytes[*i - 1] != b'\r',
            byte => byte == b'\r',
        };
        self.counted = (line + (from..self.last).filter(ends_one).count(), self.last);
        self.counted.0
    }

    #[inline(always)]
    fn skip_blanks(&mut self) {
        while let Some(&byte) = self.bytes.get(self.at) {
            if is_blank(byte) {
                self.at += 1;
            } else if Some(byte) == self.comment {
                self.end_line();
            } else {
                return;
            }
        }
    }
}

#[inline(always)]
fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t'..=b'\r')
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_know_their_lines() {
        let mut words = Words::new(b"\xEF\xBB\xBFa b\r\n# c d\n\re#f\n", Some(b'#'));
        let mut all = Vec::new();
        while let Some(word) = words.next() {
            all.push((str::from_utf8(word).unwrap(), words.line()));
        }
        assert_eq!(all, [("a", 1), ("b", 1), ("e", 4)]);
        assert_eq!(words.next(), None);
    }

    #[test]
    fn words_of_one_line_end_with_it() {
        let mut words = Words::new(b"a b #c\nd\n", Some(b'#'));
        assert_eq!(words.next(), Some(&b"a"[..]));
        assert_eq!(words.next_on_line(), Some(&b"b"[..]));
        assert_eq!(words.next_on_line(), None);
        assert_eq!(words.next(), Some(&b"d"[..]));
        assert_eq!(words.next_on_line(), None);
        assert_eq!(words.line(), 2);
    }

    #[test]
    fn without_comments_a_hash_is_a_letter() {
        let mut words = Words::new(b"#a b", None);
        assert_eq!(words.next(), Some(&b"#a"[..]));
        words.end_line();
        assert_eq!((words.next(), words.at()), (None, 4));
    }
}

//! Lines and words of a text format, over bytes: what OBJ and its like have in common.

/// Reads words line by line. A `#` hides the rest of its line; a backslash at the end of a line joins the
/// next one to it, comments included; LF, CRLF and CR all end a line. Bytes need not be UTF-8.
#[derive(Clone, Debug)]
pub(crate) struct Scanner<'a> {
    bytes: &'a [u8],
    at: usize,
    line: usize,
}

const WORD: u8 = 0;
const BLANK: u8 = 1;
const END: u8 = 2;
const BACKSLASH: u8 = 3;

/// What each byte is: one load instead of six comparisons, for every byte of a file.
const CLASS: [u8; 256] = {
    let mut class = [WORD; 256];
    class[b' ' as usize] = BLANK;
    class[b'\t' as usize] = BLANK;
    class[0x0B] = BLANK;
    class[0x0C] = BLANK;
    class[b'\n' as usize] = END;
    class[b'\r' as usize] = END;
    class[b'#' as usize] = END;
    class[b'\\' as usize] = BACKSLASH;
    class
};

impl<'a> Scanner<'a> {
    /// At the first line, behind a byte order mark.
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        Self::of_lines(without_byte_order_mark(bytes), 1)
    }

    /// At the first of some lines of a file, which is number `line`: what looks like a byte order mark is none.
    pub(crate) fn of_lines(bytes: &'a [u8], line: usize) -> Self {
        Self { bytes, at: 0, line }
    }

    /// Number of the line that the scanner is on, from 1.
    pub(crate) fn line(&self) -> usize {
        self.line
    }

    pub(crate) fn is_at_end(&self) -> bool {
        self.at >= self.bytes.len()
    }

    /// The next word of this line.
    #[inline(always)]
    pub(crate) fn word(&mut self) -> Option<&'a [u8]> {
        self.skip_blanks();
        let start = self.at;
        self.skip_word();
        (start < self.at).then(|| &self.bytes[start..self.at])
    }

    /// Every byte from here on.
    #[inline(always)]
    pub(crate) fn remainder(&self) -> &'a [u8] {
        &self.bytes[self.at.min(self.bytes.len())..]
    }

    /// Goes on with `remainder`, the end of what is left of this line and of those behind it.
    #[inline(always)]
    pub(crate) fn go_on_with(&mut self, remainder: &[u8]) {
        self.at = self.bytes.len() - remainder.len();
    }

    /// What is left of this line as it stands, for names that may hold any character.
    #[cfg(feature = "tobj")]
    pub(crate) fn rest(&mut self) -> &'a [u8] {
        let rest = &self.bytes[self.at..];
        let length = memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
        &rest[..length]
    }

    /// Steps behind the end of this line, whatever is left on it.
    #[inline(always)]
    pub(crate) fn end_line(&mut self) {
        // Most lines are read to their end: no search.
        while !matches!(self.bytes.get(self.at), Some(b'\n')) {
            let rest = &self.bytes[self.at..];
            let Some(length) = memchr::memchr2(b'\n', b'\r', rest) else {
                self.at = self.bytes.len();
                return;
            };
            let joined = is_joined(&rest[..length]);
            self.at += length;
            if !joined {
                break;
            }
            self.end_physical_line();
        }
        self.end_physical_line();
    }

    fn end_physical_line(&mut self) {
        let crlf = self.bytes[self.at..].starts_with(b"\r\n");
        self.at += 1 + usize::from(crlf);
        self.line += 1;
    }

    #[inline(always)]
    fn class(&self) -> u8 {
        self.bytes.get(self.at).map_or(END, |&byte| CLASS[usize::from(byte)])
    }

    #[inline(always)]
    fn skip_blanks(&mut self) {
        loop {
            match self.class() {
                BLANK => self.at += 1,
                BACKSLASH if self.is_at_joint() => self.join(),
                _ => return,
            }
        }
    }

    #[inline(always)]
    fn skip_word(&mut self) {
        loop {
            match self.class() {
                WORD => self.at += 1,
                BACKSLASH if !self.is_at_joint() => self.at += 1,
                _ => return,
            }
        }
    }

    /// Steps from a joining backslash to the next line, or to the end of the file where there is none.
    #[cold]
    fn join(&mut self) {
        match memchr::memchr2(b'\n', b'\r', &self.bytes[self.at..]) {
            Some(length) => {
                self.at += length;
                self.end_physical_line();
            }
            None => self.at = self.bytes.len(),
        }
    }

    /// Whether the backslash here joins the next line: only spaces and tabs stand between it and the end of its
    /// own. On the last line it joins nothing, and is a blank.
    #[cold]
    fn is_at_joint(&self) -> bool {
        let behind = &self.bytes[self.at + 1..];
        let blanks = behind.iter().take_while(|byte| matches!(byte, b' ' | b'\t')).count();
        matches!(behind.get(blanks), None | Some(b'\n' | b'\r'))
    }
}

/// The bytes behind a UTF-8 byte order mark, if they begin with one.
pub(crate) fn without_byte_order_mark(bytes: &[u8]) -> &[u8] {
    bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes)
}

/// Whether a line's text ends with a backslash that joins the next line to it.
#[inline(always)]
pub(crate) fn is_joined(line: &[u8]) -> bool {
    line.iter().rev().find(|byte| !matches!(byte, b' ' | b'\t')) == Some(&b'\\')
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Every line as its number and its words.
    fn lines(text: &str) -> Vec<(usize, Vec<&str>)> {
        let mut scanner = Scanner::new(text.as_bytes());
        let mut lines = Vec::new();
        while !scanner.is_at_end() {
            let line = scanner.line();
            let words = std::iter::from_fn(|| scanner.word()).map(|word| str::from_utf8(word).unwrap());
            lines.push((line, words.collect()));
            scanner.end_line();
        }
        lines
    }

    #[test]
    fn every_line_end_counts_once() {
        assert_eq!(lines("a\nb\r\nc\rd"), [(1, vec!["a"]), (2, vec!["b"]), (3, vec!["c"]), (4, vec!["d"])]);
        assert_eq!(lines("\r\r\n\n"), [(1, vec![]), (2, vec![]), (3, vec![])]);
        assert_eq!(lines(""), []);
    }

    #[test]
    fn a_backslash_at_the_end_joins_lines_and_words_stay_apart() {
        assert_eq!(lines("a\\\nb\nc"), [(1, vec!["a", "b"]), (3, vec!["c"])]);
        assert_eq!(lines("a \\ \t\r\n b\rc"), [(1, vec!["a", "b"]), (3, vec!["c"])]);
        assert_eq!(lines("# a \\\nb\nc"), [(1, vec![]), (3, vec!["c"])]);
        assert_eq!(lines("\\\n\\\na"), [(1, vec!["a"])]);
    }

    #[test]
    fn a_backslash_elsewhere_is_a_letter() {
        assert_eq!(lines("a\\b \\c"), [(1, vec!["a\\b", "\\c"])]);
    }

    #[test]
    fn a_backslash_at_the_very_end_is_a_blank() {
        for end in ["\\", "\\ \t", "\\\n", "\\\r\n"] {
            assert_eq!(lines(&format!("a\\b c{end}")), [(1, vec!["a\\b", "c"])], "{end:?}");
            assert_eq!(lines(end), [(1, vec![])], "{end:?}");
        }
    }

    #[test]
    fn a_hash_hides_the_rest() {
        assert_eq!(lines("a b#c\n#d\n e"), [(1, vec!["a", "b"]), (2, vec![]), (3, vec!["e"])]);
    }

    #[test]
    fn a_byte_order_mark_is_no_word() {
        assert_eq!(lines("\u{FEFF}a"), [(1, vec!["a"])]);
    }
}

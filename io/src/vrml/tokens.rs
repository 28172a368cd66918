//! Words, brackets and strings of VRML97, over bytes.

use std::ops::Range;

/// A piece of a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Token<'a> {
    /// A keyword, a name, a number.
    Word(&'a [u8]),
    /// `{` or `[`.
    Open(u8),
    /// `}` or `]`.
    Close(u8),
    /// `"..."`, whose text is passed over.
    Text,
}

/// A quotation mark or a `[` that has no counterpart, and its byte.
pub(super) struct Unclosed {
    pub(super) mark: char,
    pub(super) at: usize,
}

/// Reads tokens. Blanks, commas and comments part them; a `#` in a string begins no comment.
#[derive(Clone, Debug)]
pub(super) struct Tokens<'a> {
    bytes: &'a [u8],
    at: usize,
    /// Where the token read last began.
    pub(super) last: usize,
}

impl<'a> Tokens<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Self { bytes, at: 0, last: 0 }
    }

    /// The next token, or `None` at the end.
    #[inline]
    pub(super) fn next(&mut self) -> Result<Option<Token<'a>>, Unclosed> {
        let Some(byte) = self.peek() else { return Ok(None) };
        self.last = self.at;
        self.at += 1;
        Ok(Some(match byte {
            b'{' | b'[' => Token::Open(byte),
            b'}' | b']' => Token::Close(byte),
            b'"' => {
                self.end_text()?;
                Token::Text
            }
            _ => {
                let rest = &self.bytes[self.at..];
                self.at += rest.iter().position(|byte| ends_word(*byte)).unwrap_or(rest.len());
                Token::Word(&self.bytes[self.last..self.at])
            }
        }))
    }

    /// The next token if it is a word; otherwise it is still to be read.
    pub(super) fn word(&mut self) -> Option<&'a [u8]> {
        if self.peek().is_none_or(|byte| matches!(byte, b'{' | b'}' | b'[' | b']' | b'"')) {
            return None;
        }
        match self.next() {
            Ok(Some(Token::Word(word))) => Some(word),
            _ => None,
        }
    }

    /// The first byte of the next token.
    #[inline]
    pub(super) fn peek(&mut self) -> Option<u8> {
        loop {
            match *self.bytes.get(self.at)? {
                b' ' | b'\t'..=b'\r' | b',' => self.at += 1,
                b'#' => self.end_line(),
                byte => return Some(byte),
            }
        }
    }

    /// Behind the `[` that was read last, steps over everything up to its `]`: the bytes between. For lists that
    /// hold no nodes.
    pub(super) fn end_list(&mut self) -> Result<Range<usize>, Unclosed> {
        let (open, start) = (self.last, self.at);
        loop {
            let rest = &self.bytes[self.at..];
            let Some(length) = memchr::memchr3(b']', b'#', b'"', rest) else {
                return Err(Unclosed { mark: '[', at: open });
            };
            self.at += length;
            match rest[length] {
                b'#' => self.end_line(),
                b'"' => {
                    self.last = self.at;
                    self.at += 1;
                    self.end_text()?;
                }
                _ => {
                    self.at += 1;
                    return Ok(start..self.at - 1);
                }
            }
        }
    }

    /// From the word that was read last, steps over the numbers that follow it: the bytes of all.
    pub(super) fn end_numbers(&mut self) -> Range<usize> {
        let start = self.last;
        let mut end = self.at;
        while self.peek().is_some_and(begins_number) && self.word().is_some() {
            end = self.at;
        }
        start..end
    }

    fn end_line(&mut self) {
        let rest = &self.bytes[self.at..];
        self.at += memchr::memchr2(b'\n', b'\r', rest).unwrap_or(rest.len());
    }

    /// From behind a quotation mark to behind the next one that has no backslash before it.
    fn end_text(&mut self) -> Result<(), Unclosed> {
        loop {
            let rest = &self.bytes[self.at..];
            match memchr::memchr2(b'"', b'\\', rest) {
                None => return Err(Unclosed { mark: '"', at: self.last }),
                Some(length) if rest[length] == b'"' => {
                    self.at += length + 1;
                    return Ok(());
                }
                Some(length) => self.at = (self.at + length + 2).min(self.bytes.len()),
            }
        }
    }
}

pub(super) fn begins_number(byte: u8) -> bool {
    matches!(byte, b'0'..=b'9' | b'+' | b'-' | b'.')
}

fn ends_word(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t'..=b'\r' | b',' | b'#' | b'"' | b'{' | b'}' | b'[' | b']')
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tokens(text: &str) -> Vec<Token<'_>> {
        let mut tokens = Tokens::new(text.as_bytes());
        std::iter::from_fn(|| tokens.next().ok().flatten()).collect()
    }

    #[test]
    fn brackets_and_strings_need_no_blanks() {
        use Token::{Close, Open, Text, Word};
        let expected =
            [Word(b"a"), Open(b'{'), Word(b"b"), Open(b'['), Text, Word(b"1"), Close(b']'), Close(b'}')];
        assert_eq!(tokens("a{b[\"#\\\"]\"1]}#{"), expected);
        assert_eq!(tokens(" a ,{,b\t[\r\"\"#]\r1]\n}"), expected);
    }

    #[test]
    fn a_list_ends_at_its_bracket_and_not_in_comments_and_strings() {
        let text = "[1 # ]\n \"]\" 2]3";
        let mut tokens = Tokens::new(text.as_bytes());
        assert!(matches!(tokens.next(), Ok(Some(Token::Open(b'[')))));
        assert!(tokens.end_list().is_ok_and(|range| &text[range] == "1 # ]\n \"]\" 2"));
        assert_eq!(tokens.word(), Some(&b"3"[..]));
        assert_eq!(tokens.word(), None);
    }

    #[test]
    fn what_never_ends_is_told_with_its_start() {
        for text in [" \"a", " \"a\\", " \"a\\\""] {
            let mut tokens = Tokens::new(text.as_bytes());
            assert!(matches!(tokens.next(), Err(Unclosed { mark: '"', at: 1 })), "{text}");
        }
        let mut tokens = Tokens::new(b" [ 1 # ]");
        assert!(tokens.next().is_ok());
        assert!(matches!(tokens.end_list(), Err(Unclosed { mark: '[', at: 1 })));
    }
}

//! The first words of OBJ lines.

use crate::text::Scanner;

/// Elements other than polygons: skipped, with a note.
const ELEMENTS: [&str; 5] = ["p", "l", "curv", "curv2", "surf"];

/// Keywords whose lines have nothing to do with positions or faces, parted by blanks: skipped without a word.
const OTHERS: &str = "vt vn vp g o s mg \
    usemtl mtllib usemap maplib bevel c_interp d_interp lod shadow_obj trace_obj ctech stech \
    cstype deg bmat step parm trim hole scrv sp end con \
    call csh bsp bzp cdc cdp res mat material property scmp";

/// The keyword, if it is one of an element other than a polygon.
pub(super) fn element(keyword: &[u8]) -> Option<&'static str> {
    ELEMENTS.into_iter().find(|known| known.as_bytes() == keyword)
}

/// Whether it is a keyword that has nothing to do with positions or faces.
pub(super) fn is_other(keyword: &[u8]) -> bool {
    OTHERS.split(' ').any(|known| known.as_bytes() == keyword)
}

/// Whether the first word outside comments is an OBJ keyword.
pub(crate) fn begins_with_keyword(bytes: &[u8]) -> bool {
    let mut scanner = Scanner::new(bytes);
    while !scanner.is_at_end() {
        match scanner.word() {
            Some(b"v" | b"f" | b"fo") => return true,
            Some(word) => return element(word).is_some() || is_other(word),
            None => scanner.end_line(),
        }
    }
    false
}

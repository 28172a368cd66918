//! The keyword of an OFF file, and what it says of the vertices.

use super::header::count;
use crate::words::Words;
use crate::{Error, Format, Place};

/// `[ST][C][N][4][n]OFF`, the prefixes in any order and each at most once; without any where it is missing.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Keyword {
    has_texture: bool,
    has_colours: bool,
    has_normals: bool,
    is_homogeneous: bool,
    has_dimension: bool,
    pub(super) is_binary: bool,
    /// Whether the dimension is the first number behind the header of a binary file.
    pub(super) dimension_follows: bool,
}

impl Keyword {
    fn of(word: &[u8]) -> Option<Self> {
        let mut rest = word.strip_suffix(b"OFF")?;
        let mut keyword = Self::default();
        while !rest.is_empty() {
            let (flag, length) = match rest {
                [b'S', b'T', ..] => (&mut keyword.has_texture, 2),
                [b'C', ..] => (&mut keyword.has_colours, 1),
                [b'N', ..] => (&mut keyword.has_normals, 1),
                [b'4', ..] => (&mut keyword.is_homogeneous, 1),
                [b'n', ..] => (&mut keyword.has_dimension, 1),
                _ => return None,
            };
            if std::mem::replace(flag, true) {
                return None;
            }
            rest = &rest[length..];
        }
        Some(keyword)
    }

    /// The keyword, if there is one, with the dimension of `nOFF` and the word `BINARY`.
    pub(super) fn read(words: &mut Words<'_>) -> Result<Self, Error> {
        let mut behind = words.clone();
        let Some(mut keyword) = behind.next().and_then(Self::of) else { return Ok(Self::default()) };
        *words = behind;
        keyword.is_binary = takes_binary(words);
        keyword.dimension_follows = keyword.has_dimension && keyword.is_binary;
        if keyword.has_dimension && !keyword.is_binary {
            let word = words.next();
            let line = Place::Line(words.line());
            check_dimension(count(word, line)?, line)?;
            keyword.is_binary = takes_binary(words);
        }
        Ok(keyword)
    }

    /// Whether vertices are announced to be nothing but coordinates.
    pub(super) fn is_plain(self) -> bool {
        !(self.has_texture || self.has_colours || self.has_normals)
    }

    /// Numbers of a vertex that tell where it is.
    pub(super) fn components(self) -> usize {
        3 + usize::from(self.is_homogeneous)
    }

    /// Numbers of a vertex in a binary file: normals have three, colours four, texture coordinates two.
    pub(super) fn numbers(self) -> usize {
        let [normals, colours, texture] =
            [self.has_normals, self.has_colours, self.has_texture].map(usize::from);
        self.components() + 3 * normals + 4 * colours + 2 * texture
    }

    /// Which of four components is the homogeneous one; `None` where there are three.
    pub(super) fn weight(self) -> Option<usize> {
        self.is_homogeneous.then_some(if self.has_dimension { 0 } else { 3 })
    }
}

/// Steps over `BINARY` if it is the next word of the line.
fn takes_binary(words: &mut Words<'_>) -> bool {
    let mut behind = words.clone();
    let is_binary = behind.next_on_line() == Some(b"BINARY");
    if is_binary {
        *words = behind;
    }
    is_binary
}

/// Refuses vertices in another space than ours.
pub(super) fn check_dimension(dimension: u64, place: Place) -> Result<(), Error> {
    if dimension == 3 {
        return Ok(());
    }
    let feature = format!("nOFF of dimension {dimension}, not 3");
    Err(Error::Unsupported { format: Format::Off, path: None, place, feature })
}

/// Whether the first word outside comments is an OFF keyword.
pub(crate) fn begins_with_keyword(bytes: &[u8]) -> bool {
    Words::new(bytes, Some(b'#')).next().and_then(Keyword::of).is_some()
}

//! What can go wrong, where, and why.

use std::fmt;
use std::io;
use std::path::{Path, PathBuf};

use crate::{Format, Item, Place};

/// Why a mesh could not be read or written. Its `Display` is one line that names the file where it is known:
/// `part.obj:20: face names vertex 12, but there are 8`.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum Error {
    /// The file, or one that it refers to, could not be read.
    #[error("{}{}: {source}", Colon(named_in), name_of(path))]
    Io {
        /// The file that could not be read.
        path: PathBuf,
        /// The document that refers to it; `None` where it is the file that [`load`](crate::load) was asked for.
        named_in: Option<PathBuf>,
        /// What the system said.
        source: io::Error,
    },
    /// Neither the content nor the extension is one of a format that this crate reads.
    #[error("{}not a known mesh format; supported are {}", Colon(path), Format::list())]
    UnknownFormat {
        /// The file, where [`load`](crate::load) was asked for one.
        path: Option<PathBuf>,
    },
    /// The file contradicts itself or its format.
    #[error("{}{reason}", Location { path, format: *format, place: reason.place_to_say(*place) })]
    Malformed {
        /// What it was read as.
        format: Format,
        /// The file, where [`load`](crate::load) was asked for one.
        path: Option<PathBuf>,
        /// The line or the element at fault.
        place: Place,
        /// What is wrong there.
        reason: Reason,
    },
    /// The file needs something that its format allows and this crate does not read.
    #[error("{}needs {feature}, which is not supported", Location { path, format: *format, place: *place })]
    Unsupported {
        /// What it was read as.
        format: Format,
        /// The file, where [`load`](crate::load) was asked for one.
        path: Option<PathBuf>,
        /// The element that needs it.
        place: Place,
        /// What is needed, such as the name of a glTF extension.
        feature: String,
    },
    /// The file is packed with gzip, and cannot be unpacked.
    #[error("{}gzip: {problem}", Colon(path))]
    Gzip {
        /// The file, where [`load`](crate::load) was asked for one.
        path: Option<PathBuf>,
        /// What is wrong with it.
        problem: String,
    },
    /// A mesh was asked for in a format that is only read.
    #[error("{}{format} is read, but not written; written are {}", Colon(path), Format::list_written())]
    ReadOnly {
        /// What was asked for.
        format: Format,
        /// The file, where [`save`](crate::save) was asked for one.
        path: Option<PathBuf>,
    },
    /// Lines were asked for in a format that has none, or in which they are not written.
    #[error("{}lines and points are written as .obj and .ply, not as {format}", Colon(path))]
    NoLines {
        /// What was asked for.
        format: Format,
        /// The file, where [`Lines::save`](crate::Lines::save) was asked for one.
        path: Option<PathBuf>,
    },
    /// The mesh could not be written. Where it is a file, what was there before is still there.
    #[error("{}{source}", Colon(path))]
    Write {
        /// The file, where [`save`](crate::save) was asked for one.
        path: Option<PathBuf>,
        /// What the system said.
        source: io::Error,
    },
    /// Memory ran out.
    #[error("{}out of memory: {bytes} bytes", Colon(path))]
    OutOfMemory {
        /// The file, where [`load`](crate::load) was asked for one.
        path: Option<PathBuf>,
        /// The size of the one array that did not fit.
        bytes: usize,
    },
}

impl Error {
    /// The same error, naming the file; errors of the system name the one that they are about already.
    pub(crate) fn in_file(mut self, file: &Path) -> Self {
        match &mut self {
            Self::Io { path, named_in, .. } if *path != *file => *named_in = Some(file.to_owned()),
            Self::Io { .. } => {}
            Self::UnknownFormat { path }
            | Self::Malformed { path, .. }
            | Self::Unsupported { path, .. }
            | Self::Gzip { path, .. }
            | Self::ReadOnly { path, .. }
            | Self::NoLines { path, .. }
            | Self::Write { path, .. }
            | Self::OutOfMemory { path, .. } => *path = Some(file.to_owned()),
        }
        self
    }

    pub(crate) fn malformed(format: Format, place: Place, reason: Reason) -> Self {
        Self::Malformed { format, path: None, place, reason }
    }
}

/// What is wrong at a place.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum Reason {
    /// A corner of a face is no vertex of the file.
    #[error("face names vertex {index}, but there are {vertices}")]
    IndexOutOfRange {
        /// The index as the file writes it; it may be too large for any integer type.
        index: String,
        /// How many vertices there are; for a negative index, how many come before it.
        vertices: usize,
    },
    /// A corner of a face is 0, in a format that counts from 1.
    #[error("face names vertex 0, but vertices are counted from 1")]
    IndexZero,
    /// A word that should be an index is none.
    #[error("`{word}` is not a vertex index")]
    BadIndex {
        /// The word, or its beginning.
        word: String,
    },
    /// A word that should be a number is none.
    #[error("`{word}` is not a number")]
    BadNumber {
        /// The word, or its beginning.
        word: String,
    },
    /// A word or a number that cannot stand where it does.
    #[error("`{word}` is not {expected}")]
    BadWord {
        /// The word, or its beginning.
        word: String,
        /// What should stand there.
        expected: &'static str,
    },
    /// A declaration in a header contradicts another one, or is missing.
    #[error("`{name}` {problem}")]
    Declaration {
        /// What is declared, or its beginning.
        name: String,
        /// What is wrong with it.
        problem: &'static str,
    },
    /// A text file ends where something is not complete.
    #[error("the file ends before {item} does")]
    Ends {
        /// What was read when it ended.
        item: Item,
    },
    /// A vertex with fewer than three coordinates.
    #[error("a vertex needs 3 coordinates, but has {found}")]
    TooFewCoordinates {
        /// How many it has.
        found: usize,
    },
    /// Fewer elements than the file says it has.
    #[error("only {present} of {declared} declared {what} are there")]
    Missing {
        /// What there is too little of, in the plural.
        what: &'static str,
        /// How many the file says it has.
        declared: u64,
        /// How many there are.
        present: usize,
    },
    /// A loop of an ASCII STL file that is no triangle.
    #[error("a loop needs 3 vertices, but has {found}")]
    LoopSize {
        /// How many it has.
        found: usize,
    },
    /// Nothing in the file looks like its format.
    #[error("this is not {expected}")]
    NotThisFormat {
        /// What it should have been.
        expected: &'static str,
    },
    /// The format has versions, and this is one that is not read.
    #[error("version {version:?} is not supported, only 2 is")]
    Version {
        /// The version that the file claims.
        version: String,
    },
    /// A glTF document asks for a reader of a later version.
    #[error("asset.minVersion is {version:?}, but only 2.0 is read")]
    MinVersion {
        /// The version that the document asks for, or the beginning of what stands there.
        version: String,
    },
    /// Something ends before it should, by its length in bytes.
    #[error("{item} needs {needed} byte{}, but there are {available}", if *needed == 1 { "" } else { "s" })]
    TooShort {
        /// What ends too early.
        item: Item,
        /// Bytes that it should have.
        needed: u64,
        /// Bytes that are there.
        available: u64,
    },
    /// A reference to an element that does not exist.
    #[error("names {item}, but there are {count}")]
    NoSuchItem {
        /// What is named.
        item: Item,
        /// How many of its kind there are.
        count: usize,
    },
    /// An element whose fields do not fit its use.
    #[error("{item}: {problem}")]
    BadItem {
        /// The element.
        item: Item,
        /// What does not fit.
        problem: &'static str,
    },
    /// The JSON is none, or lacks a field, or has a field of the wrong type.
    #[error("bad JSON: {message}")]
    Json {
        /// What the JSON reader said, with line and column.
        message: String,
    },
    /// The XML is none, or is not well-formed.
    #[error("bad XML: {message}")]
    Xml {
        /// What is wrong with it.
        message: String,
    },
    /// A bracket or a quotation mark without its counterpart.
    #[error("`{mark}` has no counterpart")]
    Unbalanced {
        /// The mark that stands alone.
        mark: char,
    },
    /// A `USE` in X3D or VRML of a name that no `Coordinate` has, or in VRML none before it.
    #[error("USE of `{name}`, but no Coordinate of that name is defined")]
    UnknownName {
        /// The name, or its beginning.
        name: String,
    },
    /// A reference to another file that is not followed.
    #[error("`{uri}` is not opened: {problem}")]
    Uri {
        /// The reference, or its beginning.
        uri: String,
        /// Why it is not opened.
        problem: &'static str,
    },
    /// More vertices or faces than `u32` can name.
    #[error("more than {} vertices or faces", u32::MAX)]
    TooMany,
    /// The mesh would be out of all proportion to the file.
    #[error(
        "the mesh would have {elements} vertices and faces, far more than the file's {bytes} bytes justify"
    )]
    OutOfProportion {
        /// Vertices and faces, counted together.
        elements: u64,
        /// Bytes of the file and of all its buffers.
        bytes: u64,
    },
    /// A mesh to be written has an attribute for another number of vertices or faces.
    #[error("attribute `{name}` has {found} values, but there are {needed} elements")]
    AttributeLength {
        /// Its name.
        name: String,
        /// Vertices or faces of the mesh.
        needed: usize,
        /// Values of the attribute.
        found: usize,
    },
    /// A mesh to be written has an infinite value or a NaN, and the format allows none.
    #[error("{what} is not finite, which the format does not allow")]
    NotFinite {
        /// The attribute that it is in, or `position`.
        what: String,
    },
    /// A mesh to be written is larger than the format can say.
    #[error("the file would have {bytes} bytes, but one of this format has at most {most}")]
    TooLarge {
        /// Bytes that it would have.
        bytes: u64,
        /// Bytes that it may have.
        most: u64,
    },
    /// Attributes beside the faces do not belong to them.
    #[error("attributes do not match the faces: {problem}")]
    Attributes {
        /// What does not match.
        problem: String,
    },
    /// A part of a `.ring` file is not what it should be.
    #[error("{part}: {problem}")]
    Ring {
        /// The header, or a section with its name.
        part: String,
        /// What is wrong with it.
        problem: String,
    },
}

impl Reason {
    /// The place, unless this names it anyway.
    fn place_to_say(&self, place: Place) -> Place {
        match (self, place) {
            (
                Self::TooShort { item: Item::Buffer(item), .. }
                | Self::BadItem { item: Item::Buffer(item), .. },
                Place::Buffer(buffer),
            ) if *item == buffer => Place::File,
            _ => place,
        }
    }
}

/// `path: `, or nothing.
struct Colon<'a>(&'a Option<PathBuf>);

impl fmt::Display for Colon<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|path| write!(f, "{}: ", name_of(path)))
    }
}

/// `path:line: ` as compilers write it, `path: element: `, or `OBJ line 3: ` where there is no path.
struct Location<'a> {
    path: &'a Option<PathBuf>,
    format: Format,
    place: Place,
}

impl fmt::Display for Location<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.path, self.place) {
            (Some(path), Place::File) => write!(f, "{}: ", name_of(path)),
            (Some(path), Place::Line(line)) => write!(f, "{}:{line}: ", name_of(path)),
            (Some(path), place) => write!(f, "{}: {place}: ", name_of(path)),
            (None, Place::File) => write!(f, "{}: ", self.format),
            (None, place) => write!(f, "{} {place}: ", self.format),
        }
    }
}

/// Words quoted in an error are cut here: a file may hold one word of a gigabyte.
const QUOTED: usize = 60;

/// The word as text of one line; bytes that are no UTF-8 become replacement characters.
pub(crate) fn quote(word: &[u8]) -> String {
    let cut = &word[..word.len().min(QUOTED)];
    let dots = if cut.len() < word.len() { "..." } else { "" };
    one_line(&String::from_utf8_lossy(cut)) + dots
}

fn name_of(path: &Path) -> String {
    one_line(&path.display().to_string())
}

/// The text without what a file or its name could play tricks with on a terminal: control characters, line ends, and
/// marks that turn the direction of writing become replacement characters.
pub fn one_line(text: &str) -> String {
    let is_trick = |c: char| {
        c.is_control()
            || matches!(c, '\u{200E}' | '\u{200F}' | '\u{2028}'..='\u{202E}' | '\u{2066}'..='\u{2069}' | '\u{FEFF}')
    };
    text.replace(is_trick, "\u{FFFD}")
}

//! PLY, the polygon file format of Stanford University: text or binary.

mod encoding;
mod writer;

pub(crate) use self::writer::write;

//! The names of formats, as words on the command line and in the help.

use super::fail;
use crate::input;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use onering_io::Format;
use std::path::Path;

/// `.obj, .gltf, .glb`: how the names of files end that can be read.
pub(super) fn read() -> String {
    dotted(|_| true)
}

/// How the names of files end that can be written.
pub(crate) fn written() -> String {
    dotted(is_written)
}

/// Whether it can be written: the files of `io`, and onering's own.
pub(crate) fn is_written(format: Format) -> bool {
    format.is_written() || format == Format::Ring
}

/// A format that is read, as an argument.
pub(super) fn parse_read() -> impl TypedValueParser<Value = Format> {
    parser(|_| true)
}

/// A format that is written, as an argument.
pub(super) fn parse_written() -> impl TypedValueParser<Value = Format> {
    parser(is_written)
}

/// Refuses standard output without a format.
pub(super) fn check_output(output: Option<&Path>, to: Option<Format>) {
    if output.is_some_and(input::is_standard) && to.is_none() {
        fail(&format!(
            "standard output has no name that tells its format: add --to; written are {}",
            written()
        ));
    }
}

fn names(which: fn(Format) -> bool) -> impl Iterator<Item = &'static str> {
    Format::all().filter(move |format| which(*format)).flat_map(|format| format.extensions().iter().copied())
}

fn dotted(which: fn(Format) -> bool) -> String {
    names(which).map(|name| format!(".{name}")).collect::<Vec<_>>().join(", ")
}

/// Only names of formats get past the first step, so that the second has one for each.
fn parser(which: fn(Format) -> bool) -> impl TypedValueParser<Value = Format> {
    let values = PossibleValuesParser::new(names(which).map(PossibleValue::new));
    values.try_map(|name| Format::of_name(&name).ok_or("not the name of a format"))
}

//! `onering convert`: what can be said of it.

use super::{EXIT_CODES, fail, formats};
use crate::convert::{Attribute, Method, ring};
use crate::input;
use clap::builder::PossibleValuesParser;
use onering::registry::BACKENDS;
use onering_io::Format;
use std::path::PathBuf;

/// Convert a mesh from one format to another, and mend it on the way
///
/// The format of IN is told by its content, or else by its name, that of OUT by its name; `.gz` behind it packs it. OUT
/// appears whole or not at all, and may be IN. What was changed, and what OUT cannot hold, is said on standard error.
#[derive(Debug, clap::Args)]
#[command(after_help = EXIT_CODES)]
pub(crate) struct Convert {
    #[arg(value_name = "IN", help = in_help())]
    pub(crate) input: PathBuf,
    #[arg(value_name = "OUT", help = out_help())]
    pub(crate) output: PathBuf,
    /// The format of what is `-`: of OUT where that is, else of IN
    #[arg(long, value_name = "FORMAT", ignore_case = true, value_parser = formats::parse_read())]
    format: Option<Format>,
    /// The format of IN, whatever its name and its content
    #[arg(long, value_name = "FORMAT", ignore_case = true, value_parser = formats::parse_read())]
    from: Option<Format>,
    /// The format of OUT, whatever its name
    #[arg(long, value_name = "FORMAT", ignore_case = true, value_parser = formats::parse_written())]
    to: Option<Format>,
    /// Make vertices at equal positions one, before all else
    #[arg(long)]
    pub(crate) weld: bool,
    /// Make it a manifold that every backend accepts: drop degenerate and duplicate faces, orient, cut what is not
    /// manifold
    #[arg(long)]
    pub(crate) repair: bool,
    /// Fill holes of up to MAX_EDGES edges with triangles, after any repair; the outer border of a sheet is one too
    #[arg(long, value_name = "MAX_EDGES", num_args = 0..=1, require_equals = true, default_missing_value = "4096")]
    pub(crate) fill_holes: Option<usize>,
    /// Number vertices so that neighbours are close together, and sort faces by them: faster to walk on
    #[arg(long, value_name = "METHOD", num_args = 0..=1, require_equals = true, default_missing_value = "hilbert")]
    pub(crate) reorder: Option<Method>,
    /// Do not merge the corners of an STL file that have equal coordinates
    #[arg(long)]
    pub(crate) keep_corners: bool,
    /// Write these values as well, where OUT can hold them, and as colours where it has colours; the first is shown
    #[arg(long = "attribute", value_name = "NAME", value_delimiter = ',', long_help = attribute_help())]
    pub(crate) attributes: Vec<Attribute>,
    /// Text instead of bytes, where OUT can be either, as PLY can
    #[arg(long)]
    pub(crate) ascii: bool,
    /// The data structure whose arrays go into a `.ring` file [default: directed-edges-small]
    #[arg(long, value_name = "NAME", value_parser = PossibleValuesParser::new(BACKENDS.iter().map(|b| b.name)))]
    backend: Option<String>,
    /// Do not say what was changed
    #[arg(long, short)]
    pub(crate) quiet: bool,
}

impl Convert {
    /// The format that IN is said to have.
    pub(crate) fn input_format(&self) -> Option<Format> {
        self.from.or(self.format.filter(|_| !self.is_for_output()))
    }

    /// The format that OUT is said to have.
    pub(crate) fn output_format(&self) -> Option<Format> {
        self.to.or(self.format.filter(|_| self.is_for_output()))
    }

    /// Whose arrays go into a `.ring` file.
    pub(crate) fn backend(&self) -> &str {
        self.backend.as_deref().unwrap_or(ring::DEFAULT)
    }

    /// What `--format` is about.
    fn is_for_output(&self) -> bool {
        input::is_standard(&self.output)
    }

    pub(super) fn check(&self) {
        let is_standard = [&self.input, &self.output].map(|path| input::is_standard(path));
        if self.format.is_some() && is_standard == [false; 2] {
            fail("--format is for standard input and output (`-`): for files there are --from and --to");
        }
        if is_standard[1] && self.output_format().is_none() {
            let written = formats::written();
            fail(&format!(
                "standard output has no name that tells its format: add --format; written are {written}"
            ));
        }
        let is_ring =
            self.output_format().map_or(ring::is_named(&self.output), |format| format == Format::Ring);
        if self.backend.is_some() && !is_ring {
            fail("--backend is for `.ring` files: other formats hold no data structure");
        }
    }
}

fn in_help() -> String {
    format!("A mesh file: {}, also packed with gzip; `-` is standard input", formats::read())
}

fn out_help() -> String {
    format!(
        "The file to write: {}, each but .ring also with .gz behind it; `-` is standard output",
        formats::written()
    )
}

fn attribute_help() -> String {
    let about = Attribute::HELP.map(|(name, about)| format!("\n  {name:<13}{about}"));
    format!(
        "Write these values as well, where OUT can hold them, and as colours where it has colours; the first is shown:{}",
        about.concat()
    )
}

//! `onering inspect`: what can be said of it.

use super::{EXIT_CODES, fail, formats};
use crate::input;
use onering_io::Format;
use std::path::PathBuf;

/// Tell what is in mesh files: counts, defects, topology, size
///
/// First a verdict: closed manifold, open manifold, or needs repair and why. Figures are given for the mesh as loaded,
/// and again with vertices at equal positions welded. Positions are 32-bit floats, each rounded once from the file;
/// area and volume are summed in 64 bits.
#[derive(Debug, clap::Args)]
#[command(after_help = EXIT_CODES)]
pub(crate) struct Inspect {
    #[arg(value_name = "FILE", required = true, help = files_help())]
    pub(crate) files: Vec<PathBuf>,
    /// The format of standard input, where its content does not tell
    #[arg(long, value_name = "FORMAT", ignore_case = true, value_parser = formats::parse_read())]
    pub(crate) format: Option<Format>,
    /// Print one JSON object for each file, on a line of its own
    #[arg(long)]
    pub(crate) json: bool,
}

impl Inspect {
    pub(super) fn check(&self) {
        let dashes = self.files.iter().filter(|file| input::is_standard(file)).count();
        if dashes > 1 {
            fail("standard input (`-`) can be read once only");
        }
        if self.format.is_some() && dashes == 0 {
            fail("--format is for standard input (`-`): files tell their format");
        }
    }
}

fn files_help() -> String {
    format!("Mesh files: {}, also packed with gzip; `-` is standard input", formats::read())
}

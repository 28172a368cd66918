//! What every command says that works on one mesh in one structure: the file, its format, the backend.

use super::formats;
use crate::on_backend;
use clap::builder::PossibleValuesParser;
use onering_io::Format;
use std::path::PathBuf;

/// The mesh to work on, and the structure to hold it in.
#[derive(Debug, clap::Args)]
pub(crate) struct MeshFile {
    #[arg(value_name = "FILE", help = file_help())]
    pub(crate) file: Option<PathBuf>,
    /// The format of FILE, whatever its name and its content
    #[arg(long, value_name = "FORMAT", ignore_case = true, value_parser = formats::parse_read())]
    pub(crate) from: Option<Format>,
    /// The data structure to hold the mesh in; `searched` is none at all: every answer is searched for
    #[arg(long, value_name = "NAME", default_value = on_backend::DEFAULT,
          value_parser = PossibleValuesParser::new(on_backend::names()))]
    pub(crate) backend: String,
    /// Make vertices at equal positions one, before all else
    #[arg(long)]
    pub(crate) weld: bool,
    /// Make it a manifold that every backend accepts, first
    #[arg(long)]
    pub(crate) repair: bool,
}

fn file_help() -> String {
    format!(
        "A mesh file: {}, also packed with gzip; `-` is standard input. Without one, a mesh that is made here",
        formats::read()
    )
}

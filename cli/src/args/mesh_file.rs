//! What every command says that works on one mesh: the file, its format, what to mend; and the structure to hold it in.

use super::{fail, formats};
use crate::on_backend;
use clap::builder::PossibleValuesParser;
use onering_io::Format;
use std::fs;
use std::path::PathBuf;

/// The mesh to work on.
#[derive(Debug, clap::Args)]
pub(crate) struct MeshFile {
    #[arg(value_name = "FILE", help = file_help())]
    pub(crate) file: Option<PathBuf>,
    /// The format of FILE, whatever its name and its content
    #[arg(long, value_name = "FORMAT", ignore_case = true, value_parser = formats::parse_read())]
    pub(crate) from: Option<Format>,
    /// Make vertices at equal positions one, before all else
    #[arg(long)]
    pub(crate) weld: bool,
    /// Make it a manifold that every backend accepts, first
    #[arg(long)]
    pub(crate) repair: bool,
}

impl MeshFile {
    /// Refuses to write a picture, or what was found, over the mesh that is read.
    pub(super) fn spare(&self, outputs: &[(&str, &Option<PathBuf>)]) {
        // The same file by another name, or what a link leads to.
        let real = |path: &Option<PathBuf>| path.as_ref().and_then(|path| fs::canonicalize(path).ok());
        let Some(mesh) = real(&self.file) else { return };
        for (option, output) in outputs {
            if real(output).is_some_and(|output| output == mesh) {
                fail(&format!("{option} does not write to '{}': it is the mesh to read", mesh.display()));
            }
        }
    }
}

/// The structure to hold the mesh in.
#[derive(Debug, clap::Args)]
pub(crate) struct Structure {
    /// The data structure to hold the mesh in; `searched` is none at all: every answer is searched for
    #[arg(long, value_name = "NAME", default_value = on_backend::DEFAULT,
          value_parser = PossibleValuesParser::new(on_backend::names()))]
    pub(crate) backend: String,
}

fn file_help() -> String {
    format!(
        "A mesh file: {}, also packed with gzip; `-` is standard input. Without one, a mesh that is made here",
        formats::read()
    )
}

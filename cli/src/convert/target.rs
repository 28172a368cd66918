//! Where the mesh goes, and in which format.

use super::ring;
use crate::failure::Failure;
use crate::{args, input};
use onering_io::{Format, MeshRef, SaveOptions};
use std::fs;
use std::io;
use std::path::{Path, PathBuf};

/// A file or standard output, in a format that is written.
#[derive(Debug)]
pub(crate) struct Target {
    /// `None` for standard output.
    path: Option<PathBuf>,
    format: Format,
    /// Whose arrays go into a `.ring` file.
    backend: String,
    how: SaveOptions,
}

impl Target {
    /// What the options ask for, as far as it can be written.
    pub(crate) fn of(options: &args::Convert) -> Result<Self, Failure> {
        Self::new(&options.output, options.output_format(), options.backend(), options.ascii)
    }

    /// A file of this name, or standard output where it is `-`; in the format that is given, else that of the name.
    pub(crate) fn new(
        output: &Path,
        format: Option<Format>,
        backend: &str,
        ascii: bool,
    ) -> Result<Self, Failure> {
        let path = (!input::is_standard(output)).then(|| output.to_owned());
        let by_name = || path.as_deref().and_then(Format::of_extension);
        let format = format.or_else(by_name).ok_or_else(|| unknown(output))?;
        if !args::is_written(format) {
            let (output, written) = (output.display(), args::written());
            let problem = format!("{output}: {format} is read, but not written; written are {written}");
            return Err(Failure::Usage(problem));
        }
        if format == Format::Ring && ring::is_packed(output) {
            let problem = "a .ring file is mapped into memory as it is, so it is not packed with gzip";
            return Err(Failure::Usage(format!("{}: {problem}", output.display())));
        }
        path.as_deref().map_or(Ok(()), check_folder)?;
        let mut how = SaveOptions::default();
        how.ascii = ascii;
        Ok(Self { path, format, backend: backend.into(), how })
    }

    pub(crate) fn format(&self) -> Format {
        self.format
    }

    /// Whether only vertices and edges will be there.
    pub(crate) fn loses_faces(&self) -> bool {
        self.format == Format::Ring && self.backend == "vertex-graph"
    }

    /// What to call it.
    pub(crate) fn name(&self) -> String {
        self.path.as_ref().map_or("standard output".into(), |path| path.display().to_string())
    }

    pub(crate) fn write(&self, mesh: MeshRef<'_>) -> Result<(), Failure> {
        let Self { path, format, backend, how } = self;
        if *format == Format::Ring {
            return ring::write(path.as_deref(), mesh, backend);
        }
        match path {
            Some(path) => {
                how.save_as(path, mesh, *format).map_err(|error| Failure::Output(error.to_string()))
            }
            None => how.write(io::stdout().lock(), mesh, *format).map_err(Failure::of_standard_output),
        }
    }
}

fn unknown(output: &Path) -> Failure {
    Failure::Usage(format!(
        "{}: its name tells no format that is written; those are {}, or say --to",
        output.display(),
        args::written(),
    ))
}

/// A name that cannot be written to is better known before the work than after it.
fn check_folder(path: &Path) -> Result<(), Failure> {
    let failure = |problem: String| Failure::Output(format!("{}: {problem}", path.display()));
    if path.is_dir() {
        return Err(failure("this is a directory".into()));
    }
    let folder = path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."));
    match fs::metadata(folder) {
        Err(error) => Err(failure(format!("its folder: {error}"))),
        Ok(about) if !about.is_dir() => Err(failure("what should be its folder is none".into())),
        Ok(_) => Ok(()),
    }
}

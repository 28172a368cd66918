//! `onering compare`: what can be said of it.

use super::{Args, Command, EXIT_CODES, fail, formats};
use crate::compare::subject::all_known;
use clap::Parser;
use onering_io::Format;
use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

/// Measure the data structures on meshes: memory, build time, queries
///
/// Each backend is built from the same list of triangles. Where it cannot hold the mesh as it is, it gets the
/// repaired one, and the report says so. All answers are checked against each other and against the plain
/// list; a difference is an error.
#[derive(Debug, clap::Args)]
#[command(after_help = EXIT_CODES)]
pub(crate) struct Compare {
    #[arg(value_name = "FILE", help = files_help())]
    pub(crate) files: Vec<PathBuf>,
    /// Measure these backends only [default: all]
    #[arg(long = "backend", value_name = "NAME", num_args = 1.., value_delimiter = ',', long_help = backend_help())]
    pub(crate) backends: Vec<String>,
    /// Write everything that was measured to this file as JSON; never over a mesh
    #[arg(long, value_name = "FILE")]
    pub(crate) json: Option<PathBuf>,
    /// Write a page with tables and plots to this file: a single file that needs no network; never over a mesh. For it,
    /// spheres of growing size are measured as well, for some 300 budgets
    #[arg(long, value_name = "FILE", conflicts_with = "deform")]
    pub(crate) html: Option<PathBuf>,
    /// Choose the random vertices and faces
    #[arg(long, value_name = "NUMBER", default_value_t = 2016)]
    pub(crate) seed: u64,
    /// Time to spend on each figure, of three runs at least after one to warm up; what is quadratic and takes over
    /// eight times as long is run once, and everything is with 0
    #[arg(long, value_name = "MILLISECONDS", default_value_t = 40)]
    pub(crate) budget: u64,
    /// Do what takes quadratic time on meshes up to this size: build without a hash table, answer without a structure
    /// [default: 6000, with --deform 50000]
    #[arg(long, value_name = "TRIANGLES")]
    quadratic_up_to: Option<usize>,
    /// Deform an organ that is made here, at five sizes from 200 to 20,000 vertices, and tell how long its neighbours
    /// and the whole deformation take, as in Figs. 18 to 21 of Biscaro et al. (2016)
    #[arg(long, conflicts_with_all = ["files", "seed"])]
    pub(crate) deform: bool,
    /// Draw what --deform measures into this SVG file; never over a mesh
    #[arg(long, value_name = "FILE", requires = "deform")]
    pub(crate) plot: Option<PathBuf>,
}

impl Default for Compare {
    fn default() -> Self {
        let args = Args::parse_from(["onering", "compare"]);
        let Some(Command::Compare(compare)) = args.command else { unreachable!("it says `compare`") };
        compare
    }
}

impl Compare {
    /// The structures asked for, as their places among all that are measured.
    pub(crate) fn chosen(&self) -> Vec<usize> {
        let asked = |name: &str| self.backends.is_empty() || self.backends.iter().any(|asked| asked == name);
        all_known().zip(0..).filter(|(known, _)| asked(known.name)).map(|(_, place)| place).collect()
    }

    /// Up to how many triangles what takes quadratic time is done.
    pub(crate) fn quadratic_up_to(&self) -> usize {
        self.quadratic_up_to.unwrap_or(if self.deform { 50_000 } else { 6_000 })
    }

    /// Puts right what the parser could not know, and refuses what makes no sense.
    pub(super) fn check(&mut self) {
        give_back_files(self);
        check_backends(self);
        let outputs = [("--json", &self.json), ("--html", &self.html), ("--plot", &self.plot)];
        let outputs = outputs.into_iter().filter_map(|(option, path)| Some((option, path.as_deref()?)));
        let mut targets: Vec<(&str, PathBuf)> = Vec::new();
        for (option, path) in outputs {
            check_output(self, option, path);
            let target = real(path);
            if let Some((other, _)) = targets.iter().find(|(_, other)| *other == target) {
                fail(&format!("{other} and {option} cannot be one file"));
            }
            targets.push((option, target));
        }
    }
}

/// In `--backend che-l1 che-l2 cow.obj`, the last word is a file: no backend has a dot or a slash in its name.
fn give_back_files(compare: &mut Compare) {
    let given = !compare.backends.is_empty();
    let is_name = |word: &String| !word.contains(['.', '/', '\\']);
    let (names, files): (Vec<_>, Vec<_>) =
        std::mem::take(&mut compare.backends).into_iter().partition(is_name);
    if given && names.is_empty() {
        fail(&format!("--backend needs a name; {}", known_backends()));
    }
    compare.backends = names;
    compare.files.extend(files.into_iter().map(PathBuf::from));
}

fn check_backends(compare: &Compare) {
    for name in &compare.backends {
        let Some(known) = all_known().find(|known| known.name == name) else {
            fail(&format!("no backend is named '{name}'; {}", known_backends()));
        };
        if compare.deform && known.renumbers {
            fail(&format!("--deform does not measure {name}, which gives vertices other numbers"));
        }
    }
}

/// The names of all backends.
fn known_backends() -> String {
    let names: Vec<&str> = all_known().map(|known| known.name).collect();
    format!("the backends are {}", names.join(", "))
}

/// How the names of meshes end that are not read, and of what meshes refer to.
const OTHER_MESHES: &[&str] = &[
    "mtl", "bin", "ply", "stl", "off", "3ds", "3mf", "dae", "fbx", "wrl", "x3d", "msh", "vtk", "vtp", "tri",
    "ts", "usd", "usda", "usdc", "usdz", "ring",
];

/// A name that was meant as another mesh to read must not cost that mesh.
fn check_output(compare: &Compare, option: &str, output: &Path) {
    let target = real(output);
    let reason = if compare.files.iter().any(|file| real(file) == target) {
        "it is one of the meshes to read"
    } else if has_name_of_mesh(output) || has_name_of_mesh(&target) {
        "that is the name of a mesh"
    } else {
        return;
    };
    fail(&format!("{option} does not write to '{}': {reason}", output.display()));
}

/// The same for one file by whatever name, and for what a link leads to; also where there is no such file yet.
fn real(path: &Path) -> PathBuf {
    let new = || {
        let folder = path.parent().filter(|folder| *folder != "").unwrap_or(Path::new("."));
        Some(fs::canonicalize(folder).ok()?.join(path.file_name()?))
    };
    fs::canonicalize(path).ok().or_else(new).unwrap_or_else(|| path.to_owned())
}

fn has_name_of_mesh(path: &Path) -> bool {
    let is_other = |end: &OsStr| OTHER_MESHES.iter().any(|mesh| end.eq_ignore_ascii_case(mesh));
    Format::of_extension(path).is_some() || path.extension().is_some_and(is_other)
}

fn files_help() -> String {
    let read = formats::read();
    format!(
        "Mesh files: {read}; without any, three made on the spot, of 2,106 and twice over 80,000 triangles"
    )
}

fn backend_help() -> String {
    format!("Measure these backends only; {} [default: all]", known_backends())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_after_the_names_of_backends_is_a_file() {
        let backends = ["che-l1", "che-l2", "./cow.obj"].map(String::from).into();
        let mut compare = Compare { backends, ..Compare::default() };
        give_back_files(&mut compare);
        assert_eq!(compare.backends, ["che-l1", "che-l2"]);
        assert_eq!(compare.files, [PathBuf::from("./cow.obj")]);
        assert_eq!(compare.chosen().len(), 2);
    }
}

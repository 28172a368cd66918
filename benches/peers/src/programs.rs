//! Which process runs which structure: this program the Rust libraries, those of `cpp/` the libraries in C++.

use crate::mesh::Mesh;
use crate::peer;
use crate::process::Program;
use std::error::Error;
use std::path::{Path, PathBuf};
use std::process::Command;

/// What `cpp/build.sh` makes: the name here, and that of the program.
const CPP: [(&str, &str); 4] = [
    ("OpenMesh", "openmesh"),
    ("CGAL Surface_mesh", "cgal"),
    ("pmp SurfaceMesh", "pmp"),
    ("meshoptimizer adjacency", "meshoptimizer"),
];

/// All structures whose name contains one of `only`, or all; says which programs in C++ are not built.
pub(crate) fn all(only: &[String]) -> Vec<Program> {
    let is_asked = |name: &str| only.is_empty() || only.iter().any(|part| name.contains(part));
    let rust = peer::peers().filter(|peer| is_asked(peer.name));
    let rust = rust.map(|peer| Program { name: peer.name.into(), command: this_program });
    let cpp = CPP.into_iter().filter(|(name, _)| is_asked(name));
    let built = cpp.filter(|(name, program)| {
        let is_built = cpp_program(program).is_file();
        if !is_built {
            eprintln!("{name}: left out: benches/peers/cpp/build.sh has not built it");
        }
        is_built
    });
    rust.chain(built.map(|(name, _)| Program { name: name.into(), command: program_in_cpp })).collect()
}

fn this_program(name: &str, mesh: &Path) -> Command {
    let mut command = Command::new(std::env::current_exe().unwrap_or_else(|_| "onering-bench-peers".into()));
    command.arg("--child").arg(name).arg("--file").arg(mesh);
    command
}

fn program_in_cpp(name: &str, mesh: &Path) -> Command {
    let program = CPP.iter().find(|(other, _)| *other == name).map_or(name, |(_, program)| program);
    let mut command = Command::new(cpp_program(program));
    command.arg(mesh);
    command
}

fn cpp_program(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("cpp/target").join(name)
}

/// Measures one structure in this process and prints what came of it.
pub(crate) fn child(name: &str, file: &Path) -> Result<(), Box<dyn Error>> {
    let peer = peer::peers().find(|peer| peer.name == name).ok_or("no such structure")?;
    let run = (peer.run)(&Mesh::read(file)?)?;
    println!("{}", serde_json::to_string(&run)?);
    Ok(())
}

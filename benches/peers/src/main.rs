//! How fast onering builds and walks meshes, and in how much memory, beside other libraries in one run.
//!
//! Every structure is built from the same arrays, and the one-rings of all its vertices are walked; the answers are
//! compared with what a sort of all edges says. Each run is a process of its own. The README of the repository has the
//! command; `cpp/install.sh` and `cpp/build.sh` add the libraries in C++.

#[path = "../../../cli/src/heap.rs"]
mod heap;
mod measure;
mod mesh;
mod meshes;
mod peer;
mod process;
mod programs;
mod report;

use clap::Parser;
use std::error::Error;
use std::path::PathBuf;
use std::time::Duration;

#[global_allocator]
static HEAP: heap::Counting = heap::Counting;

/// Measure structures for triangle meshes.
#[derive(Debug, Parser)]
struct Args {
    /// Only these meshes, such as `ico-1.3M,ico-1.3M-shuffled`; all where none is named
    #[arg(long, value_delimiter = ',')]
    mesh: Vec<String>,
    /// Only structures whose name contains one of these, such as `onering,lox`
    #[arg(long, value_delimiter = ',')]
    only: Vec<String>,
    /// Rounds in which every structure is measured once; medians are shown
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..))]
    runs: u16,
    /// Seconds that a structure may take for a run
    #[arg(long, default_value_t = 120)]
    limit: u64,
    /// Where `stanford_bunny.obj` and `mni152_isosurface_963k.ply` are
    #[arg(long, env = "ONERING_MESHES")]
    folder: Option<PathBuf>,
    /// Where the meshes go from process to process, and are removed at the end
    #[arg(long, default_value_os_t = std::env::temp_dir())]
    temporary: PathBuf,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
    /// Tiny meshes, once, and an error where a structure fails
    #[arg(long)]
    test: bool,
    /// Measure this one structure in this process
    #[arg(long, hide = true, requires = "file")]
    child: Option<String>,
    #[arg(long, hide = true)]
    file: Option<PathBuf>,
}

fn main() -> Result<(), Box<dyn Error>> {
    let args = Args::parse();
    if let (Some(name), Some(file)) = (&args.child, &args.file) {
        return programs::child(name, file);
    }
    if !args.test && !cfg!(target_feature = "avx2") {
        eprintln!(
            "compiled for any processor: set RUSTFLAGS=\"-C target-cpu=native\", as the C++ programs are"
        );
    }
    let programs = programs::all(&args.only);
    let file = args.temporary.join(format!("onering-bench-peers-{}", std::process::id()));
    let tables = tables(&args, &programs, &file);
    let _ = std::fs::remove_file(&file);
    let tables = tables?;
    if args.json {
        println!("{}", serde_json::to_string_pretty(&tables)?);
    }
    let failed: Vec<_> =
        tables.iter().flat_map(|table| &table.rows).filter(|row| row.medians().is_none()).collect();
    if args.test && !failed.is_empty() {
        return Err(format!("{} runs failed: {failed:?}", failed.len()).into());
    }
    Ok(())
}

fn tables(
    args: &Args,
    programs: &[process::Program],
    file: &std::path::Path,
) -> Result<Vec<report::Table>, Box<dyn Error>> {
    let named = if args.test { meshes::TINY } else { meshes::MESHES };
    let unknown = args.mesh.iter().find(|name| named.iter().all(|mesh| mesh.name != *name));
    if let Some(unknown) = unknown {
        let names: Vec<_> = named.iter().map(|mesh| mesh.name).collect();
        return Err(format!("no mesh {unknown}: there are {}", names.join(", ")).into());
    }
    let rounds = if args.test { 1 } else { args.runs.into() };
    let mut tables = Vec::new();
    for named in
        named.iter().filter(|named| args.mesh.is_empty() || args.mesh.iter().any(|name| name == named.name))
    {
        let (mesh, rings) = match named.make(args.folder.as_deref()) {
            Ok(made) => made,
            Err(reason) => {
                eprintln!("{}: left out: {reason}", named.name);
                continue;
            }
        };
        mesh.write(file)?;
        let (triangles, vertices) = (mesh.faces.len(), mesh.positions.len());
        // The processes need the memory.
        drop(mesh);
        let rows = measure::mesh(programs, file, &rings, rounds, Duration::from_secs(args.limit));
        let table = report::Table { mesh: named.name, triangles, vertices, rows };
        if !args.json {
            print!("{}", table.markdown());
        }
        tables.push(table);
    }
    Ok(tables)
}

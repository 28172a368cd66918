//! How fast onering builds and walks meshes, and in how much memory, beside other libraries in one run.
//!
//! Every structure is built from the same arrays, the one-rings of all its vertices are walked and 4-rings searched; the
//! answers are compared with what a sort of all edges says. Each run is a process of its own. docs/performance.md has
//! the command; `cpp/install.sh` and `cpp/build.sh` add the libraries in C++.

mod expected;
#[allow(dead_code, reason = "the shell asks for more")]
#[path = "../../../cli/src/heap.rs"]
mod heap;
mod machine;
mod measure;
mod mesh;
mod meshes;
mod peer;
mod plots;
mod process;
mod programs;
mod record;
mod report;
#[path = "../../meshes/mod.rs"]
mod shared;

use clap::Parser;
use measure::Effort;
use record::{Record, Table};
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::time::Duration;

#[global_allocator]
static HEAP: heap::Counting = heap::Counting;

/// Measure structures for triangle meshes.
#[derive(Debug, Parser)]
struct Args {
    /// Only these meshes, such as `ico-1.3M,ico-1.3M-shuffled`; all where none is named
    #[arg(long, value_delimiter = ',')]
    meshes: Vec<String>,
    /// Only structures whose name contains one of these, such as `onering,lox`
    #[arg(long, value_delimiter = ',')]
    peers: Vec<String>,
    /// Rounds in which every structure is measured once; medians are shown
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u16).range(1..))]
    runs: u16,
    /// Seconds that a structure may take for one run; beyond, it is left out on this mesh and on larger ones
    #[arg(long, default_value_t = 60)]
    limit: u64,
    /// Seconds for all runs of a structure on a mesh: slow ones are measured fewer times
    #[arg(long, default_value_t = 20)]
    budget: u64,
    /// Where `stanford_bunny.obj` and `mni152_isosurface_963k.ply` are
    #[arg(long, env = "ONERING_MESHES")]
    folder: Option<PathBuf>,
    /// Where the meshes go from process to process, and are removed at the end
    #[arg(long, default_value_os_t = std::env::temp_dir())]
    temporary: PathBuf,
    /// Keep what is measured in this file: what it has is not measured again
    #[arg(long)]
    json: Option<PathBuf>,
    /// Write all that the file of JSON has as tables in Markdown, instead of printing what was measured
    #[arg(long)]
    table: Option<PathBuf>,
    /// Draw all that the file of JSON has into this folder
    #[arg(long)]
    plots: Option<PathBuf>,
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
    let machine = machine::describe();
    let mut record = match &args.json {
        Some(file) => Record::read(file, &machine)?,
        None => Record { machine, meshes: Vec::new() },
    };
    let file = args.temporary.join(format!("onering-bench-peers-{}", std::process::id()));
    let measured = measure(&args, &file, &mut record);
    let _ = fs::remove_file(&file);
    measured?;
    if let Some(file) = &args.table {
        fs::write(file, report::markdown(&record))?;
    }
    if let Some(folder) = &args.plots {
        fs::create_dir_all(folder)?;
        plots::draw(&record, folder)?;
    }
    let failed: Vec<_> =
        record.meshes.iter().flat_map(|table| &table.rows).filter(|row| row.left_out.is_some()).collect();
    if args.test && !failed.is_empty() {
        return Err(format!("{} runs failed: {failed:?}", failed.len()).into());
    }
    Ok(())
}

/// Adds to the record what it lacks of what was asked for.
fn measure(args: &Args, file: &Path, record: &mut Record) -> Result<(), Box<dyn Error>> {
    let programs = programs::all(&args.peers);
    let effort = Effort {
        rounds: if args.test { 1 } else { args.runs.into() },
        limit: Duration::from_secs(args.limit),
        budget: Duration::from_secs(args.budget),
    };
    for named in meshes::asked(&args.meshes, args.test)? {
        let before = record.table(named.name);
        let is_done = |program: &process::Program| {
            before.and_then(|table| table.row(&program.name)).is_some_and(|row| effort.is_done(row))
        };
        if programs.iter().all(is_done) {
            continue;
        }
        let (mesh, expected) = match named.make(args.folder.as_deref()) {
            Ok(made) => made,
            Err(reason) => {
                eprintln!("{}: left out: {reason}", named.name);
                continue;
            }
        };
        mesh.write(file)?;
        let mut table = before.cloned().unwrap_or_else(|| Table {
            mesh: named.name.into(),
            triangles: mesh.faces.len(),
            vertices: mesh.positions.len(),
            four_rings: mesh.queries.len(),
            rows: Vec::new(),
        });
        // The processes need the memory.
        drop(mesh);
        for program in &programs {
            let hopeless =
                record.hopeless(&program.name, table.triangles).filter(|reason| effort.is_final(reason));
            let row = measure::row(&mut table, &program.name);
            row.left_out = row.left_out.take().or(hopeless);
        }
        measure::mesh(&programs, file, &expected, effort, &mut table, |table| {
            record.put(table);
            args.json.as_ref().map_or(Ok(()), |file| record.write(file))
        })?;
        if args.table.is_none() {
            print!("{}", report::table(&table));
        }
    }
    Ok(())
}

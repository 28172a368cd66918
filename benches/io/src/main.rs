//! How fast mesh files are read and written, and how much memory that takes, beside other libraries in one run.
//!
//! A mesh is made on the spot and written in every format to a temporary folder. Each library then reads the file
//! from there, from opening it to arrays in memory; the answers are compared. The time of `std::fs::read` stands
//! beside them: no reader that copies can be faster.
//!
//! ```sh
//! cargo run --release --manifest-path benches/io/Cargo.toml -- --triangles 1000000,10000000
//! ```

mod files;
#[allow(dead_code, reason = "the shell asks for more")]
#[path = "../../../cli/src/heap.rs"]
mod heap;
mod libraries;
mod measure;
mod report;
mod shape;

use clap::Parser;
use std::error::Error;
use std::path::PathBuf;

#[global_allocator]
static HEAP: heap::Counting = heap::Counting;

/// Measure readers and writers of mesh files.
#[derive(Debug, Parser)]
struct Args {
    /// About how many triangles the meshes have
    #[arg(long, value_delimiter = ',', default_value = "1000000")]
    triangles: Vec<usize>,
    /// Only formats whose name contains this, such as `PLY`
    #[arg(long, default_value = "")]
    only: String,
    /// Runs of each reader after one to warm up; the median is shown
    #[arg(long, default_value_t = 5)]
    runs: usize,
    /// Where the files are written, and removed at the end
    #[arg(long, default_value_os_t = std::env::temp_dir())]
    folder: PathBuf,
    /// Print JSON instead of tables
    #[arg(long)]
    json: bool,
}

fn main() -> Result<(), Box<dyn Error>> {
    let args = Args::parse();
    let folder = files::Folder::create(&args.folder)?;
    let mut all = Vec::new();
    for &triangles in &args.triangles {
        let mesh = shape::sheet(triangles);
        let mut rows = Vec::new();
        for file in files::FILES.iter().filter(|file| file.name.contains(&args.only)) {
            rows.extend(measure::file(file, &mesh, folder.path(), args.runs)?);
        }
        if !args.json {
            print!("{}", report::table(&mesh, &rows));
        }
        all.extend(rows);
    }
    if args.json {
        println!("{}", serde_json::to_string_pretty(&all)?);
    }
    Ok(())
}

//! How fast meshes are written, beside `fs::write` of as many bytes in the same run: a torus of a million vertices
//! and two million triangles, or the files named on the command line. What is written goes to the folder for
//! temporary files.
//!
//! cargo run --release -p onering-io --example write_speed -- [file ...]

use std::error::Error;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use onering_io::{Format, MeshRef, SaveOptions, Triangles};

fn main() -> Result<(), Box<dyn Error>> {
    let mut meshes = Vec::new();
    for name in std::env::args().skip(1) {
        meshes.push((onering_io::load(&name)?, name));
    }
    if meshes.is_empty() {
        meshes.push((torus(1000), "torus of 1000 x 1000".into()));
    }
    println!("{:<24} {:<10} {:>8} {:>12} {:>14}", "mesh", "format", "MB", "save MB/s", "fs::write MB/s");
    for (mesh, name) in &meshes {
        for format in Format::all().filter(|format| format.is_written()) {
            row(name, mesh, format, false)?;
        }
        row(name, mesh, Format::Ply, true)?;
    }
    Ok(())
}

fn row(name: &str, mesh: &Triangles, format: Format, ascii: bool) -> Result<(), Box<dyn Error>> {
    let path = temporary(format);
    let mut options = SaveOptions::default();
    options.ascii = ascii;
    let ours = best(|| Ok(options.save(&path, MeshRef::from(mesh))?))?;
    let bytes = std::fs::read(&path)?;
    let plain = best(|| write_and_sync(&path, &bytes))?;
    std::fs::remove_file(&path)?;
    let megabytes = bytes.len() as f64 / 1e6;
    let [ours, plain] = [ours, plain].map(|time| megabytes / time.as_secs_f64());
    let format = format!("{format}{}", if ascii { " ascii" } else { "" });
    println!("{name:<24} {format:<10} {megabytes:>8.1} {ours:>12.0} {plain:>14.0}");
    Ok(())
}

fn temporary(format: Format) -> PathBuf {
    let name = format!("onering-write-speed-{}.{}", std::process::id(), format.extensions()[0]);
    std::env::temp_dir().join(name)
}

/// As safe as what it is compared with: `save` has its file on the disk too.
fn write_and_sync(path: &Path, bytes: &[u8]) -> Result<(), Box<dyn Error>> {
    std::fs::write(path, bytes)?;
    Ok(std::fs::File::open(path)?.sync_all()?)
}

/// The shortest of five runs: what other programs take from the machine only ever adds to it.
fn best(run: impl Fn() -> Result<(), Box<dyn Error>>) -> Result<Duration, Box<dyn Error>> {
    let mut best = Duration::MAX;
    for _ in 0..5 {
        let start = Instant::now();
        run()?;
        best = best.min(start.elapsed());
    }
    Ok(best)
}

fn torus(side: u32) -> Triangles {
    let turn = |i: u32| (i as f32 / side as f32 * std::f32::consts::TAU).sin_cos();
    let position = |i: u32| {
        let ((sin_u, cos_u), (sin_v, cos_v)) = (turn(i / side), turn(i % side));
        [(2.0 + cos_v) * cos_u, (2.0 + cos_v) * sin_u, sin_v]
    };
    let vertex = |u: u32, v: u32| u % side * side + v % side;
    let faces = (0..side * side).map(|i| (i / side, i % side)).flat_map(|(u, v)| {
        let [a, b, c, d] = [vertex(u, v), vertex(u + 1, v), vertex(u + 1, v + 1), vertex(u, v + 1)];
        [[a, b, c], [a, c, d]]
    });
    Triangles::new((0..side * side).map(position).collect(), faces.collect())
}

//! How fast OBJ files are read, beside the crate tobj in the same run. Reads the files named on the command
//! line, or a grid of 1.5 million vertices and 3 million triangles that it makes up.
//!
//! cargo run --release -p onering-io --example read_speed -- [file.obj ...]
//!
//! With `--features parallel`, ours is read by as many threads as `RAYON_NUM_THREADS` says.

use std::fmt::Write;
use std::hint::black_box;
use std::time::{Duration, Instant};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let mut files: Vec<(String, Vec<u8>)> = Vec::new();
    for name in std::env::args().skip(1) {
        let bytes = std::fs::read(&name)?;
        files.push((name, bytes));
    }
    if files.is_empty() {
        files.push(("grid of 1225 x 1225".into(), grid(1225).into_bytes()));
    }
    println!("{:<30} {:>9} {:>12} {:>12}", "file", "MB", "ours MB/s", "tobj MB/s");
    for (name, bytes) in &files {
        let ours = best(|| onering_io::obj::read(bytes).map(drop).is_ok());
        let theirs = best(|| tobj_read(bytes).is_ok());
        let megabytes = bytes.len() as f64 / 1e6;
        let [ours, theirs] = [ours, theirs].map(|time| megabytes / time.as_secs_f64());
        println!("{name:<30} {megabytes:>9.1} {ours:>12.0} {theirs:>12.0}");
    }
    Ok(())
}

/// The shortest of five runs: what other programs take from the machine only ever adds to it.
fn best(run: impl Fn() -> bool) -> Duration {
    let time = || {
        let start = Instant::now();
        assert!(black_box(run()));
        start.elapsed()
    };
    std::iter::repeat_with(time).take(5).min().unwrap_or_default()
}

fn tobj_read(bytes: &[u8]) -> tobj::LoadResult {
    let options = tobj::LoadOptions { triangulate: true, ..Default::default() };
    tobj::load_obj_buf(&mut &bytes[..], &options, |_| Ok(Default::default()))
}

/// A wavy sheet of side x side vertices, written the way most programs write: six decimals.
fn grid(side: usize) -> String {
    let mut text = String::new();
    for (y, x) in (0..side * side).map(|i| (i / side, i % side)) {
        let [u, v] = [x, y].map(|i| i as f64 / side as f64 - 0.5);
        let _ = writeln!(text, "v {u:.6} {v:.6} {:.6}", (u * 20.0).sin() * (v * 30.0).cos() * 0.1);
    }
    for (y, x) in (0..(side - 1) * (side - 1)).map(|i| (i / (side - 1), i % (side - 1))) {
        let a = y * side + x + 1;
        let _ = writeln!(text, "f {a} {} {}\nf {a} {} {}", a + 1, a + side + 1, a + side + 1, a + side);
    }
    text
}

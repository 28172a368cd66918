//! Times opening a `.ring` file of CHE L2 beside reading it once and beside building the structure.
//!
//! `cargo bench --features mmap --bench ring_open -- 10000000`: the number of triangles of a grid. The times are the
//! medians of seven rounds, in which all ways take turns; the file is in the page cache. Not by criterion, as the figures asked
//! for are quotients of these. With `--test`, a small grid, once.
#![expect(unsafe_code, reason = "maps a file that nobody else knows")]
use onering::ring::{self, File};
use onering::{CheL2, FromFaces, Topology};
use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

/// A grid of squares cut in two, row after row.
fn grid(triangles: usize) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let columns = (triangles as f64 / 2.0).sqrt().ceil().max(1.0) as u32;
    let rows = (triangles as u32 / 2).div_ceil(columns).max(1);
    let vertices = (0..=rows).flat_map(|y| (0..=columns).map(move |x| [x as f32, y as f32, 0.0]));
    let cell = move |x: u32, y: u32| {
        let a = y * (columns + 1) + x;
        let (b, c, d) = (a + 1, a + columns + 2, a + columns + 1);
        [[a, b, c], [a, c, d]]
    };
    let faces = (0..rows).flat_map(|y| (0..columns).flat_map(move |x| cell(x, y)));
    (vertices.collect(), faces.collect())
}

/// A way to get at a mesh.
type Way<'a> = (&'a str, Box<dyn Fn() -> usize + 'a>);

fn ways<'a>(path: &'a Path, positions: &'a [[f32; 3]], faces: &'a [[u32; 3]]) -> Vec<Way<'a>> {
    let count = |file: &File| file.mesh::<CheL2>().expect("a good file").face_count();
    vec![
        ("std::fs::read", Box::new(move || black_box(std::fs::read(path).expect("a file")).len())),
        // SAFETY: nobody else knows the file, and it is not written to.
        ("open, validated", Box::new(move || count(&unsafe { File::open(path) }.expect("a good file")))),
        ("read, validated", Box::new(move || count(&File::read(path).expect("a good file")))),
        // SAFETY: as above, and the file was written by this program.
        ("open_trusted", Box::new(move || count(&unsafe { File::open_trusted(path) }.expect("a good file")))),
        (
            "build",
            Box::new(move || CheL2::from_faces(positions.len(), faces).expect("a manifold").face_count()),
        ),
    ]
}

fn main() {
    let is_test = std::env::args().any(|a| a == "--test");
    let asked = std::env::args().find_map(|a| a.parse().ok());
    let (triangles, rounds) = if is_test { (2_000, 1) } else { (asked.unwrap_or(10_000_000), 7) };
    let (positions, faces) = grid(triangles);
    let path = Path::new(env!("CARGO_TARGET_TMPDIR")).join("ring_open.ring");
    let mesh = CheL2::from_faces(positions.len(), &faces).expect("a manifold");
    ring::save(&path, &mesh, Some(&positions)).expect("room for the file");
    drop(mesh);
    let bytes = std::fs::metadata(&path).expect("the file").len();
    println!("{} triangles, {bytes} bytes", faces.len());

    let ways = ways(&path, &positions, &faces);
    let mut seconds = vec![Vec::new(); ways.len()];
    for _ in 0..rounds {
        for ((_, run), seconds) in ways.iter().zip(&mut seconds) {
            let start = Instant::now();
            black_box(run());
            seconds.push(start.elapsed().as_secs_f64());
        }
    }
    let medians: Vec<f64> = seconds.iter_mut().map(|s| median(s)).collect();
    println!("| way | seconds | of reading once | of building |\n|---|---|---|---|");
    for ((name, _), median) in ways.iter().zip(&medians) {
        println!("| {name} | {median:.6} | {:.2} | {:.5} |", median / medians[0], median / medians[4]);
    }
    drop(ways);
    std::fs::remove_file(&path).expect("the file");
}

fn median(seconds: &mut [f64]) -> f64 {
    seconds.sort_by(f64::total_cmp);
    seconds[seconds.len() / 2]
}

//! Building in fresh memory beside building in the memory of the mesh before, by turns in one process.
//!
//! `cargo bench --bench rebuild [-- MILLIONS]`: nanoseconds a triangle, medians, on meshes of up to ten million triangles, or
//! on a grid of so many million. With `--test` on a small mesh, to see that it runs.
#[path = "../meshes/mod.rs"]
mod meshes;

use meshes::{sphere, torus};
use onering::{Builder, CheL1, DirectedEdgesSmall, MateFace, Recycle};
use std::hint::black_box;
use std::time::Instant;

const ROUNDS: usize = 9;

/// Nanoseconds a triangle.
fn timed(faces: &[[u32; 3]], work: impl FnOnce()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_nanos() as f64 / faces.len() as f64
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

fn compare<M: Recycle>(name: &str, vertices: usize, faces: &[[u32; 3]]) {
    let mut builder = Builder::new();
    let (mut fresh, mut again) = (Vec::new(), Vec::new());
    let mut rebuild = || {
        let mesh: M = builder.build(vertices, faces).expect("it is a manifold");
        builder.recycle(black_box(mesh));
    };
    rebuild();
    for _ in 0..ROUNDS {
        fresh.push(timed(faces, || drop(black_box(M::from_faces(vertices, faces)))));
        again.push(timed(faces, &mut rebuild));
    }
    let (fresh, again) = (median(fresh), median(again));
    println!("  {name:22} fresh {fresh:6.1}  again {again:6.1}  {:.2} times as fast", fresh / again);
}

fn main() {
    let words: Vec<String> = std::env::args().collect();
    let meshes = if words.iter().any(|word| word == "--test") {
        vec![("icosphere, 1,280", sphere(3))]
    } else if let Some(millions) = words.iter().find_map(|word| word.parse::<u32>().ok()) {
        vec![("grid", torus(100 * millions, 5000))]
    } else {
        vec![
            ("icosphere, 1.3 M", sphere(8)),
            ("icosphere, 5.2 M", sphere(9)),
            ("grid, 10 M", torus(2500, 2000)),
        ]
    };
    for (name, (vertices, faces)) in meshes {
        println!("{name}, {} triangles", faces.len());
        compare::<CheL1>("CHE L1", vertices, &faces);
        compare::<DirectedEdgesSmall>("directed edges small", vertices, &faces);
        compare::<MateFace>("Mate-Face", vertices, &faces);
    }
}

//! Building in fresh memory beside building in the memory of the mesh before, by turns in one process.
//!
//! `cargo bench --bench rebuild`: nanoseconds a triangle, medians. With `--test` on a small mesh, to see that it runs.
use onering::{Builder, CheL1, DirectedEdgesSmall, MateFace, Recycle, conformance};
use std::collections::HashMap;
use std::hint::black_box;
use std::time::Instant;

const ROUNDS: usize = 9;

/// An icosahedron with every triangle divided into four, so many times.
fn icosphere(times: u32) -> (usize, Vec<[u32; 3]>) {
    let band = |i: u32| [1 + i % 5, 1 + (i + 1) % 5, 6 + i % 5, 6 + (i + 1) % 5];
    let faces = |[a, b, c, d]: [u32; 4]| [[0, a, b], [a, c, b], [b, c, d], [c, 11, d]];
    let mut faces: Vec<[u32; 3]> = (0..5).map(band).flat_map(faces).collect();
    let mut vertices = 12;
    for _ in 0..times {
        let mut middles = HashMap::new();
        let mut middle = |a: u32, b: u32| {
            *middles.entry((a.min(b), a.max(b))).or_insert_with(|| {
                vertices += 1;
                vertices - 1
            })
        };
        let four = |[a, b, c]: [u32; 3]| {
            let [ab, bc, ca] = [middle(a, b), middle(b, c), middle(c, a)];
            [[a, ab, ca], [b, bc, ab], [c, ca, bc], [ab, bc, ca]]
        };
        faces = faces.into_iter().flat_map(four).collect();
    }
    (vertices as usize, faces)
}

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
    let grid = |rows: u32, columns: u32| ((rows * columns) as usize, conformance::torus(rows, columns));
    let meshes = if std::env::args().any(|word| word == "--test") {
        vec![("icosphere, 1,280", icosphere(3))]
    } else {
        vec![
            ("icosphere, 1.3 M", icosphere(8)),
            ("icosphere, 5.2 M", icosphere(9)),
            ("grid, 10 M", grid(2000, 2500)),
        ]
    };
    for (name, (vertices, faces)) in meshes {
        println!("{name}");
        compare::<CheL1>("CHE L1", vertices, &faces);
        compare::<DirectedEdgesSmall>("directed edges small", vertices, &faces);
        compare::<MateFace>("Mate-Face", vertices, &faces);
    }
}

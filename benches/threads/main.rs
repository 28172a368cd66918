//! One thread of rayon beside two, by turns in one process: pairing, the check of fans, builds and sweeps over all
//! one-rings.
//!
//! `cargo bench --features parallel --bench threads [-- FILTER...]`: nanoseconds a triangle, medians of nine
//! and the best, of the meshes whose names have a filter in them. With `--test` on a small mesh, to see that it runs.
#[path = "../meshes/mod.rs"]
mod meshes;

use onering::fans::fans_into;
use onering::*;
use rayon::{ThreadPool, ThreadPoolBuilder, prelude::*};
use std::hint::black_box;
use std::time::Instant;

const ROUNDS: usize = 9;

/// Made when its turn comes.
type Named = (&'static str, Box<dyn Fn() -> meshes::Faces>);

/// The median time of each pool and its best, in nanoseconds a triangle.
fn compare(name: &str, pools: &[ThreadPool; 2], faces: usize, work: impl Fn() + Sync) {
    let mut times = [Vec::new(), Vec::new()];
    for _ in 0..ROUNDS {
        for (pool, times) in pools.iter().zip(&mut times) {
            let start = Instant::now();
            pool.install(&work);
            times.push(start.elapsed().as_nanos() as f64 / faces as f64);
        }
    }
    let [(one, best_of_one), (two, best_of_two)] = times.map(|mut times| {
        times.sort_by(f64::total_cmp);
        (times[times.len() / 2], times[0])
    });
    let (ratio, best) = (one / two, best_of_one / best_of_two);
    println!("  {name:28} one {one:6.1}  two {two:6.1}  {ratio:.2} times as fast");
    println!("  {:28}     {best_of_one:6.1}      {best_of_two:6.1}  {best:.2} at best", "");
}

/// The sum of all neighbours of all vertices.
fn rings<M: Incidence + Sync>(mesh: &M) -> usize {
    let sum = |v| mesh.one_ring(v).map(Handle::index).fold(0, usize::wrapping_add);
    mesh.vertices().into_par_iter().map(sum).reduce(|| 0, usize::wrapping_add)
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).filter(|word| word != "--bench").collect();
    let is_test = words.iter().any(|word| word == "--test");
    let pools = [1, 2].map(|n| ThreadPoolBuilder::new().num_threads(n).build().expect("threads"));
    let grid = || meshes::torus(2000, 2500);
    let meshes: Vec<Named> = if is_test {
        vec![("icosphere, 82 k", Box::new(|| meshes::sphere(6)))]
    } else {
        vec![
            ("icosphere, 82 k", Box::new(|| meshes::sphere(6))),
            ("icosphere, 1.3 M", Box::new(|| meshes::sphere(8))),
            ("icosphere, 5.2 M", Box::new(|| meshes::sphere(9))),
            ("grid, 10 M", Box::new(grid)),
            ("icosphere, 1.3 M, shuffled", Box::new(|| meshes::shuffled(&meshes::sphere(8)))),
            ("icosphere, 5.2 M, shuffled", Box::new(|| meshes::shuffled(&meshes::sphere(9)))),
        ]
    };
    let is_wanted =
        |name: &str| is_test || words.is_empty() || words.iter().any(|word| name.contains(&**word));
    for (name, make) in meshes.into_iter().filter(|(name, _)| is_wanted(name)) {
        let (vertices, faces) = make();
        let (n, faces) = (faces.len(), &faces[..]);
        println!("{name}");
        let opposites = CheL1::from_faces(vertices, faces).expect("it is a manifold");
        compare("check of fans", &pools, n, || drop(black_box(fans_into(&opposites, Vec::new()))));
        drop(opposites);
        compare("CHE L1, built", &pools, n, || drop(black_box(CheL1::from_faces(vertices, faces))));
        let build = || DirectedEdgesSmall::from_faces(vertices, faces).expect("it is a manifold");
        compare("directed edges small, built", &pools, n, || drop(black_box(build())));
        sweep("directed edges small", &pools, &build());
        sweep("CHE L2", &pools, &CheL2::from_faces(vertices, faces).expect("it is a manifold"));
        sweep("Mate-Face", &pools, &MateFace::from_faces(vertices, faces).expect("it is a manifold"));
    }
}

fn sweep<M: Incidence + Sync>(name: &str, pools: &[ThreadPool; 2], mesh: &M) {
    let work = || {
        black_box(rings(mesh));
    };
    compare(&format!("{name}, rings"), pools, mesh.face_count(), work);
}

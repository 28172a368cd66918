//! Times the deformation of spheres of springs, at the sizes of Figs. 18 to 21 of Biscaro et al. (2016).
//!
//! `cargo bench --bench spring`. A sphere of 198 to 20,166 vertices is held at its lower half and pushed at its top. In
//! each row: walking all first rings; making the simulation; one step in time, from rows and with every ring walked;
//! and the whole static deformation, from making the simulation to rest. The times are the best of rounds in
//! which all structures take turns, so it is not by criterion. With `--test`, the smallest sphere, once.
use onering::spring::{Options, Simulation};
use onering::{CheL2, DirectedEdgesSmall, FromFaces, Handle, Incidence, Map, MateFace};
use std::collections::BTreeMap;
use std::hint::black_box;
use std::time::Instant;

/// An octahedron whose edges are cut into `n`, blown up to the unit sphere: `4 n² + 2` vertices.
fn sphere(n: i32) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let (mut index, mut positions) = (BTreeMap::new(), Vec::new());
    let mut vertex = |p: [i32; 3]| {
        *index.entry(p).or_insert_with(|| {
            let length = p.iter().map(|&x| f64::from(x * x)).sum::<f64>().sqrt();
            positions.push(p.map(|x| (f64::from(x) / length) as f32));
            positions.len() as u32 - 1
        })
    };
    let mut faces = Vec::new();
    for signs in 0..8 {
        let sign = [0, 1, 2].map(|axis| if signs >> axis & 1 == 0 { 1 } else { -1 });
        let mut face = |corners: [[i32; 2]; 3]| {
            let mut face = corners.map(|[i, j]| vertex([sign[0] * i, sign[1] * j, sign[2] * (n - i - j)]));
            if sign.iter().product::<i32>() < 0 {
                face.swap(1, 2);
            }
            faces.push(face);
        };
        for (i, j) in (0..n).flat_map(|i| (0..n - i).map(move |j| (i, j))) {
            face([[i, j], [i + 1, j], [i, j + 1]]);
            if i + j + 1 < n {
                face([[i + 1, j], [i + 1, j + 1], [i, j + 1]]);
            }
        }
    }
    (positions, faces)
}

/// The times of one structure at one size, round after round.
#[derive(Default)]
struct Times {
    rings: Vec<f64>,
    made: Vec<f64>,
    step: Vec<f64>,
    walking: Vec<f64>,
    deformed: Vec<f64>,
    iterations: usize,
}

fn seconds<T>(f: impl FnOnce() -> T) -> (f64, T) {
    let start = Instant::now();
    let result = black_box(f());
    (start.elapsed().as_secs_f64(), result)
}

fn measure<M: Incidence>(mesh: &M, positions: &[[f32; 3]], times: &mut Times) {
    let positions: Map<M::Vertex, _> = positions.to_vec().into();
    let fixed: Vec<_> = mesh.vertices().filter(|&v| positions[v][2] < 0.0).collect();
    let top = mesh.vertices().max_by(|&a, &b| positions[a][2].total_cmp(&positions[b][2])).expect("vertices");
    let options = Options { fixed, damping: 0.1, ..Options::default() };
    let make = || {
        let mut sim = Simulation::new(mesh, &positions, &options).expect("good options");
        sim.push(top, [0.0, 0.0, -0.01], 3).expect("a force");
        sim
    };
    let rings =
        || mesh.vertices().map(|v| mesh.neighbours(v).map(Handle::index).sum::<usize>()).sum::<usize>();
    times.rings.push(seconds(rings).0);
    let (made, mut sim) = seconds(make);
    times.made.push(made);
    let (dt, steps) = (sim.stable_step() / 2.0, 20);
    times.step.push(seconds(|| (0..steps).for_each(|_| sim.step(dt))).0 / f64::from(steps));
    times.walking.push(seconds(|| (0..steps).for_each(|_| sim.step_walking(dt))).0 / f64::from(steps));
    let (deformed, solved) = seconds(|| make().solve(1e-8, 100_000).expect("a static solution"));
    times.deformed.push(deformed);
    times.iterations = solved.iterations;
}

fn best(seconds: &[f64]) -> f64 {
    seconds.iter().copied().fold(f64::INFINITY, f64::min)
}

fn main() {
    let is_test = std::env::args().any(|a| a == "--test");
    let (sizes, rounds): (&[i32], _) = if is_test { (&[7], 1) } else { (&[7, 14, 22, 45, 71], 15) };
    println!(
        "| vertices | structure | rings, µs | making, µs | step, µs | step walking, µs | deformation, ms | iterations |"
    );
    println!("|---:|---|---:|---:|---:|---:|---:|---:|");
    for &n in sizes {
        let (positions, faces) = sphere(n);
        let small = DirectedEdgesSmall::from_faces(positions.len(), &faces).expect("a manifold");
        let che = CheL2::from_faces(positions.len(), &faces).expect("a manifold");
        let mate = MateFace::from_faces(positions.len(), &faces).expect("a manifold");
        let mut all = ["directed-edges-small", "che-l2", "mate-face"].map(|name| (name, Times::default()));
        for _ in 0..rounds {
            measure(&small, &positions, &mut all[0].1);
            measure(&che, &positions, &mut all[1].1);
            measure(&mate, &positions, &mut all[2].1);
        }
        for (name, times) in &all {
            let [rings, made, step, walking] =
                [&times.rings, &times.made, &times.step, &times.walking].map(|t| best(t) * 1e6);
            let (deformed, iterations) = (best(&times.deformed) * 1e3, times.iterations);
            println!(
                "| {} | {name} | {rings:.0} | {made:.0} | {step:.1} | {walking:.1} | {deformed:.2} | {iterations} |",
                positions.len()
            );
        }
    }
}

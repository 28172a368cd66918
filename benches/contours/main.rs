//! Times contours, minima and kinds of vertices on a made terrain, on CHE L2.
//!
//! `cargo bench --bench contours -- 1000000 10000000`: the numbers of triangles. The times are medians of seven
//! rounds in which all ways take turns, on one thread; building the structure is timed once, beside them. Not
//! by criterion, whose warming up would take longer than all of this. With `--test`, a small terrain, once.
use onering::{CheL2, FromFaces, Map, Topology, VertexId, contours, critical};
use std::hint::black_box;
use std::time::Instant;

/// Hills of five sizes on a square grid, row after row; the height is from -1 to 1.
fn terrain(triangles: usize) -> (Vec<f32>, Vec<[u32; 3]>) {
    let side = (triangles as f64 / 2.0).sqrt().round().max(1.0) as u32;
    let row = side + 1;
    let height = |i: u32| {
        let [x, y] = [i % row, i / row].map(|k| f64::from(k) / f64::from(side));
        let hills = (0..5).map(|octave| {
            let (waves, turn) = (3.0 * 2.7_f64.powi(octave), f64::from(octave));
            let along = x * turn.cos() + y * turn.sin();
            let across = y * turn.cos() - x * turn.sin();
            0.5_f64.powi(octave) * (waves * along + turn).sin() * (waves * across).cos()
        });
        (hills.sum::<f64>() / 1.94) as f32
    };
    let cell = |i: u32| {
        let a = i / side * row + i % side;
        [[a, a + 1, a + row + 1], [a, a + row + 1, a + row]]
    };
    ((0..row * row).map(height).collect(), (0..side * side).flat_map(cell).collect())
}

/// What is timed, and how much it found.
type Way<'a> = (&'a str, Box<dyn Fn() -> usize + 'a>);

fn ways<'a>(mesh: &'a CheL2, height: &'a Map<VertexId, f32>, flat: &'a Map<VertexId, f32>) -> Vec<Way<'a>> {
    let lines = move |field: &Map<_, f32>, count: u8| {
        let levels: Vec<f32> =
            (0..count).map(|k| (f32::from(k) + 0.5) / f32::from(count) * 2.0 - 1.0).collect();
        contours::contours(mesh, field, &levels).expect("finite").crossing_count()
    };
    vec![
        ("contours of 1 level, crossings", Box::new(move || lines(height, 1))),
        ("contours of 20 levels, crossings", Box::new(move || lines(height, 20))),
        ("contours of 200 levels, crossings", Box::new(move || lines(height, 200))),
        ("minima", Box::new(|| critical::local_minima(mesh, height).expect("finite").len())),
        ("maxima", Box::new(|| critical::local_maxima(mesh, height).expect("finite").len())),
        ("minima of terraces", Box::new(|| critical::local_minima(mesh, flat).expect("finite").len())),
        ("saddles", Box::new(|| critical::saddles(mesh, height).expect("finite").len())),
    ]
}

fn measure(triangles: usize, rounds: usize) {
    let (height, faces) = terrain(triangles);
    let start = Instant::now();
    let mesh = CheL2::from_faces(height.len(), &faces).expect("a manifold");
    println!("\n{} triangles, built in {:.3} s", mesh.face_count(), start.elapsed().as_secs_f64());
    // Plateaus everywhere: heights in fiftieths.
    let flat: Map<_, f32> = height.iter().map(|z| (z * 50.0).floor() / 50.0).collect();
    let height = Map::from(height);

    let ways = ways(&mesh, &height, &flat);
    let mut seconds = vec![Vec::new(); ways.len()];
    let mut found = vec![0; ways.len()];
    for _ in 0..rounds {
        for (i, (_, run)) in ways.iter().enumerate() {
            let start = Instant::now();
            found[i] = black_box(run());
            seconds[i].push(start.elapsed().as_secs_f64());
        }
    }
    println!("| what | found | seconds, median | best |\n|---|---:|---:|---:|");
    for (((name, _), found), seconds) in ways.iter().zip(found).zip(&mut seconds) {
        seconds.sort_by(f64::total_cmp);
        println!("| {name} | {found} | {:.4} | {:.4} |", seconds[seconds.len() / 2], seconds[0]);
    }
}

fn main() {
    let is_test = std::env::args().any(|a| a == "--test");
    let asked: Vec<usize> = std::env::args().filter_map(|a| a.parse().ok()).collect();
    match asked.as_slice() {
        _ if is_test => measure(2_000, 1),
        [] => [1_000_000, 10_000_000].into_iter().for_each(|triangles| measure(triangles, 7)),
        asked => asked.iter().for_each(|&triangles| measure(triangles, 7)),
    }
}

//! Tables 6 and 7 of Figueiredo et al. (2014) on a mesh of one's own: the degrees of its vertices, and how long
//! 10,000 random queries of each of the six kinds take on the vertex graph.
//!
//! `cargo run --release --features io --example toptri_queries -- bunny.obj`
use onering::{FromFaces, Handle, VertexGraph, VertexId, degrees, io};
use std::{error::Error, hint::black_box, time::Instant};

const QUERIES: usize = 10_000;
const RUNS: usize = 9;

/// Median time of asking each of `elements`, in milliseconds, after one run to warm up.
fn time<E: Copy>(name: &str, elements: &[E], ask: impl Fn(E) -> usize) {
    let mut times: Vec<f64> = (0..=RUNS)
        .map(|_| {
            let start = Instant::now();
            black_box(elements.iter().map(|&element| ask(element)).sum::<usize>());
            1e3 * start.elapsed().as_secs_f64()
        })
        .skip(1)
        .collect();
    times.sort_by(f64::total_cmp);
    println!("{name:28} {:8.3} ms", times[times.len() / 2]);
}

/// As many elements of a list as there are queries, in an order without a pattern.
fn pick<E: Copy>(from: &[E]) -> Vec<E> {
    let mut state = 2014_u64;
    let random = |_| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        from[(state >> 33) as usize % from.len()]
    };
    (0..QUERIES).map(random).collect()
}

fn main() -> Result<(), Box<dyn Error>> {
    let file = std::env::args().nth(1).ok_or("which file?")?;
    let start = Instant::now();
    let mesh = io::load(&file)?;
    println!("{file}: {} vertices, {} triangles", mesh.positions.len(), mesh.faces.len());
    println!("{:28} {:8.3} ms", "load", 1e3 * start.elapsed().as_secs_f64());
    let start = Instant::now();
    let graph = VertexGraph::from_faces(mesh.positions.len(), &mesh.faces)?;
    println!("{:28} {:8.3} ms", "build", 1e3 * start.elapsed().as_secs_f64());

    let vertices =
        pick(&graph.vertices().filter(|&v| graph.neighbours(v).len() > 0).collect::<Vec<VertexId>>());
    let edges = pick(&graph.edges().collect::<Vec<_>>());
    let faces = pick(&graph.faces().collect::<Vec<_>>());
    time("vGetAdjacentVertices", &vertices, |v| graph.neighbours(v).map(Handle::index).sum());
    time("vGetIncidentEdges", &vertices, |v| graph.vertex_edges(v).map(|[_, u]| u.index()).sum());
    time("vGetIncidentFaces", &vertices, |v| graph.vertex_faces(v).count());
    time("eGetAdjacentEdges", &edges, |e| graph.adjacent_edges(e).count());
    time("eGetIncidentFaces", &edges, |e| graph.edge_faces(e).count());
    time("fGetAdjacentFaces", &faces, |f| graph.adjacent_faces(f).count());
    println!("\n{}", degrees::degrees(&graph));
    Ok(())
}

//! How long the same question takes on three structures: the mean height around each vertex.
//!
//! `cargo run --release --example query_speed`
use onering::{BuildError, CheL2, DirectedEdgesFull, DirectedEdgesSmall, FromFaces, Handle, Incidence, Map};
use std::{hint::black_box, time::Instant};

/// One smoothing step: written once, for every structure that can start from a vertex.
fn mean_of_neighbours<M: Incidence>(mesh: &M, height: &Map<M::Vertex, f32>) -> Map<M::Vertex, f32> {
    Map::from_fn(mesh.vertex_count(), |v| {
        let (sum, count) = mesh.one_ring(v).fold((0.0, 0), |(sum, count), u| (sum + height[u], count + 1));
        if count == 0 { height[v] } else { sum / count as f32 }
    })
}

fn time<M: Incidence + FromFaces>(
    name: &str,
    vertex_count: usize,
    faces: &[[u32; 3]],
) -> Result<(), BuildError> {
    let mesh = M::from_faces(vertex_count, faces)?;
    let height = Map::from_fn(vertex_count, |v: M::Vertex| (v.index() % 97) as f32);
    let mut times: Vec<_> = (0..9)
        .map(|_| {
            let start = Instant::now();
            black_box(mean_of_neighbours(&mesh, &height));
            start.elapsed().as_nanos() as f64 / vertex_count as f64
        })
        .collect();
    times.sort_by(f64::total_cmp);
    println!("{name:22} {:5.1} ns a vertex", times[times.len() / 2]);
    Ok(())
}

fn main() -> Result<(), BuildError> {
    let (columns, rows) = (512u32, 512u32);
    let v = |c: u32, r: u32| r % rows * columns + c % columns;
    let faces: Vec<_> = (0..columns * rows)
        .map(|i| (i % columns, i / columns))
        .flat_map(|(c, r)| [[v(c, r), v(c + 1, r), v(c + 1, r + 1)], [v(c, r), v(c + 1, r + 1), v(c, r + 1)]])
        .collect();
    let vertex_count = (columns * rows) as usize;
    time::<CheL2>("che-l2", vertex_count, &faces)?;
    time::<DirectedEdgesSmall>("directed-edges-small", vertex_count, &faces)?;
    time::<DirectedEdgesFull>("directed-edges-full", vertex_count, &faces)
}

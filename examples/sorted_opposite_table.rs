//! What half the memory costs: the sorted opposite table beside directed edges and Compact Half-Edge level 2, on meshes
//! made here and on files. Bytes a triangle, faces looked at for each `origin`, one-ring sweeps, and construction.
//!
//! `cargo run --release --example sorted_opposite_table -- bunny.obj`
use onering::{
    Adjacency, BuildError, CheL2, DirectedEdgesSmall, Footprint, FromFaces, Handle, Incidence, Map, Sot,
    Topology, subdivision,
};
use std::{env, error::Error, hint::black_box, time::Instant};

type Faces = Vec<[u32; 3]>;

/// Squares of two triangles; closed both ways it is a torus.
fn grid(n: u32, is_torus: bool) -> (usize, Faces) {
    let side = if is_torus { n } else { n + 1 };
    let v = |c: u32, r: u32| r % side * side + c % side;
    let squares = (0..n * n).map(|i| (i % n, i / n));
    let faces = squares.flat_map(|(c, r)| {
        [[v(c, r), v(c + 1, r), v(c + 1, r + 1)], [v(c, r), v(c + 1, r + 1), v(c, r + 1)]]
    });
    ((side * side) as usize, faces.collect())
}

/// An octahedron with every face divided into four, some times.
fn sphere(times: usize) -> Result<(usize, Faces), Box<dyn Error>> {
    let octahedron = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    let mut mesh = CheL2::from_faces(6, &octahedron)?;
    for _ in 0..times {
        let divided = subdivision::midpoint(&mesh, &Map::filled(mesh.vertex_count(), [0.0; 3]))?;
        mesh = CheL2::from_face_vec(divided.vertex_count, divided.faces)?;
    }
    Ok((mesh.vertex_count(), mesh.to_faces()))
}

/// The median time of nine runs after one to warm up, in nanoseconds.
fn median<T>(mut run: impl FnMut() -> T) -> f64 {
    black_box(run());
    let mut times = [(); 9].map(|()| {
        let start = Instant::now();
        black_box(run());
        start.elapsed().as_nanos() as f64
    });
    times.sort_by(f64::total_cmp);
    times[4]
}

/// One-ring sweeps, in nanoseconds a vertex.
fn sweep<M: Incidence>(mesh: &M) -> f64 {
    let all = || mesh.vertices().map(|v| mesh.one_ring(v).map(Handle::index).sum::<usize>()).sum::<usize>();
    median(all) / mesh.vertex_count() as f64
}

/// Stars are turns alone, which ask for no origin.
fn stars<M: Incidence>(mesh: &M) -> f64 {
    median(|| mesh.vertices().map(|v| mesh.star(v).count()).sum::<usize>()) / mesh.vertex_count() as f64
}

/// How many faces the walk of `origin` looks at, on average.
fn visits(mesh: &Sot) -> f64 {
    let names = |h: onering::HalfEdgeId| h.index().is_multiple_of(3) && h.index() / 3 < mesh.matched_count();
    let turned = |g, start| mesh.rotate_cw(g).filter(|&turned| turned != start);
    let walk = |h| std::iter::successors(Some(h), move |&g| if names(g) { None } else { turned(g, h) });
    let all: usize = mesh.half_edges().map(|h| walk(h).count()).sum();
    all as f64 / mesh.half_edge_count() as f64
}

fn row<M: Incidence + Footprint>(name: &str, mesh: &M, build: f64) {
    let (bytes, faces) = (mesh.heap_bytes() as f64, mesh.face_count() as f64);
    let rate = faces / build * 1e3;
    println!(
        "  {name:22} {:6.2} bytes/triangle {:6.1} ns/ring {:6.1} ns/star {rate:6.1} M triangles/s built",
        bytes / faces,
        sweep(mesh),
        stars(mesh)
    );
}

fn compare(name: &str, (vertices, faces): (usize, Faces)) -> Result<(), BuildError> {
    let (sot, _) = Sot::encode(vertices, &faces)?;
    println!(
        "{name}: {} triangles, {:.2} faces looked at for each origin, {} vertices without a face",
        faces.len(),
        visits(&sot),
        (sot.heap_bytes() - 12 * faces.len()) / 4
    );
    row("sot", &sot, median(|| Sot::encode(vertices, &faces)));
    let small = DirectedEdgesSmall::from_faces(vertices, &faces)?;
    row("directed-edges-small", &small, median(|| DirectedEdgesSmall::from_faces(vertices, &faces)));
    let che = CheL2::from_faces(vertices, &faces)?;
    row("che-l2", &che, median(|| CheL2::from_faces(vertices, &faces)));
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    compare("sphere", sphere(7)?)?;
    compare("torus", grid(256, true))?;
    compare("grid", grid(256, false))?;
    compare("large torus", grid(1024, true))?;
    for file in env::args().skip(1) {
        let mesh = onering_io::load(&file)?;
        compare(&file, (mesh.positions.len(), mesh.faces))?;
    }
    Ok(())
}

//! What half the memory costs, and a quarter: the sorted opposite table and compact stars beside directed edges and
//! Compact Half-Edge level 2, on meshes made here and on files (repaired). Bytes a triangle, faces looked at for each
//! `origin`, sweeps of one-rings, stars and opposites, and construction.
//!
//! `cargo run --release --example compact_layouts -- --large bunny.obj`; without `--large` all is small, and takes seconds.
use onering::repair::{RepairOptions, repair};
use onering::{
    Adjacency, BuildError, CheL2, CompactStars, DirectedEdgesSmall, Footprint, FromFaces, Handle, Incidence,
    Map, Sot, Topology, reorder, subdivision,
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

/// The median time of some runs after one to warm up, in nanoseconds.
fn median<const RUNS: usize, T>(mut run: impl FnMut() -> T) -> f64 {
    black_box(run());
    let mut times = [(); RUNS].map(|()| {
        let start = Instant::now();
        black_box(run());
        start.elapsed().as_nanos() as f64
    });
    times.sort_by(f64::total_cmp);
    times[RUNS / 2]
}

/// The same of a sweep, of which nine.
fn sweeping(run: impl FnMut() -> usize) -> f64 {
    median::<9, _>(run)
}

/// The same of a construction, of which three.
fn building<T>(run: impl FnMut() -> T) -> f64 {
    median::<3, _>(run)
}

/// One-ring sweeps, in nanoseconds a vertex.
fn sweep<M: Incidence>(mesh: &M) -> f64 {
    let all = || mesh.vertices().map(|v| mesh.one_ring(v).map(Handle::index).sum::<usize>()).sum::<usize>();
    sweeping(all) / mesh.vertex_count() as f64
}

/// Stars are turns alone, which ask for no origin.
fn stars<M: Incidence>(mesh: &M) -> f64 {
    sweeping(|| mesh.vertices().map(|v| mesh.star(v).count()).sum::<usize>()) / mesh.vertex_count() as f64
}

/// What lies across each half-edge, in nanoseconds.
fn opposites<M: Incidence>(mesh: &M) -> f64 {
    let half_edges: Vec<M::HalfEdge> = mesh.half_edges().collect();
    let across = |&h| mesh.opposite(h).map_or(0, Handle::index);
    sweeping(|| half_edges.iter().map(across).sum::<usize>()) / half_edges.len() as f64
}

/// How many faces the walk of `origin` looks at, on average.
fn visits(mesh: &Sot) -> f64 {
    let names = |h: onering::HalfEdgeId| h.index().is_multiple_of(3) && h.index() / 3 < mesh.matched_count();
    let turned = |g, start| mesh.rotate_cw(g).filter(|&turned| turned != start);
    let walk = |h| std::iter::successors(Some(h), move |&g| if names(g) { None } else { turned(g, h) });
    let all: usize = mesh.half_edges().map(|h| walk(h).count()).sum();
    all as f64 / mesh.half_edge_count() as f64
}

fn row<M: Incidence>(name: &str, mesh: &M, bytes: usize, build: f64) {
    let faces = mesh.face_count() as f64;
    println!(
        "  {name:32} {:6.2} bytes/triangle {:6.1} ns/ring {:6.1} ns/star {:6.1} ns/opposite {:6.1} M triangles/s built",
        bytes as f64 / faces,
        sweep(mesh),
        stars(mesh),
        opposites(mesh),
        faces / build * 1e3
    );
}

fn built<M: Incidence + Footprint + FromFaces>(
    name: &str,
    vertices: usize,
    faces: &[[u32; 3]],
) -> Result<M, BuildError> {
    let mesh = M::from_faces(vertices, faces)?;
    row(name, &mesh, mesh.heap_bytes(), building(|| M::from_faces(vertices, faces)));
    Ok(mesh)
}

fn compare(name: &str, (vertices, faces): (usize, Faces)) -> Result<(), BuildError> {
    let (stars, _) = CompactStars::encode(vertices, &faces)?;
    let (sot, _) = Sot::encode(vertices, &faces)?;
    println!(
        "{name}: {} triangles, {} bits a difference; {:.2} faces looked at for each origin, {} vertices without a face",
        faces.len(),
        stars.difference_bits(),
        visits(&sot),
        (sot.heap_bytes() - 12 * faces.len()) / 4
    );
    row("compact-stars", &stars, stars.heap_bytes(), building(|| CompactStars::encode(vertices, &faces)));
    row("sot", &sot, sot.heap_bytes(), building(|| Sot::encode(vertices, &faces)));
    let small: DirectedEdgesSmall = built("directed-edges-small", vertices, &faces)?;
    let _: CheL2 = built("che-l2", vertices, &faces)?;
    let faces = reorder::reorder(&small, &reorder::cuthill_mckee(&small)).faces;
    let _: DirectedEdgesSmall = built("directed-edges-small, reordered", vertices, &faces)?;
    let _: CheL2 = built("che-l2, reordered", vertices, &faces)?;
    Ok(())
}

/// Vertices and faces in an order without rhyme.
fn shuffled((vertices, faces): (usize, Faces)) -> (usize, Faces) {
    let mut state = 1_u64;
    let mut below = |n: usize| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as usize % n
    };
    let mut names: Vec<u32> = (0..vertices as u32).collect();
    (1..vertices).rev().for_each(|i| names.swap(i, below(i + 1)));
    let mut faces: Faces = faces.into_iter().map(|face| face.map(|v| names[v as usize])).collect();
    (1..faces.len()).rev().for_each(|i| faces.swap(i, below(i + 1)));
    (vertices, faces)
}

fn main() -> Result<(), Box<dyn Error>> {
    compare("sphere", sphere(7)?)?;
    compare("torus", grid(256, true))?;
    compare("grid", grid(256, false))?;
    let mut files = env::args().skip(1).peekable();
    if files.next_if(|argument| argument == "--large").is_some() {
        compare("large torus", grid(1024, true))?;
        compare("large torus, shuffled", shuffled(grid(1024, true)))?;
        compare("large grid", grid(1024, false))?;
    }
    for file in files {
        let mesh = onering_io::load(&file)?;
        let mended = repair(mesh.positions.len(), &mesh.faces, &RepairOptions { weld: None })?;
        compare(&file, (mended.vertex_count, mended.faces))?;
    }
    Ok(())
}

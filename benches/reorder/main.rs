//! Times what reordering brings: a shuffled sphere is reordered, built and swept, beside the same without, and beside the
//! sphere in the order in which it was made. Each way once a round; the best of the rounds, in processor time, is printed.
//!
//! `cargo bench --bench reorder -- [LEVELS]`: an icosahedron divided so many times, 9 by default (5.2 million triangles).
#[path = "../meshes/mod.rs"]
mod meshes;

use onering::{DirectedEdgesSmall, FromFaces, Handle, Incidence, Map, SharedVertex, VertexId};
use onering::{neighbours::Neighbours, reorder};
use std::sync::OnceLock;
use std::time::{Duration, Instant};
use std::{fs, hint::black_box};

const ROUNDS: usize = 3;
const SWEEPS: usize = 10;

/// Positions and faces.
struct Mesh {
    positions: Map<VertexId, [f32; 3]>,
    faces: Vec<[u32; 3]>,
}

impl From<meshes::Placed> for Mesh {
    fn from((positions, faces): meshes::Placed) -> Self {
        Self { positions, faces }
    }
}

/// The sum of the indices of all neighbours of all vertices.
fn sweep(mesh: &impl Incidence) -> u64 {
    mesh.vertices().map(|v| mesh.one_ring(v).map(|u| u.index() as u64).sum::<u64>()).sum()
}

/// Processor time of this thread, which others on the machine disturb less, where Linux tells it; else by the clock.
fn now() -> Duration {
    static START: OnceLock<Instant> = OnceLock::new();
    let on_processor = fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = on_processor.and_then(|text| text.split(' ').next()?.parse().ok());
    nanoseconds.map_or_else(|| START.get_or_init(Instant::now).elapsed(), Duration::from_nanos)
}

fn timed<T>(work: impl FnOnce() -> T) -> (T, Duration) {
    let start = now();
    let result = work();
    (result, now() - start)
}

type Order = fn(&Mesh) -> Vec<VertexId>;

const ORDERS: [(&str, Order); 4] = [
    ("Hilbert", |mesh| reorder::hilbert(&mesh.positions).expect("finite")),
    ("Morton", |mesh| reorder::morton(&mesh.positions).expect("finite")),
    ("breadth first", |mesh| reorder::breadth_first(&graph(mesh))),
    ("reverse Cuthill-McKee", |mesh| reorder::reverse_cuthill_mckee(&graph(mesh))),
];

fn graph(mesh: &Mesh) -> impl Neighbours<Node = VertexId> {
    DirectedEdgesSmall::from_faces(mesh.positions.len(), &mesh.faces).expect("a sphere")
}

/// Reordering, building, and one sweep of ten.
#[derive(Clone, Copy)]
struct Times([Duration; 3]);

impl Times {
    fn of(mesh: &Mesh, order: Option<Order>) -> Self {
        let vertex_count = mesh.positions.len();
        let (faces, reordering) = timed(|| {
            order.map(|order| {
                let soup = SharedVertex::from_faces(vertex_count, &mesh.faces).expect("a sphere");
                let new = reorder::reorder(&soup, &order(mesh));
                black_box(new.carry_vertices(mesh.positions.as_slice()));
                new.faces
            })
        });
        let faces = faces.unwrap_or_else(|| mesh.faces.clone());
        let (built, building) =
            timed(|| DirectedEdgesSmall::from_face_vec(vertex_count, faces).expect("a sphere"));
        let (sum, sweeps) = timed(|| (0..SWEEPS).map(|_| sweep(black_box(&built))).sum::<u64>());
        black_box(sum);
        Self([if order.is_some() { reordering } else { Duration::ZERO }, building, sweeps / SWEEPS as u32])
    }

    fn best(self, other: Self) -> Self {
        Self([0, 1, 2].map(|i| self.0[i].min(other.0[i])))
    }

    fn print(self, name: &str) {
        let [reordering, building, sweep] = self.0.map(|time| time.as_secs_f64());
        let all = reordering + building + SWEEPS as f64 * sweep;
        println!("| {name} | {reordering:.3} | {building:.3} | {sweep:.4} | {all:.3} |");
    }
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let is_test = arguments.iter().any(|argument| argument == "--test");
    let given = arguments.iter().find_map(|argument| argument.parse().ok());
    let levels = given.unwrap_or(if is_test { 2 } else { 9 });
    let sphere = meshes::icosphere(levels);
    let shuffled = meshes::shuffled_with_positions(&sphere).into();
    let coherent = sphere.into();
    let mut ways = vec![("in the order made", &coherent, None), ("shuffled", &shuffled, None)];
    ways.extend(ORDERS.map(|(name, order)| (name, &shuffled, Some(order))));
    let mut best: Vec<Option<Times>> = vec![None; ways.len()];
    for _ in 0..if is_test { 1 } else { ROUNDS } {
        for ((_, mesh, order), best) in ways.iter().zip(&mut best) {
            let times = Times::of(mesh, *order);
            *best = Some(best.map_or(times, |other| times.best(other)));
        }
    }
    println!("{} triangles, {} vertices", coherent.faces.len(), coherent.positions.len());
    println!("| order | reorder s | build s | sweep s | all, with {SWEEPS} sweeps, s |");
    println!("|---|---:|---:|---:|---:|");
    ways.iter().zip(best).for_each(|((name, ..), best)| best.into_iter().for_each(|best| best.print(name)));
}

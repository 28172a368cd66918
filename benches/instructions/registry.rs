//! What `check` counts of every backend in the registry: builds, from faces in order and shuffled, and walks.
use super::kernels::{sweep, torus};
use onering::{FromFaces, Handle, Incidence, VertexGraph, k_ring::KRing, neighbours::Neighbours};
use std::hint::black_box;

/// One thing that is counted.
pub(crate) struct Counted {
    pub(crate) task: &'static str,
    pub(crate) structure: &'static str,
    pub(crate) run: Box<dyn Fn() -> u64>,
}

/// All, on a mesh in order and a shuffled one, which is larger: in a small one all numbers are near to each other, and
/// it is paired as one in order is.
pub(crate) fn counted() -> Vec<Counted> {
    let in_order = torus(64, 128);
    let (vertex_count, faces) = torus(128, 256);
    let shuffled = (vertex_count, shuffled(vertex_count, &faces));
    let mut all = Vec::new();
    for (structure, add) in BACKENDS {
        add(structure, &in_order, &shuffled, &mut all);
    }
    all
}

type Input = (usize, Vec<[u32; 3]>);
type Add = fn(&'static str, &Input, &Input, &mut Vec<Counted>);

fn builds<M: FromFaces>(structure: &'static str, in_order: &Input, shuffled: &Input, all: &mut Vec<Counted>) {
    for (task, input) in [("build", in_order), ("build-shuffled", shuffled)] {
        let (vertex_count, faces) = input.clone();
        let build = move || M::from_faces(vertex_count, &faces).map(black_box).is_ok().into();
        all.push(Counted { task, structure, run: Box::new(build) });
    }
}

fn rings<M: FromFaces + Incidence + 'static>(
    structure: &'static str,
    in_order: &Input,
    shuffled: &Input,
    all: &mut Vec<Counted>,
) {
    builds::<M>(structure, in_order, shuffled, all);
    let mesh = M::from_faces(in_order.0, &in_order.1).expect("a manifold");
    let run = Box::new(move || sweep(&mesh));
    all.push(Counted { task: "ring", structure, run });
    four_rings::<M>(structure, in_order, all);
}

fn graph(structure: &'static str, in_order: &Input, shuffled: &Input, all: &mut Vec<Counted>) {
    builds::<VertexGraph>(structure, in_order, shuffled, all);
    let graph = VertexGraph::from_faces(in_order.0, &in_order.1).expect("a graph");
    let ring = move |v| Neighbours::neighbours(&graph, Handle::new(v)).map(|u| u.index() as u64).sum::<u64>();
    let vertices = 0..in_order.0;
    let run = Box::new(move || vertices.clone().map(&ring).sum());
    all.push(Counted { task: "ring", structure, run });
    four_rings::<VertexGraph>(structure, in_order, all);
}

/// The 4-rings of every eighth vertex.
fn four_rings<M: FromFaces + Neighbours + 'static>(
    structure: &'static str,
    (vertex_count, faces): &Input,
    all: &mut Vec<Counted>,
) {
    let mesh = M::from_faces(*vertex_count, faces).expect("a manifold");
    let vertices = (0..*vertex_count).step_by(8);
    let run = move || {
        let mut ring = KRing::new();
        vertices.clone().map(|v| ring.search(&mesh, Handle::new(v), 4).count(4) as u64).sum()
    };
    all.push(Counted { task: "four-ring", structure, run: Box::new(run) });
}

/// New numbers for all vertices, and all faces in a new order.
fn shuffled(vertex_count: usize, faces: &[[u32; 3]]) -> Vec<[u32; 3]> {
    let mut numbers: Vec<u32> = (0..vertex_count as u32).collect();
    shuffle(&mut numbers);
    let mut faces: Vec<_> = faces.iter().map(|face| face.map(|v| numbers[v as usize])).collect();
    shuffle(&mut faces);
    faces
}

/// By a fixed seed.
fn shuffle<T>(things: &mut [T]) {
    let mut state = 88172645463325252_u64;
    for i in (1..things.len()).rev() {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        things.swap(i, (state % (i as u64 + 1)) as usize);
    }
}

/// How far the traits of a line go says what is counted.
macro_rules! wrapped {
    ([graph] $mesh:ty) => {
        graph
    };
    ([topology] $mesh:ty) => {
        builds::<$mesh>
    };
    ([topology adjacency] $mesh:ty) => {
        builds::<$mesh>
    };
    ([topology adjacency incidence $($more:ident)*] $mesh:ty) => {
        rings::<$mesh>
    };
}

macro_rules! list {
    ($($module:ident $name:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {
        const BACKENDS: &[(&str, Add)] = &[$(($name, wrapped!([$($has)*] $mesh) as Add)),+];
    };
}
onering::with_backends!(list);

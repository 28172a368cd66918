//! What `benches/instructions/check` has callgrind count of every backend in the registry: builds, from faces in order
//! and shuffled, and a sweep of one-rings. Runs each once and lists them.
//!
//! A program of its own: the compiler copies the walk of a ring into its caller where there is one caller, and `count`
//! looks at just that.
#[path = "../meshes/mod.rs"]
mod meshes;

use meshes::{Faces, shuffled, torus};
use onering::{FromFaces, Handle, Incidence, VertexGraph, neighbours::Neighbours};
use std::hint::black_box;

fn main() {
    for counted in counted() {
        collected(&*counted.run);
        println!("{} {}", counted.task, counted.structure);
    }
}

/// Callgrind collects in this function alone, by its name, and writes what it collected whenever it returns.
#[inline(never)]
fn collected(run: &dyn Fn() -> u64) {
    black_box(run());
}

/// One thing that is counted.
struct Counted {
    task: &'static str,
    structure: &'static str,
    run: Box<dyn Fn() -> u64>,
}

/// All, on a mesh in order and a shuffled one, which is larger: in a small one all numbers are near to each other, and
/// it is paired as one in order is.
fn counted() -> Vec<Counted> {
    let in_order = torus(64, 128);
    let shuffled = shuffled(&torus(128, 256));
    let mut all = Vec::new();
    for (structure, add) in BACKENDS {
        add(structure, &in_order, &shuffled, &mut all);
    }
    all
}

type Add = fn(&'static str, &Faces, &Faces, &mut Vec<Counted>);

fn builds<M: FromFaces>(structure: &'static str, in_order: &Faces, shuffled: &Faces, all: &mut Vec<Counted>) {
    for (task, input) in [("build", in_order), ("build-shuffled", shuffled)] {
        let (vertex_count, faces) = input.clone();
        let build = move || M::from_faces(vertex_count, &faces).map(black_box).is_ok().into();
        all.push(Counted { task, structure, run: Box::new(build) });
    }
}

fn rings<M: FromFaces + Incidence + 'static>(
    structure: &'static str,
    in_order: &Faces,
    shuffled: &Faces,
    all: &mut Vec<Counted>,
) {
    builds::<M>(structure, in_order, shuffled, all);
    let mesh = M::from_faces(in_order.0, &in_order.1).expect("a manifold");
    let run = Box::new(move || sweep(&mesh));
    all.push(Counted { task: "ring", structure, run });
}

fn graph(structure: &'static str, in_order: &Faces, shuffled: &Faces, all: &mut Vec<Counted>) {
    builds::<VertexGraph>(structure, in_order, shuffled, all);
    let graph = VertexGraph::from_faces(in_order.0, &in_order.1).expect("a graph");
    let ring = move |v| Neighbours::neighbours(&graph, Handle::new(v)).map(|u| u.index() as u64).sum::<u64>();
    let vertices = 0..in_order.0;
    let run = Box::new(move || vertices.clone().map(&ring).sum());
    all.push(Counted { task: "ring", structure, run });
}

/// Sums the index of every neighbour of every vertex.
fn sweep(mesh: &impl Incidence) -> u64 {
    mesh.vertices().map(|v| mesh.one_ring(v).map(|u| u.index() as u64).sum::<u64>()).sum()
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

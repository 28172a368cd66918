//! What is counted: builds of every structure by every strategy that any input may come to, and what else takes any list.
use crate::meshes::Random;
use onering::repair::{RepairOptions, repair};
use onering::{CheL1, CheL2, CompactStars, Defects, DirectedEdgesSmall, FromFaces, MateFace, Pairing, Sot};
use std::fmt;
use std::hint::black_box;

type Faces<'a> = &'a [[u32; 3]];

type Run = fn(usize, Faces<'_>, Pairing);

#[derive(Clone, Copy)]
pub(crate) struct Subject {
    name: &'static str,
    pairing: Pairing,
    run: Run,
}

fn build<M: FromFaces>(vertex_count: usize, faces: Faces<'_>, pairing: Pairing) {
    let _ = black_box(M::build(vertex_count, faces.into(), pairing));
}

/// Those that the others share their steps with.
const MAIN: [(&str, Run); 4] = [
    ("che-l1", build::<CheL1>),
    ("che-l2", build::<CheL2>),
    ("directed-edges-small", build::<DirectedEdgesSmall>),
    ("mate-face", build::<MateFace>),
];

const OTHERS: [(&str, Run); 4] = [
    ("repair", |vertex_count, faces, _| {
        let _ = black_box(repair(vertex_count, faces, &RepairOptions::default()));
    }),
    ("defects", |vertex_count, faces, _| {
        let _ = black_box(Defects::of(vertex_count, faces));
    }),
    ("sot", |vertex_count, faces, _| {
        let _ = black_box(Sot::encode(vertex_count, faces));
    }),
    ("compact-stars", |vertex_count, faces, _| {
        let _ = black_box(CompactStars::encode(vertex_count, faces));
    }),
];

macro_rules! list {
    ($($module:ident $name:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {
        const BACKENDS: &[(&str, Run)] = &[$(($name, build::<$mesh>)),+];
    };
}
onering::with_backends!(list);

impl Subject {
    pub(crate) fn random(random: &mut Random) -> Self {
        let pairing = random.of(&[Pairing::Auto, Pairing::Chain, Pairing::Partition]);
        let ((name, run), pairing) = match random.below(8) {
            0 => (random.of(BACKENDS), pairing),
            1 => (random.of(&OTHERS), Pairing::Auto),
            _ => (random.of(&MAIN), pairing),
        };
        Self { name, pairing, run }
    }

    pub(crate) fn run(&self, vertex_count: usize, faces: Faces<'_>) {
        (self.run)(vertex_count, faces, self.pairing);
    }
}

impl PartialEq for Subject {
    fn eq(&self, other: &Self) -> bool {
        (self.name, self.pairing) == (other.name, other.pairing)
    }
}

impl fmt::Display for Subject {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} ({})", self.name, self.pairing)
    }
}

//! Nothing depends on how many threads there are; every structure can be shared by them.
#[path = "common/shapes.rs"]
mod shapes;

use onering::fans::{Fans, fans, fans_into};
use onering::*;
use rayon::{ThreadPoolBuilder, prelude::*};
use shapes::{Random, shuffled, wheel};
use std::collections::{BTreeMap, BTreeSet};

/// So many faces that three threads get a piece each.
const MANY: usize = 200_000;

/// Vertices of many fans, open and closed, a few of huge degree, and some without a face.
fn soup(seed: u64) -> (usize, Vec<[u32; 3]>) {
    let mut random = Random(seed);
    let (mut vertices, mut faces) = (2001, wheel(2000));
    while faces.len() < MANY {
        let (degree, is_open) = (3 + random.below(9) as u32, random.below(2) == 0);
        let piece = wheel(degree).into_iter().skip(usize::from(is_open));
        faces.extend(piece.map(|face| face.map(|v| v + vertices)));
        vertices += degree + 1;
    }
    // Middles are merged, so that edges stay as they are.
    let mut target: Vec<u32> = (0..vertices).collect();
    let middles: BTreeSet<u32> = faces.iter().map(|face| *face.iter().min().unwrap()).collect();
    let middles: Vec<u32> = middles.into_iter().collect();
    for i in 0..middles.len() / 10 {
        let hub = if i % 5 == 0 { middles[0] } else { middles[random.below(middles.len())] };
        target[middles[random.below(middles.len())] as usize] = hub;
    }
    faces.iter_mut().for_each(|face| *face = face.map(|v| target[v as usize]));
    (vertices as usize + 3, shuffled(faces))
}

/// The starts of all fans of each vertex, the first first, each found by a walk from each of its half-edges.
fn walked(mesh: &impl Adjacency<Vertex = VertexId, HalfEdge = HalfEdgeId>) -> Vec<Vec<HalfEdgeId>> {
    let mut starts = vec![BTreeSet::new(); mesh.vertex_count()];
    for h in mesh.half_edges() {
        let (mut least, mut at) = (h, h);
        let (is_closed, start) = loop {
            match mesh.rotate_cw(at) {
                None => break (false, at),
                Some(g) if g == h => break (true, least),
                Some(g) => (at, least) = (g, least.min(g)),
            }
        };
        starts[mesh.origin(h).index()].insert((is_closed, start));
    }
    starts.into_iter().map(|starts| starts.into_iter().map(|(_, start)| start).collect()).collect()
}

fn by_threads(mesh: &CheL1, threads: usize) -> Fans<CheL1> {
    let pool = ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
    pool.install(|| fans_into(mesh, Vec::new())).unwrap()
}

fn assert_fans(vertex_count: usize, faces: &[[u32; 3]], has_several: bool) {
    let mesh = CheL1::from_faces(vertex_count, faces).unwrap();
    let walked = walked(&mesh);
    let several = walked.iter().enumerate().filter(|(_, starts)| starts.len() > 1);
    let several: Vec<_> = several.map(|(v, starts)| (VertexId::new(v), starts.clone())).collect();
    assert_eq!(!several.is_empty(), has_several);
    let found = [fans(&mesh).unwrap()].into_iter().chain([1, 2, 3, 8].map(|n| by_threads(&mesh, n)));
    for found in found {
        let first = found.outgoing.iter().map(|(_, first)| first.get());
        assert!(first.eq(walked.iter().map(|starts| starts.first().copied())));
        assert_eq!(found.several, several);
    }
}

#[test]
fn fans_are_the_same_by_any_number_of_threads() {
    for seed in 1..5 {
        let (vertex_count, faces) = soup(seed);
        assert_fans(vertex_count, &faces, true);
    }
}

#[test]
fn fans_that_all_threads_meet_are_one() {
    let torus = conformance::torus(400, 250);
    assert_fans(100_000, &torus, false);
    assert_fans(100_000, &shuffled(torus), false);
}

/// The two fans of a vertex come to different threads, so that only together they are several.
#[test]
fn fans_in_different_pieces_are_several() {
    let n = 250 * 300;
    let torus = conformance::torus(300, 250);
    let beside = torus.iter().map(|face| face.map(|v| if v == 100 { 100 } else { v + n }));
    let faces: Vec<_> = torus.iter().copied().chain(beside).collect();
    assert_fans(2 * n as usize, &faces, true);
}

#[test]
fn sweeps_by_threads_are_those_of_one() {
    let mesh = CheL2::from_faces(75_000, &conformance::torus(300, 250)).unwrap();
    let ring = |v| mesh.one_ring(v).collect::<Vec<_>>();
    let rings: Vec<_> = mesh.vertices().into_par_iter().map(ring).collect();
    assert!(rings.into_iter().eq(mesh.vertices().map(ring)));
    let count = |v: VertexId| (v, mesh.star(v).count());
    let counted: BTreeMap<_, _> = mesh.vertices().into_par_iter().rev().skip(7).map(count).collect();
    assert!(counted.into_iter().eq(mesh.vertices().take(75_000 - 7).map(count)));
    assert_eq!(mesh.faces().into_par_iter().len(), mesh.face_count());
    assert_eq!(mesh.edges().into_par_iter().max(), mesh.edges().next_back());
}

macro_rules! shared {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {
        const _: fn() = || {
            fn is_shared<T: Send + Sync>() {}
            $(is_shared::<$mesh>();)+
            is_shared::<Sot>();
            is_shared::<CompactStars>();
        };
    };
}
onering::with_backends!(shared);

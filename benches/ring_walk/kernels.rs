//! The sweeps that `ring_walk` times and `instructions` counts: each structure generic and by hand.
use super::by_hand::{Cells, Columns, Lists};
use onering::{
    AdjacencyGraph, CheL2, DirectedEdgesFull, DirectedEdgesMedium, DirectedEdgesSmall, FromFaces, Handle,
    Incidence,
};
use std::rc::Rc;

/// Sums the index of every neighbour of every vertex through the trait.
pub(crate) fn sweep(mesh: &impl Incidence) -> u64 {
    mesh.vertices().map(|v| mesh.one_ring(v).map(|u| u.index() as u64).sum::<u64>()).sum()
}

/// The same by `neighbours`, which is right where vertices have several fans as well.
pub(crate) fn sweep_neighbours(mesh: &impl Incidence) -> u64 {
    mesh.vertices().map(|v| mesh.neighbours(v).map(|u| u.index() as u64).sum::<u64>()).sum()
}

/// One kernel: which structure, which way, and the sweep itself.
pub(crate) struct Kernel {
    pub(crate) structure: &'static str,
    pub(crate) way: &'static str,
    pub(crate) run: Box<dyn Fn() -> u64>,
}

/// Every kernel over one mesh.
pub(crate) fn kernels(vertex_count: usize, faces: &[[u32; 3]]) -> Vec<Kernel> {
    fn pair<M: Incidence + FromFaces + 'static>(
        structure: &'static str,
        (vertex_count, faces): (usize, &[[u32; 3]]),
        by_hand: impl FnOnce(&M) -> Box<dyn Fn() -> u64>,
    ) -> [Kernel; 3] {
        let mesh = Rc::new(M::from_faces(vertex_count, faces).expect("a manifold"));
        let by_hand = Kernel { structure, way: "by hand", run: by_hand(&mesh) };
        let neighbours = Rc::clone(&mesh);
        [
            Kernel { structure, way: "one_ring", run: Box::new(move || sweep(&*mesh)) },
            Kernel { structure, way: "neighbours", run: Box::new(move || sweep_neighbours(&*neighbours)) },
            by_hand,
        ]
    }
    fn columns<M: Incidence>(
        sweep: impl Fn(&Columns) -> u64 + 'static,
    ) -> impl FnOnce(&M) -> Box<dyn Fn() -> u64> {
        |mesh| {
            let columns = Columns::of(mesh);
            Box::new(move || sweep(&columns))
        }
    }
    let mesh = (vertex_count, faces);
    let mut all = Vec::new();
    all.extend(pair::<CheL2>("che-l2", mesh, columns(Columns::compact)));
    all.extend(pair::<DirectedEdgesSmall>("directed-edges-small", mesh, columns(Columns::turned)));
    all.extend(pair::<DirectedEdgesMedium>("directed-edges-medium", mesh, columns(Columns::turned)));
    all.extend(pair::<DirectedEdgesFull>("directed-edges-full", mesh, columns(Columns::turned)));
    all.extend(pair::<AdjacencyGraph>("adjacency-graph", mesh, |mesh| {
        let lists = Lists::of(mesh);
        Box::new(move || lists.lists())
    }));
    all.extend(pair::<onering::MateFace>("mate-face", mesh, |mesh| {
        let cells = Cells::of(mesh);
        Box::new(move || cells.mate_face())
    }));
    let oriented =
        onering::MateFace::from_faces(vertex_count, faces).map(|mesh| Cells::of(&mesh)).expect("a manifold");
    let by_opposites = DirectedEdgesSmall::from_faces(vertex_count, faces).expect("a manifold");
    let by_opposites = Columns::of(&by_opposites);
    let run = Box::new(move || by_opposites.directed());
    all.push(Kernel { structure: "directed-edges-small", way: "by hand, from opposites", run });
    let run = Box::new(move || oriented.mate_face_oriented());
    all.push(Kernel { structure: "mate-face", way: "by hand, faces known to agree", run });
    let sums: Vec<u64> = all.iter().map(|kernel| (kernel.run)()).collect();
    assert!(sums.iter().all(|&sum| sum == sums[0]), "the sweeps disagree: {sums:?}");
    all
}

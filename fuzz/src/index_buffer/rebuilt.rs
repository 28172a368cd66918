//! Mesh after mesh in the same memory: each is, to the last word, what it is in fresh memory.
use super::List;
use onering::columns::Columns;
use onering::*;

/// The list between parts of it, so that tables shrink and grow, and meshes that are held come after refused ones; with
/// one builder, so that every structure finds what another one left.
pub(super) fn rebuilt(list: &List) {
    let mut builder = Builder::new();
    let half = list.faces.len() / 2;
    for faces in [&list.faces[half..], &list.faces, &list.faces[..half], &list.faces] {
        every(&mut builder, list.vertices, faces);
    }
}

fn same<M: Recycle + Columns>(builder: &mut Builder, vertices: usize, faces: &[[u32; 3]]) {
    let words = |mesh: &M| -> Vec<_> { mesh.columns().iter().map(|c| (c.name, c.bytes.to_vec())).collect() };
    match (M::from_faces(vertices, faces), builder.build::<M>(vertices, faces)) {
        (Ok(fresh), Ok(built)) => {
            assert_eq!(fresh.counts(), built.counts(), "{}", built.backend());
            assert_eq!(words(&fresh), words(&built), "{}", built.backend());
            builder.recycle(built);
        }
        (fresh, built) => assert_eq!(fresh.err(), built.err()),
    }
}

macro_rules! every {
    ($($mesh:ident)+) => {
        fn every(builder: &mut Builder, vertices: usize, faces: &[[u32; 3]]) {
            $(same::<$mesh>(builder, vertices, faces);)+
        }
    };
}
every!(SharedVertex CheL0 CheL1 CheL2 CheL2EdgeTable CheL3 DirectedEdgesSmall DirectedEdgesMedium DirectedEdgesFull
    MateFace);

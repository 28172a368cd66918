//! A mesh that is built in the memory of others is the same, to the last word, as one that is built afresh.
use onering::columns::Columns;
use onering::conformance::{self as laws, Case};
use onering::*;

/// The corpus with larger meshes between its cases, some of them out of order and one that is refused.
fn sequence() -> Vec<Case> {
    let mut reversed = laws::torus(40, 30);
    // Each face far from the one before.
    reversed.sort_by_key(|face| face[0].reverse_bits());
    let mut refused = laws::torus(30, 30);
    refused.push([0, 1, 900]);
    let larger = [
        (120, laws::torus(12, 10)),
        (1200, reversed),
        (900, refused),
        (1100, laws::torus(36, 30)), // with isolated vertices
        (910, laws::torus(30, 30)),
    ];
    let mut larger = larger.into_iter().cycle();
    let mut sequence = Vec::new();
    for case in laws::corpus() {
        let (vertices, faces) = larger.next().expect("it never ends");
        let between =
            Case { name: "a larger torus", vertices, faces, edges: 0, curves: None, flaws: Vec::new() };
        sequence.extend([case, between]);
    }
    sequence
}

/// Builds the next mesh in memory that the last ones left.
fn builds_the_same<M: Recycle + Columns>(builder: &mut Builder, case: &Case) {
    let fresh = M::from_faces(case.vertices, &case.faces);
    let built = builder.build::<M>(case.vertices, &case.faces);
    match (fresh, built) {
        (Ok(fresh), Ok(built)) => {
            assert_eq!(fresh.counts(), built.counts(), "{}", case.name);
            let columns =
                |mesh: &M| mesh.columns().iter().map(|c| (c.name, c.bytes.to_vec())).collect::<Vec<_>>();
            assert_eq!(columns(&fresh), columns(&built), "{}: {}", case.name, built.backend());
            built.validate().unwrap();
            builder.recycle(built);
        }
        (Err(fresh), Err(built)) => assert_eq!(fresh, built, "{}", case.name),
        (fresh, built) => panic!("{}: {:?} and {:?}", case.name, fresh.err(), built.err()),
    }
}

macro_rules! structures {
    ($($mesh:ident)+) => {
        /// Each structure with a builder of its own.
        #[test]
        fn mesh_after_mesh() {
            let sequence = sequence();
            $(
                let mut builder = Builder::new();
                sequence.iter().for_each(|case| builds_the_same::<$mesh>(&mut builder, case));
            )+
        }

        /// All structures with one builder, so that each finds the tables of others.
        #[test]
        fn structure_after_structure() {
            let mut builder = Builder::new();
            for case in sequence() {
                $(builds_the_same::<$mesh>(&mut builder, &case);)+
            }
        }
    };
}
structures!(SharedVertex CheL0 CheL1 CheL2 CheL2EdgeTable CheL3 DirectedEdgesSmall DirectedEdgesMedium
    DirectedEdgesFull MateFace);

/// Two meshes at a time never share memory, and both stay as they are.
#[test]
fn several_at_a_time() {
    let mut builder = Builder::new();
    for _ in 0..3 {
        let meshes: Vec<CheL2> =
            (6..10).map(|n| builder.build((n * n) as usize, &laws::torus(n, n)).unwrap()).collect();
        for (n, mesh) in (6..10).zip(&meshes) {
            assert_eq!(mesh.to_faces(), laws::torus(n, n));
            mesh.validate().unwrap();
        }
        meshes.into_iter().for_each(|mesh| builder.recycle(mesh));
    }
}

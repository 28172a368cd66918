//! The nine relations, on every backend that has their traits, against search over the face list.
#![allow(unreachable_pub, reason = "a test has no outside")]

mod checks;
mod oracle;
#[path = "../common/random.rs"]
mod random;
#[allow(dead_code, reason = "of the samples, the figures are not asked for here")]
#[path = "../algorithms/samples.rs"]
mod samples;
#[path = "../common/shapes.rs"]
mod shapes;

use onering::conformance::{Flaw, build, corpus};
use onering::*;
use oracle::Oracle;
use proptest::prelude::*;

/// Every mesh of the corpus and of the samples that `M` holds.
fn held<M: FromFaces>(holds: &[&str]) -> Vec<(Oracle, M)> {
    let corpus = corpus().into_iter().filter_map(|case| {
        let mesh = build::<M>(&case, &Flaw::named(holds))?;
        Some((Oracle::new(case.name, case.vertices, &case.faces), mesh))
    });
    let samples = samples::held::<M>()
        .map(|(sample, mesh)| (Oracle::new(&sample.name, sample.vertex_count, &sample.faces), mesh));
    corpus.chain(samples).collect()
}

macro_rules! each_trait {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {$(
        mod $name {
            use super::*;

            const HOLDS: &[&str] = &[$(stringify!($holds)),*];

            $(#[test]
            fn $has() {
                for (oracle, mesh) in held::<$mesh>(HOLDS) {
                    checks::$has(&oracle, &mesh);
                }
            })*

            proptest! {
                #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

                #[test]
                fn any_list((vertices, faces) in random::lists()) {
                    if let Ok(mesh) = <$mesh>::from_faces(vertices, &faces) {
                        let oracle = Oracle::new("at random", vertices, &faces);
                        $(checks::$has(&oracle, &mesh);)*
                    }
                }
            }
        }
    )+};
}
onering::with_backends!(each_trait);

/// A hub with many spokes, each there many times over: what is listed is each spoke once.
#[test]
fn edges_of_many_faces() {
    let faces: Vec<[u32; 3]> = (0..600).map(|i| [0, 1 + i % 3, 4 + i % 5]).collect();
    let mesh = DirectedEdgesSmall::from_faces(9, &faces).unwrap();
    checks::incidence(&Oracle::new("spokes", 9, &faces), &mesh);
    assert_eq!(relations::vertex_edges(&mesh, VertexId::new(0)).count(), 8);
    assert_eq!(relations::vertex_faces(&mesh, VertexId::new(0)).count(), 600);
}

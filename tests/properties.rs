//! Any face list whatever: pairing agrees with its definition, and every backend accepts what it holds, names what it
//! does not, and obeys the laws.
#[path = "common/naive.rs"]
mod naive;
#[path = "common/random.rs"]
mod random;

use naive::Naive;
use onering::conformance::{self as laws, Case, Flaw};
use onering::pairing::{Paired, pair};
use onering::*;
use proptest::prelude::*;
use std::fmt::Debug;

const PAIRINGS: [Pairing; 6] = [
    Pairing::Auto,
    Pairing::Quadratic,
    Pairing::PaperHash,
    Pairing::Hash,
    Pairing::Partition,
    Pairing::Chain,
];

fn config() -> ProptestConfig {
    ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, ..config() })]

    #[test]
    fn every_pairing_is_by_the_definition((vertices, faces) in random::lists()) {
        for pairing in PAIRINGS {
            let paired = pair(vertices, &faces, pairing);
            match naive::face_error(vertices, &faces, &[]) {
                Some(error) => prop_assert_eq!(paired, Err(error), "{}", pairing),
                None => agrees(&faces, &paired.unwrap(), &Naive::of(&faces))?,
            }
        }
    }
}

fn agrees(faces: &[[u32; 3]], paired: &Paired, naive: &Naive) -> Result<(), TestCaseError> {
    let opposite: Vec<_> = paired.opposite.iter().map(|o| o.get().map(Handle::index)).collect();
    prop_assert_eq!(&opposite, &naive.opposite);
    let records = paired.irregular.iter().map(|edge| edge.iter().map(|h| h.index()).collect::<Vec<_>>());
    prop_assert_eq!(&records.collect::<Vec<_>>(), &naive.irregular);
    prop_assert_eq!(paired.irregular.len(), naive.irregular.len());
    prop_assert_eq!(paired.clone().refuse_irregular(faces).err(), naive.edge_error(faces, &[]));
    let error = paired.clone().refuse_non_manifold(faces).err();
    prop_assert_eq!(error, naive.edge_error(faces, &[Flaw::SameDirection]));
    Ok(())
}

/// The mesh where a backend that holds these flaws accepts the list; with every pairing it decides alike.
fn decides<M: FromFaces + Debug>(
    (vertices, faces): &random::List,
    holds: &[&str],
) -> Result<Option<M>, TestCaseError> {
    let expected = naive::error(*vertices, faces, &Flaw::named(holds));
    for pairing in PAIRINGS {
        let error = M::build(*vertices, faces.into(), pairing).err();
        prop_assert_eq!(&error, &expected, "{}", pairing);
    }
    Ok(M::from_face_vec(*vertices, faces.clone()).ok())
}

/// The face and side that lie across each side of each face, by the definition.
fn opposites<M: Adjacency>(case: &Case, mesh: &M) {
    let sides = |f| mesh.face_half_edges(f);
    let side = |h| 3 * mesh.face(h).index() + sides(mesh.face(h)).iter().position(|&g| g == h).unwrap();
    let opposite: Vec<_> = mesh.faces().flat_map(sides).map(|h| mesh.opposite(h).map(side)).collect();
    assert_eq!(opposite, Naive::of(&case.faces).opposite);
}

macro_rules! law {
    (adjacency $case:ident $mesh:ident) => {
        laws::adjacency(&$case, &$mesh);
        opposites(&$case, &$mesh);
    };
    ($law:ident $case:ident $mesh:ident) => {
        laws::$law(&$case, &$mesh);
    };
}

macro_rules! backends {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {
        mod every_backend {
            use super::*;

            proptest! {
                #![proptest_config(config())]
                $(#[test]
                fn $name(list in random::lists()) {
                    if let Some(mesh) = decides::<$mesh>(&list, &[$(stringify!($holds)),*])? {
                        let case = Case::counted("at random", list.0, list.1);
                        laws::footprint(&case, &mesh);
                        $(law!($has case mesh);)*
                    }
                })+
            }
        }
    };
}
onering::with_backends!(backends);

proptest! {
    #![proptest_config(config())]

    #[test]
    fn adaptors((vertices, faces) in random::lists()) {
        let Ok(soup) = SharedVertex::from_faces(vertices, &faces) else { return Ok(()) };
        let case = Case::counted("at random", vertices, faces);
        let searched = Searched::new(&soup);
        laws::adjacency(&case, &searched);
        laws::incidence(&case, &searched);
        let with_opposites = WithOpposites::new(&soup);
        let several_fans = Flaw::named(&["several_fans"]);
        prop_assert_eq!(with_opposites.as_ref().err().cloned(), naive::error(vertices, &case.faces, &several_fans));
        let Ok(mesh) = with_opposites else { return Ok(()) };
        laws::adjacency(&case, &mesh);
        let with_outgoing = WithOutgoing::new(&mesh);
        prop_assert_eq!(with_outgoing.as_ref().err().cloned(), naive::error(vertices, &case.faces, &[]));
        let Ok(mesh) = with_outgoing else { return Ok(()) };
        laws::incidence(&case, &mesh);
    }

    /// Fans come in the order that is promised: open ones first, each kind by its start. A table and a search alike.
    #[test]
    fn fans_are_in_order((vertices, faces) in random::lists()) {
        let Ok(mesh) = DirectedEdgesSmall::from_faces(vertices, &faces) else { return Ok(()) };
        let searched = Searched::new(SharedVertex::from_faces(vertices, &faces).unwrap());
        for (v, fans) in (0..).map(VertexId::new).zip(Naive::of(&faces).fans(vertices, &faces)) {
            prop_assert!(mesh.fans(v).map(Handle::index).eq(fans.iter().map(|fan| fan[0])));
            prop_assert!(searched.fans(v).map(Handle::index).eq(fans.iter().map(|fan| fan[0])));
            prop_assert!(mesh.star(v).map(Handle::index).eq(fans.iter().flatten().copied()));
            prop_assert!(searched.star(v).map(Handle::index).eq(fans.iter().flatten().copied()));
        }
    }
}

/// The hash of Biscaro et al., `(10 v1 + v2) mod 3n`, has many collisions: it is there to compare with, on request.
#[test]
fn the_weak_hash_is_never_the_default() {
    assert_eq!(Pairing::default(), Pairing::Auto);
    let strip = |n: u32| (0..n).map(|i| [i, i + 1, i + 2]).collect::<Vec<_>>();
    for (faces, spare) in [(1, 0), (10, 0), (1000, 0), (400_000, 0), (10, 1 << 20), (1000, 1 << 20)] {
        let faces = strip(faces);
        let chosen = Pairing::choose(faces.len() + 2 + spare, &faces);
        assert!(!matches!(chosen, Pairing::PaperHash | Pairing::Quadratic), "{chosen}");
    }
}

//! Any face list whatever: pairing agrees with its definition, and every backend accepts what it holds, names what it
//! does not, and obeys the laws.
mod naive;
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
    Pairing::CountingSort,
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

    /// Directed edges and a search through all faces give the same, in the same order.
    #[test]
    fn searched_is_as_directed_edges((vertices, faces) in random::lists()) {
        let Ok(mesh) = DirectedEdgesSmall::from_faces(vertices, &faces) else { return Ok(()) };
        let searched = Searched::new(SharedVertex::from_faces(vertices, &faces).unwrap());
        for v in mesh.vertices() {
            prop_assert!(mesh.fans(v).eq(searched.fans(v)));
            prop_assert!(mesh.star(v).eq(searched.star(v)));
            prop_assert!(mesh.one_ring(v).eq(searched.one_ring(v)));
        }
    }
}

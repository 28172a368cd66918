//! Laws x corpus x registry: every backend holds and refuses what the registry says, and obeys the laws of every
//! trait that it has.
#[path = "common/gaps.rs"]
mod gaps;

use onering::conformance::{self as laws, Case, Flaw};
use onering::{FromFaces, Searched, SharedVertex, WithOpposites, WithOutgoing};

/// What soup holds.
const ANYTHING: &[&str] = &["degenerate", "non_manifold_edge", "same_direction", "several_fans"];

/// Runs a law on every case that a backend that holds these flaws accepts.
fn each<M: FromFaces>(holds: &[&str], law: impl Fn(&Case, &M)) {
    let holds = Flaw::named(holds);
    for case in laws::corpus() {
        if let Some(mesh) = laws::build::<M>(&case, &holds) {
            law(&case, &mesh);
        }
    }
}

/// The law of one trait, as a test. It runs on references as well: those forward every method.
macro_rules! law {
    (topology $mesh:ty) => {
        law!(@ topology $mesh);

        #[test]
        fn from_faces() {
            each::<$mesh>(HOLDS, laws::from_faces);
        }
    };
    ($law:ident $mesh:ty) => { law!(@ $law $mesh); };
    (@ $law:ident $mesh:ty) => {
        #[test]
        fn $law() {
            each::<$mesh>(HOLDS, |case, mesh| {
                laws::$law(case, mesh);
                law!(by_reference $law case mesh);
            });
        }
    };
    (by_reference graph $case:ident $mesh:ident) => {};
    (by_reference $law:ident $case:ident $mesh:ident) => {
        laws::$law($case, &$mesh);
        laws::$law($case, &&$mesh);
    };
}

macro_rules! backends {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {$(
        mod $name {
            use super::*;

            const HOLDS: &[&str] = &[$(stringify!($holds)),*];

            #[test]
            fn is_shared_and_copied() {
                fn check<M: Send + Sync + Clone + std::fmt::Debug + 'static>() {}
                check::<$mesh>();
            }

            #[test]
            fn footprint() {
                each::<$mesh>(HOLDS, |case, mesh| {
                    laws::footprint(case, mesh);
                    laws::footprint(case, &mesh);
                    laws::footprint(case, &mesh.clone());
                });
            }

            $(law!($has $mesh);)*
        }
    )+};
}
onering::with_backends!(backends);

/// Soup that looks through all faces obeys the laws, whatever is wrong with it.
#[test]
fn searched() {
    each::<SharedVertex>(ANYTHING, |case, soup| {
        let mesh = Searched::new(soup);
        laws::topology(case, &mesh);
        laws::adjacency(case, &mesh);
        laws::incidence(case, &mesh);
        laws::incidence(case, &&mesh);
        laws::graph(case, &mesh);
        laws::footprint(case, &mesh);
    });
}

/// Soup with opposites is strict about faces and edges, and so is a mesh with outgoing half-edges about vertices.
#[test]
fn with_opposites() {
    let holds = Flaw::named(&["several_fans"]);
    each::<SharedVertex>(ANYTHING, |case, soup| match (WithOpposites::new(soup), case.refusal(&holds)) {
        (Ok(mesh), None) => {
            laws::topology(case, &mesh);
            laws::adjacency(case, &mesh);
            laws::adjacency(case, &&mesh);
            laws::footprint(case, &mesh);
        }
        (mesh, expected) => assert_eq!(mesh.err().as_ref(), expected, "{}", case.name),
    });
}

#[test]
fn with_outgoing() {
    each::<onering::CheL1>(&["several_fans"], |case, mesh| {
        match (WithOutgoing::new(mesh), case.refusal(&[])) {
            (Ok(mesh), None) => {
                laws::topology(case, &mesh);
                laws::adjacency(case, &mesh);
                laws::incidence(case, &mesh);
                laws::incidence(case, &&mesh);
                laws::footprint(case, &mesh);
            }
            (mesh, expected) => assert_eq!(mesh.err().as_ref(), expected, "{}", case.name),
        }
    });
}

/// Irregular edges end fans, so that a vertex there has several.
#[test]
fn with_outgoing_on_a_mesh_of_irregular_edges() {
    each::<onering::DirectedEdgesSmall>(
        &["non_manifold_edge", "same_direction", "several_fans"],
        |case, mesh| {
            let several = case.flaws.iter().find(|(flaw, _)| *flaw == Flaw::SeveralFans);
            assert_eq!(
                WithOutgoing::new(mesh).err(),
                several.map(|(_, error)| error.clone()),
                "{}",
                case.name
            );
        },
    );
}

/// Adaptors keep what the mesh inside has.
#[test]
fn adaptors_hand_on_all_traits() {
    each::<onering::CheL3>(&[], |case, mesh| {
        let mesh = WithOutgoing::new(WithOpposites::new(mesh).unwrap()).unwrap();
        laws::topology(case, &mesh);
        laws::adjacency(case, &mesh);
        laws::incidence(case, &mesh);
        laws::incidence(case, mesh.mesh());
        laws::edge_map(case, &mesh);
        laws::boundaries(case, &mesh);
    });
}

/// Half-edges need not be numbered by corners.
#[test]
fn adaptors_take_handles_with_gaps() {
    each::<gaps::Gaps>(ANYTHING, |case, mesh| {
        laws::topology(case, mesh);
        laws::from_faces(case, mesh);
        laws::incidence(case, &Searched::new(mesh));
        if let Ok(mesh) = WithOpposites::new(mesh) {
            laws::adjacency(case, &mesh);
            if let Ok(mesh) = WithOutgoing::new(mesh) {
                laws::incidence(case, &mesh);
            }
        }
    });
}

//! Every backend: it accepts what it holds and names what it does not, obeys the laws, and serves every algorithm.
use super::{List, algorithms, naive};
use onering::conformance::{self as laws, Case, Flaw};
use onering::pairing::pair;
use onering::*;

/// No strategy of pairing changes what is answered.
pub(super) fn pairings(list: &List) {
    let found = |pairing| pair(list.vertices, &list.faces, pairing).map(|p| (p.opposite, p.irregular));
    let by_default = found(Pairing::Auto);
    for pairing in Pairing::ALL {
        assert_eq!(found(pairing), by_default, "{pairing}");
    }
}

/// The mesh where a backend that holds these flaws accepts the list.
fn decided<M: FromFaces>(list: &List, holds: &[&str], defects: &Defects) -> Option<M> {
    let built = M::from_faces(list.vertices, &list.faces);
    let error = built.as_ref().err();
    if list.is_searched() {
        let expected = naive::error(list.vertices, &list.faces, &Flaw::named(holds));
        assert_eq!(error, expected.as_ref());
    }
    let may_refuse = if holds.is_empty() { !defects.is_clean() } else { error.is_some() };
    assert_eq!(error.is_some(), may_refuse, "{error:?}, but {defects}");
    assert!(error.is_none() || !defects.is_clean(), "{error:?}");
    built.ok()
}

/// The list as a case of the conformance suite, where it is small.
fn case(list: &List) -> Option<Case> {
    list.is_searched().then(|| Case::counted("fuzzed", list.vertices, list.faces.clone()))
}

macro_rules! every {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {
        /// Every backend of the registry.
        pub(super) fn every(list: &List, defects: &Defects) {
            $(if let Some(mesh) = decided::<$mesh>(list, &[$(stringify!($holds)),*], defects) {
                if let Some(case) = case(list) {
                    laws::footprint(&case, &mesh);
                    $(every!(@ $has case mesh);)*
                }
                $(algorithms::$has(&mesh, list, defects);)*
            })+
        }

        /// Every backend accepts the list.
        pub(super) fn all_accept(vertices: usize, faces: &[[u32; 3]]) {
            $(if let Err(error) = <$mesh>::from_faces(vertices, faces) {
                panic!("{}: {error}", $text);
            })+
        }
    };
    (@ topology $case:ident $mesh:ident) => {
        laws::topology(&$case, &$mesh);
        laws::from_faces(&$case, &$mesh);
    };
    (@ $has:ident $case:ident $mesh:ident) => { laws::$has(&$case, &$mesh); };
}
with_backends!(every);

/// What adaptors add to soup is what a backend has.
pub(super) fn adaptors(list: &List, defects: &Defects) {
    let Ok(soup) = SharedVertex::from_faces(list.vertices, &list.faces) else { return };
    let Some(case) = case(list) else { return };
    let searched = Searched::new(&soup);
    laws::adjacency(&case, &searched);
    laws::incidence(&case, &searched);
    laws::graph(&case, &searched);
    if defects.degenerate_faces == 0 {
        algorithms::incidence(&searched, list, defects);
    }
    algorithms::of_any_faces(&searched, list);
    let with_opposites = WithOpposites::new(&soup);
    let several_fans = naive::error(list.vertices, &list.faces, &[Flaw::SeveralFans]);
    assert_eq!(with_opposites.as_ref().err(), several_fans.as_ref());
    let Ok(mesh) = with_opposites else { return };
    laws::adjacency(&case, &mesh);
    algorithms::adjacency(&mesh, list, defects);
    let with_outgoing = WithOutgoing::new(&mesh);
    assert_eq!(with_outgoing.as_ref().err(), naive::error(list.vertices, &list.faces, &[]).as_ref());
    let Ok(mesh) = with_outgoing else { return };
    laws::incidence(&case, &mesh);
    algorithms::incidence(&mesh, list, defects);
}

//! Pairing on meshes that are large enough for filters to be in doubt, lists to be long and parts to be many: every
//! strategy finds what the hash map finds.
#[path = "common/random.rs"]
#[allow(dead_code, reason = "of the random lists only their type is used")]
mod random;

use onering::conformance::torus;
use onering::memory::Spare;
use onering::pairing::{pair, pair_into, pair_with_starts};
use onering::{DirectedEdgesSmall, FromFaces, Handle, Pairing, Slot, fans};
use proptest::prelude::*;
use random::List;

/// Runs of four faces, each far from the one before: three of four faces are near the next one, which a sample of every
/// fourth would not see.
#[test]
fn a_mesh_in_runs_of_four_is_in_order() {
    let faces: Vec<[u32; 3]> = (0..1 << 14)
        .map(|i: u32| {
            let first = if i.div_ceil(4).is_multiple_of(2) { i } else { 1_000_000 + i };
            [first, first + 1, first + 2]
        })
        .collect();
    assert_eq!(Pairing::choose(faces.len(), &faces), Pairing::Chain);
}

/// Everything that the strategies find alike.
fn agree((vertices, faces): &List) -> Result<(), TestCaseError> {
    let expected = pair(*vertices, faces, Pairing::Hash).unwrap();
    for pairing in [Pairing::Auto, Pairing::Chain, Pairing::Partition] {
        let found = pair(*vertices, faces, pairing).unwrap();
        prop_assert!(found.opposite == expected.opposite, "{}: opposites", pairing);
        prop_assert_eq!(&found.irregular, &expected.irregular, "{}", pairing);
    }
    starts_agree(*vertices, faces)
}

/// The partition pairs alike where it looks for the starts of fans, and finds those that a look at all half-edges finds:
/// where there are further ones, or irregular edges, none.
fn starts_agree(vertices: usize, faces: &[[u32; 3]]) -> Result<(), TestCaseError> {
    let spare = &mut Spare::default();
    let (paired, starts) = pair_with_starts(vertices, faces, Pairing::Partition, Vec::new(), spare).unwrap();
    prop_assert!(paired == pair(vertices, faces, Pairing::Partition).unwrap());
    let mesh = DirectedEdgesSmall::build(vertices, faces.into(), Pairing::Hash).unwrap();
    let fans = fans::fans(&mesh).unwrap();
    let is_plain = paired.irregular.is_empty() && fans.several.is_empty();
    let is_sparse = vertices > 3 * faces.len();
    match starts {
        Some(starts) => prop_assert!(is_plain && starts == fans.outgoing.as_slice()),
        None => prop_assert!(!is_plain || is_sparse),
    }
    Ok(())
}

/// Faces around one vertex, which is the first or the last.
fn fan(faces: u32, is_least: bool) -> List {
    let (apex, first) = if is_least { (0, 1) } else { (faces, 0) };
    let face = |i| [apex, first + i, first + (i + 1) % faces];
    (faces as usize + 1, (0..faces).map(face).collect())
}

/// A torus whose faces are shuffled within runs of `run`, with some faces flipped, copied, or moved to other vertices.
fn worn() -> impl Strategy<Value = List> {
    let few =
        |most| prop::collection::vec((any::<prop::sample::Index>(), any::<prop::sample::Index>()), 0..most);
    (3..60u32, 3..60u32, 1..4000usize, any::<u64>(), few(4), few(4), few(4)).prop_map(
        |(n, m, run, seed, flipped, copied, moved)| {
            let (vertices, mut faces) = (n * m, torus(n, m));
            let mut state = seed | 1;
            for run in faces.chunks_mut(run) {
                for i in (1..run.len()).rev() {
                    state ^= state << 13;
                    state ^= state >> 7;
                    state ^= state << 17;
                    run.swap(i, (state % (i as u64 + 1)) as usize);
                }
            }
            for (at, _) in flipped {
                at.get_mut(&mut faces[..]).reverse();
            }
            for (at, other) in moved {
                let (old, new) = (at.index(vertices as usize) as u32, other.index(vertices as usize) as u32);
                faces.as_flattened_mut().iter_mut().filter(|v| **v == old).for_each(|v| *v = new);
            }
            for (at, to) in copied {
                let face = *at.get(&faces);
                faces.insert(to.index(faces.len()), face);
            }
            faces.retain(|[a, b, c]| a != b && b != c && c != a);
            (vertices as usize, faces)
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_pairing_of_a_worn_mesh_agrees(list in worn()) {
        agree(&list)?;
    }
}

/// Vertices of more edges than a filter has bits, and than it can count.
#[test]
fn huge_degrees_are_no_doubt_in_the_end() {
    for faces in [20, 56, 57, 255, 256, 257, 5000] {
        for is_least in [true, false] {
            let mut list = fan(faces, is_least);
            agree(&list).unwrap();
            assert_eq!(pair(list.0, &list.1, Pairing::Chain).unwrap().taken, Pairing::Chain);
            list.1.pop(); // an open fan
            agree(&list).unwrap();
            let [a, b, c] = list.1[0];
            list.1.push([a, b, c]);
            list.1.push([a, c, b]);
            agree(&list).unwrap();
            let irregular = pair(list.0, &list.1, Pairing::Chain).unwrap().irregular;
            assert_eq!(irregular.len(), 3, "three edges of three faces and more");
        }
    }
}

/// Two cones on the same ring of vertices and two more inside out: every edge of the ring has four half-edges, which pair
/// off into two edges that look regular.
#[test]
fn an_edge_that_was_closed_twice_is_found() {
    for n in [3, 4, 40, 400] {
        let cone = |apex: u32, i: u32| [apex, i, (i + 1) % n];
        let inside_out = |[a, b, c]: [u32; 3]| [a, c, b];
        let faces: Vec<_> = (0..n)
            .flat_map(|i| {
                [cone(n, i), inside_out(cone(n + 1, i)), cone(n + 2, i), inside_out(cone(n + 3, i))]
            })
            .collect();
        let list = (n as usize + 4, faces);
        agree(&list).unwrap();
        let paired = pair(list.0, &list.1, Pairing::Chain).unwrap();
        assert_eq!(paired.irregular.len(), n as usize);
        assert!(paired.irregular.iter().all(|edge| edge.len() == 4));
    }
}

/// Long enough for several threads to have a piece each, with irregular edges within pieces and across them.
#[test]
fn pieces_agree() {
    let mut faces = torus(200, 300);
    let last = faces.len() - 1;
    faces[last / 3].reverse();
    faces.push(faces[0]);
    faces.insert(last / 2, faces[last]);
    agree(&(60_000, faces.clone())).unwrap();
    let mut state = 88172645463325252_u64;
    for i in (1..faces.len()).rev() {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        faces.swap(i, (state % (i as u64 + 1)) as usize);
    }
    assert_eq!(pair(60_000, &faces, Pairing::Auto).unwrap().taken, Pairing::Partition);
    agree(&(60_000, faces)).unwrap();
    agree(&fan(100_000, true)).unwrap();
    let (vertices, mut open) = fan(100_000, false);
    open.swap_remove(50_000);
    agree(&(vertices, open)).unwrap();
    // No vertex has a second edge, and most have none.
    agree(&(1 << 22, (0..100_000).map(|i| [i, 2 * i + 1_000_000, 2 * i + 1_000_001]).collect())).unwrap();
}

/// The chain gives up where its lists are long, and says so.
#[test]
fn who_paired_is_told() {
    let (vertices, faces) = (60_000, torus(200, 300));
    let taken = |faces: &[[u32; 3]], pairing| pair(vertices, faces, pairing).unwrap().taken;
    assert_eq!(taken(&faces, Pairing::Auto), Pairing::Chain);
    for pairing in Pairing::ALL.into_iter().filter(|&pairing| pairing != Pairing::Quadratic) {
        assert_eq!(taken(&faces, pairing), pairing);
    }
    // Around one vertex, and each face far from the one before: all edges of the vertex are open for half of the time.
    let (vertices, fan) = fan(60_001, true);
    let spread: Vec<_> = (0..fan.len()).map(|i| fan[i * 2 % fan.len()]).collect();
    let spread_taken = |pairing| pair(vertices, &spread, pairing).unwrap().taken;
    assert_eq!(spread_taken(Pairing::Chain), Pairing::Partition);
    assert_eq!(spread_taken(Pairing::Auto), Pairing::Partition);
    agree(&(vertices, spread)).unwrap();
}

/// A table that is used again may be of any length and hold anything.
#[test]
fn a_table_is_overwritten() {
    let faces = torus(20, 30);
    let mut spare = Spare::default();
    for pairing in Pairing::ALL {
        let expected = pair(600, &faces, pairing).unwrap();
        for length in [0, 1, 3600, 5000] {
            let table = (0..length).map(|i| Slot::some(Handle::new(i))).collect();
            assert_eq!(pair_into(600, &faces, pairing, table, &mut spare).unwrap(), expected, "{pairing}");
        }
    }
}

//! Files with good checksums and any content: opening is an error, or the mesh obeys the laws over its own faces, so
//! every query ends and none panics.
use crate::seal::{seal, sections, u32_at};
use crate::{file_of, laws};
use onering::conformance::{self, Case, Flaw};
use onering::ring::File;
use std::collections::HashSet;

/// The meshes that are changed: few faces, so that many changes can be tried, and each kind of irregularity.
fn cases() -> Vec<Case> {
    let few = |case: &Case| (1..=8).contains(&case.faces.len()) && case.vertices <= 12;
    let mut cases: Vec<Case> = conformance::corpus().into_iter().filter(few).collect();
    let octahedron = [[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1], [5, 2, 1], [5, 3, 2], [5, 4, 3], [5, 1, 4]];
    let plain =
        [octahedron.to_vec(), vec![[0, 1, 2], [2, 1, 3], [3, 4, 5]], vec![[0, 1, 2], [0, 2, 3], [0, 3, 4]]];
    cases.extend(plain.map(|faces| Case::counted("plain", 6, faces)));
    cases
}

/// Numbers without a pattern.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % n as u64) as usize
    }
}

/// The places of all words of connectivity, and the numbers worth writing there.
fn words(bytes: &[u8]) -> (Vec<usize>, Vec<u32>) {
    let of_mesh = sections(bytes).into_iter().filter(|section| section.name != "positions");
    let places: Vec<usize> = of_mesh.flat_map(|s| (s.offset..s.offset + s.length).step_by(4)).collect();
    let bound = places.iter().map(|&at| u32_at(bytes, at)).filter(|&word| word < 1 << 16).max().unwrap_or(0);
    let few = (0..=bound + 3).map(|k| u32::MAX - k);
    let values = (0..=bound + 3).chain(few).chain([i32::MAX as u32, i32::MIN as u32, 1 << 16, 1 << 30]);
    (places, values.collect())
}

macro_rules! crafted {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {$(
        mod $name {
            use super::*;

            /// Opens a changed file. Gives whether it was accepted.
            fn obeys(bytes: &mut [u8], seen: &mut HashSet<Vec<u8>>) -> bool {
                seal(bytes);
                let file = File::from_bytes(bytes).expect("the checksums are good");
                let Ok(mesh) = file.mesh::<$mesh>() else { return false };
                if seen.insert(bytes.to_vec()) {
                    crafted!(@ obeys mesh, $($has)*);
                }
                true
            }

            fn each(mut change: impl FnMut(&[u8], &[usize], &[u32], &mut dyn FnMut(&mut [u8]) -> bool)) {
                let holds = Flaw::named(&[$(stringify!($holds)),*]);
                for case in cases().into_iter() {
                    let Ok(mesh) = <$mesh as onering::FromFaces>::from_faces(case.vertices, &case.faces) else {
                        continue;
                    };
                    assert!(case.refusal(&holds).is_none());
                    let bytes = file_of(&mesh);
                    let (places, values) = words(&bytes);
                    let mut seen = HashSet::new();
                    assert!(obeys(&mut bytes.clone(), &mut seen), "{}", case.name);
                    change(&bytes, &places, &values, &mut |bytes| obeys(bytes, &mut seen));
                }
            }

            #[test]
            fn one_word() {
                each(|bytes, places, values, open| {
                    for &at in places {
                        for value in values {
                            let mut bytes = bytes.to_vec();
                            bytes[at..at + 4].copy_from_slice(&value.to_le_bytes());
                            open(&mut bytes);
                        }
                    }
                });
            }

            #[test]
            fn some_words() {
                let mut numbers = Numbers(88172645463325252);
                each(|good, places, values, open| {
                    for round in 0..3000 {
                        let mut bytes = good.to_vec();
                        for _ in 0..2 + round % 4 {
                            let at = places[numbers.below(places.len())];
                            let other = places[numbers.below(places.len())];
                            // Any number, one that is somewhere else, or two in each other's place.
                            let word = match numbers.below(3) {
                                0 => values[numbers.below(values.len())],
                                1 => u32_at(&bytes, other),
                                _ => {
                                    let word = u32_at(&bytes, other);
                                    bytes.copy_within(at..at + 4, other);
                                    word
                                }
                            };
                            bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
                        }
                        open(&mut bytes);
                    }
                });
            }

            /// Words in range all over: what passes one check has to be caught by the others.
            #[test]
            fn all_words() {
                let mut numbers = Numbers(1234567891011);
                each(|good, places, values, open| {
                    for _ in 0..500 {
                        let mut bytes = good.to_vec();
                        for &at in places {
                            if numbers.below(3) == 0 {
                                let word = values[numbers.below(values.len() / 2)];
                                bytes[at..at + 4].copy_from_slice(&word.to_le_bytes());
                            }
                        }
                        open(&mut bytes);
                    }
                });
            }

            /// Columns of one mesh beside those of another.
            #[test]
            fn columns_of_two_meshes() {
                let meshes: Vec<_> = cases()
                    .iter()
                    .filter_map(|case| <$mesh as onering::FromFaces>::from_faces(case.vertices, &case.faces).ok())
                    .map(|mesh| file_of(&mesh))
                    .collect();
                let mut seen = HashSet::new();
                for (a, b) in meshes.iter().flat_map(|a| meshes.iter().map(move |b| (a, b))) {
                    if a.len() != b.len() || a[..48] != b[..48] {
                        continue;
                    }
                    let table = sections(a);
                    for mask in 0..1_u32 << (table.len() - 1) {
                        let mut bytes = a.clone();
                        for (i, section) in table.iter().enumerate() {
                            let place = section.offset..section.offset + section.length;
                            let same = b[section.entry..section.entry + 48] == a[section.entry..section.entry + 48];
                            if mask >> i & 1 == 1 && same {
                                bytes[place.clone()].copy_from_slice(&b[place]);
                            }
                        }
                        obeys(&mut bytes, &mut seen);
                    }
                }
            }
        }
    )+};
    // The laws run iterators to their end, which there has to be.
    (@ ends adjacency, $mesh:ident) => {{
        use onering::Adjacency;
        let count = $mesh.half_edge_count();
        assert!($mesh.half_edges().all(|h| $mesh.edge_fan(h).take(count + 1).count() <= count));
    }};
    (@ ends incidence, $mesh:ident) => {{
        use onering::Incidence;
        let count = $mesh.half_edge_count();
        assert!($mesh.vertices().all(|v| $mesh.fans(v).take(count + 1).count() <= count));
        assert!($mesh.vertices().all(|v| $mesh.star(v).take(count + 1).count() <= count));
        assert!($mesh.vertices().all(|v| $mesh.one_ring(v).take(count + 1).count() <= count));
        assert!($mesh.vertices().all(|v| $mesh.neighbours(v).take(count + 1).count() <= count));
    }};
    (@ ends boundaries, $mesh:ident) => {{
        use onering::Boundaries;
        let count = $mesh.half_edge_count();
        assert!($mesh.curves().all(|c| $mesh.curve(c).take(count + 1).count() <= count));
    }};
    (@ ends $other:ident, $mesh:ident) => {};
    (@ obeys $mesh:ident, graph) => {
        let n = $mesh.vertex_count();
        for u in $mesh.vertices() {
            assert!($mesh.neighbours(u).count() < n);
            assert!($mesh.vertex_faces(u).count() <= n * n);
            for v in $mesh.neighbours(u) {
                assert!($mesh.has_edge(v, u));
                assert!($mesh.edge_faces([u, v]).count() <= n);
                assert!($mesh.adjacent_edges([u, v]).count() <= 2 * n);
            }
        }
        assert_eq!($mesh.edges().count(), $mesh.edge_count());
        assert!($mesh.faces().all(|f| $mesh.adjacent_faces(f).count() <= 3 * n));
    };
    (@ obeys $mesh:ident, $($law:ident)*) => {
        use onering::Topology;
        $(crafted!(@ ends $law, $mesh);)*
        let case = Case::counted("crafted", $mesh.vertex_count(), $mesh.to_faces());
        laws!(&case, &$mesh, $($law)*);
    };
}
onering::with_backends!(crafted);

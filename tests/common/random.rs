//! Face lists made at random, with few vertices, so that defects are common.
use onering::conformance::torus;
use proptest::prelude::*;

/// Number of vertices, and faces.
pub(crate) type List = (usize, Vec<[u32; 3]>);

/// Any faces over a few vertices, now and then with one out of range.
fn any_faces() -> impl Strategy<Value = List> {
    let vertices = prop_oneof![1 => 0..3usize, 8 => 3..9usize];
    (vertices, prop::bool::weighted(0.1)).prop_flat_map(|(n, beyond)| {
        let index = 0..(n + usize::from(beyond)).max(1) as u32;
        let faces = prop::collection::vec([index.clone(), index.clone(), index], 0..14);
        faces.prop_map(move |faces| (n, faces))
    })
}

/// Faces over a few vertices, three different ones each.
fn proper_faces() -> impl Strategy<Value = List> {
    (3..9u32).prop_flat_map(|n| {
        let face = (0..n, 1..n, 1..n - 1).prop_map(move |(a, b, c)| {
            let c = if c >= b { c + 1 } else { c };
            [a, (a + b) % n, (a + c) % n]
        });
        prop::collection::vec(face, 0..12).prop_map(move |faces| (n as usize, faces))
    })
}

/// A piece of a torus: faces in any order and rotation, a few turned over, a few vertices merged.
fn pieces() -> impl Strategy<Value = List> {
    let shape = (3..6u32, 3..5u32);
    shape.prop_flat_map(|(n, m)| {
        let faces = Just(torus(n, m)).prop_shuffle();
        let few = |most| prop::collection::vec(any::<prop::sample::Index>(), 0..most);
        (Just(n * m), faces, 0..=(2 * n * m) as usize, few(3), few(5), 0..5usize).prop_map(
            |(vertices, mut faces, kept, flipped, merged, isolated)| {
                faces.truncate(kept);
                for (i, face) in faces.iter_mut().enumerate() {
                    face.rotate_left(i % 3);
                }
                for at in flipped.iter().filter(|_| kept > 0) {
                    at.get_mut(&mut faces[..]).reverse();
                }
                for pair in merged.chunks_exact(2) {
                    let [from, to] = [0, 1].map(|i| pair[i].index(vertices as usize) as u32);
                    faces.as_flattened_mut().iter_mut().filter(|v| **v == from).for_each(|v| *v = to);
                }
                (vertices as usize + isolated, faces)
            },
        )
    })
}

/// Everything above.
pub(crate) fn lists() -> impl Strategy<Value = List> {
    prop_oneof![any_faces(), proper_faces(), pieces()]
}

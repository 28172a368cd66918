//! Sub-meshes against sets of vertices.
#![allow(unreachable_pub, reason = "a test has no outside")]
#[path = "algorithms/samples.rs"]
#[allow(dead_code, reason = "each test uses a part of it")]
mod samples;
#[path = "common/shapes.rs"]
mod shapes;

use onering::submesh::{Submesh, submesh};
use onering::*;
use std::collections::BTreeSet;

fn agrees(part: &Submesh, faces: &[[u32; 3]], asked: &[usize], name: &str) {
    assert!(part.face_source.iter().map(|&f| f as usize).eq(asked.iter().copied()), "{name}");
    let used: BTreeSet<u32> = asked.iter().flat_map(|&f| faces[f]).collect();
    assert!(part.vertex_source.iter().eq(used.iter()), "{name}");
    assert_eq!(part.vertex_count, used.len(), "{name}");
    let back: Vec<_> = part.faces.iter().map(|face| face.map(|v| part.vertex_source[v as usize])).collect();
    assert!(back.iter().eq(asked.iter().map(|&f| &faces[f])), "{name}");
}

fn check<M: Topology + FromFaces>() {
    let mut random = shapes::Random(3);
    for (sample, mesh) in samples::held::<M>() {
        let all = mesh.face_count();
        let few: Vec<usize> = (0..all.min(3)).map(|_| random.below(all)).collect();
        let most: Vec<usize> = (0..all).rev().filter(|_| random.below(4) > 0).collect();
        for asked in [vec![], (0..all).collect(), few, most] {
            let part = submesh(&mesh, asked.iter().map(|&f| M::Face::new(f)));
            agrees(&part, &sample.faces, &asked, &sample.name);
            let is_part_of_clean = sample.is_clean && asked.is_sorted_by(|a, b| a < b) && asked.len() == all;
            assert!(!is_part_of_clean || M::from_faces(part.vertex_count, &part.faces).is_ok());
        }
    }
}

macro_rules! with_topology {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {$(
        $(with_topology!(@$has $name $mesh);)*
    )+};
    (@topology $name:ident $mesh:ty) => {
        #[test]
        fn $name() {
            check::<$mesh>();
        }
    };
    (@$other:ident $name:ident $mesh:ty) => {};
}
onering::with_backends!(with_topology);

/// Few faces of many vertices are numbered by sorting, many by a table: the answer is the same.
#[test]
fn few_faces_of_a_large_mesh() {
    let (n, faces) = shapes::grid(100, 100, [true, true], false);
    let mesh = SharedVertex::from_faces(n, &faces).unwrap();
    for step in [1, 7, 31, 33, 400, 19_999] {
        let asked: Vec<usize> = (0..faces.len()).step_by(step).collect();
        agrees(
            &submesh(&mesh, asked.iter().map(|&f| FaceId::new(f))),
            &faces,
            &asked,
            &format!("each {step}th"),
        );
    }
}

#[test]
fn values_are_carried() {
    let mesh = SharedVertex::from_faces(5, &[[0, 1, 2], [4, 2, 1]]).unwrap();
    let part = submesh(&mesh, [FaceId::new(1)]);
    assert_eq!(part.carry_vertices(&['a', 'b', 'c', 'd', 'e']), ['b', 'c', 'e']);
    assert_eq!(part.carry_faces(&[0.5, 1.5]), [1.5]);
}

//! Structures that renumber, beside the list of faces that they were made of.
use crate::shapes::{Faces, Random};
use onering::{Handle, Incidence, Renumbering};
use std::collections::HashMap;

/// Whether these are maps there and back between the same numbers.
fn are_inverse(source: &[u32], target: &[u32]) -> bool {
    let comes_back = |(i, &to): (usize, &u32)| source.get(to as usize) == Some(&(i as u32));
    source.len() == target.len() && target.iter().enumerate().all(comes_back)
}

/// The faces of a list in the numbers that the maps tell: nothing of the structure itself is asked.
pub(crate) fn renumbered(faces: &[[u32; 3]], maps: &Renumbering) -> Faces {
    assert!(are_inverse(&maps.vertex_source, &maps.vertex_target), "{maps:?}");
    let mut sources = maps.face_source.clone();
    sources.sort_unstable();
    assert!(sources.into_iter().eq(0..faces.len() as u32), "each face is there once: {maps:?}");
    let turned = |(mut face, &corner): ([u32; 3], &u8)| {
        face.rotate_left(corner.into());
        face.map(|v| maps.vertex_target[v as usize])
    };
    maps.carry_faces(faces).into_iter().zip(&maps.first_corner).map(turned).collect()
}

/// Compares a mesh too large for the laws with its list of faces.
pub(crate) fn is_of_list<M: Incidence>(name: &str, mesh: &M, vertices: usize, faces: &[[u32; 3]]) {
    assert_eq!((mesh.vertex_count(), mesh.face_count()), (vertices, faces.len()), "{name}");
    assert_eq!(mesh.to_faces(), faces, "{name}");
    let sides = || faces.iter().flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)]);
    let places: HashMap<(u32, u32), usize> = sides().zip(0..).collect();
    let half_edges: Vec<M::HalfEdge> = mesh.faces().flat_map(|f| mesh.face_half_edges(f)).collect();
    for ((a, b), &h) in sides().zip(&half_edges) {
        let across = places.get(&(b, a)).map(|&o| half_edges[o]);
        assert_eq!(mesh.opposite(h), across, "{name}: {h:?}");
        assert_eq!([mesh.origin(h), mesh.target(h)].map(|v| v.index() as u32), [a, b], "{name}: {h:?}");
    }
    let mut degrees = vec![0; vertices];
    faces.as_flattened().iter().for_each(|&v| degrees[v as usize] += 1);
    for v in mesh.vertices() {
        assert_eq!(mesh.star(v).count(), degrees[v.index()], "{name}: {v:?}");
        assert!(mesh.star(v).all(|h| mesh.origin(h) == v), "{name}: {v:?}");
        let start = mesh.outgoing(v);
        let is_closed = start.is_some_and(|h| mesh.opposite(h).is_some());
        let open = start.is_some() && !is_closed;
        assert_eq!(mesh.one_ring(v).count(), degrees[v.index()] + usize::from(open), "{name}: {v:?}");
    }
}

/// Vertices, faces and corners in another order.
pub(crate) fn mixed(vertices: usize, faces: &[[u32; 3]], seed: u64) -> Faces {
    let mut random = Random(seed);
    let mut names: Vec<u32> = (0..vertices as u32).collect();
    (1..vertices).rev().for_each(|i| names.swap(i, random.below(i + 1)));
    let mut faces: Faces = faces.iter().map(|face| face.map(|v| names[v as usize])).collect();
    (1..faces.len()).rev().for_each(|i| faces.swap(i, random.below(i + 1)));
    faces.iter_mut().for_each(|face| face.rotate_left(random.below(3)));
    faces
}

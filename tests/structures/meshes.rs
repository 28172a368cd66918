//! Small meshes, and the shapes of what they are asked.
use onering::*;

pub(crate) type Faces = Vec<[u32; 3]>;

pub(crate) fn v(i: usize) -> VertexId {
    VertexId::new(i)
}

pub(crate) fn h(i: usize) -> HalfEdgeId {
    HalfEdgeId::new(i)
}

pub(crate) fn f(i: usize) -> FaceId {
    FaceId::new(i)
}

pub(crate) fn indices<H: Handle>(handles: impl Iterator<Item = H>) -> Vec<usize> {
    handles.map(Handle::index).collect()
}

pub(crate) fn sorted<H: Handle>(handles: impl Iterator<Item = H>) -> Vec<usize> {
    let mut all = indices(handles);
    all.sort_unstable();
    all
}

/// The cells of Fig. 5 of Biscaro et al. (2016).
pub(crate) const TETRAHEDRON: [[u32; 3]; 4] = [[0, 1, 3], [1, 2, 3], [1, 0, 2], [3, 2, 0]];

/// A closed fan of `n` faces around vertex 0.
pub(crate) fn wheel(n: u32) -> Faces {
    (1..=n).map(|i| [0, i, i % n + 1]).collect()
}

/// Five vertices, five faces; all vertices are neighbours and on the boundary. Faces agree but for one pair.
pub(crate) const MOEBIUS: [[u32; 3]; 5] = [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 0], [4, 0, 1]];

/// The same, with all pairs of faces in disagreement.
pub(crate) const MOEBIUS_TWISTED: [[u32; 3]; 5] = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]];

/// A closed surface without orientation: 16 vertices of six faces each.
pub(crate) fn klein_bottle() -> Faces {
    let at = |i: u32, j: u32| if i == 4 { (4 - j % 4) % 4 } else { 4 * i + j % 4 };
    let quad = |(i, j)| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        [[a, b, c], [a, c, d]]
    };
    (0..4).flat_map(|i| (0..4).map(move |j| (i, j))).flat_map(quad).collect()
}

/// Two tetrahedra that share vertex 0.
pub(crate) fn two_tetrahedra() -> Faces {
    let second = TETRAHEDRON.map(|f| f.map(|v| if v == 0 { 0 } else { v + 3 }));
    [TETRAHEDRON, second].concat()
}

/// `n` faces along the edge 0-1, in turns of either direction.
pub(crate) fn book(n: u32) -> Faces {
    (0..n).map(|i| if i % 2 == 0 { [0, 1, i + 2] } else { [1, 0, i + 2] }).collect()
}

/// The same list in an order without rhyme, the same on every run.
pub(crate) fn shuffled(mut faces: Faces) -> Faces {
    let mut state = 1u64;
    for i in (1..faces.len()).rev() {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        faces.swap(i, (state >> 33) as usize % (i + 1));
    }
    faces
}

/// What every backend that refuses all defects says.
pub(crate) fn refuses_all<M: FromFaces>() {
    let error = |faces: &[[u32; 3]]| M::from_faces(9, faces).err();
    assert_eq!(
        error(&[[0, 1, 9]]),
        Some(BuildError::VertexOutOfRange { face: 0, vertex: 9, vertex_count: 9 })
    );
    assert_eq!(error(&[[0, 1, 2], [1, 1, 2]]), Some(BuildError::DegenerateFace { face: 1, vertex: 1 }));
    let three = BuildError::NonManifoldEdge { vertices: [0, 1], faces: 3, face: 2 };
    assert_eq!(error(&book(3)), Some(three));
    let same = BuildError::SameDirection { vertices: [0, 1], faces: [0, 1] };
    assert_eq!(error(&[[0, 1, 2], [0, 1, 3]]), Some(same));
    assert_eq!(error(&[[0, 1, 2], [0, 3, 4]]), Some(BuildError::SeveralFans { vertex: 0, fans: 2 }));
    let too_many = M::from_faces(usize::MAX, &[]).err();
    assert!(matches!(too_many, Some(BuildError::TooManyVertices { .. })));
}

/// A fan of 100,000 faces in no order: quadratic work would not end.
pub(crate) fn hub<M: FromFaces + Incidence<Vertex = VertexId>>() {
    let n = 100_000;
    let mesh = M::from_face_vec(n + 1, shuffled(wheel(n as u32))).unwrap();
    assert_eq!((mesh.star(v(0)).count(), mesh.one_ring(v(0)).count()), (n, n));
    assert_eq!((mesh.star(v(7)).count(), mesh.neighbours(v(7)).count()), (2, 3));
}

//! Counts at the ends of what can be: an error or an answer, never an abort.
use onering::conformance::Flaw;
use onering::*;

const FACE: [u32; 3] = [0, 1, 2];

/// A vertex count that no handle can name is refused before anything else is looked at.
fn refuses_too_many_vertices<M: FromFaces>() {
    for vertices in [usize::MAX, 1 << 40, u32::MAX as usize + 1] {
        for faces in [&[][..], &[FACE], &[[7, 7, 7]]] {
            match M::from_faces(vertices, faces).err() {
                Some(BuildError::TooManyVertices { vertices: said, limit }) => {
                    assert_eq!(said, vertices);
                    assert!(limit <= u32::MAX as usize);
                }
                other => panic!("{vertices} vertices: {other:?}"),
            }
        }
    }
}

/// No vertex is there to be named.
fn refuses_a_face_without_vertices<M: FromFaces>() {
    let error = BuildError::VertexOutOfRange { face: 0, vertex: 0, vertex_count: 0 };
    assert_eq!(M::from_faces(0, &[FACE]).err(), Some(error));
}

/// A few faces over many vertices: where there is no table over vertices, over as many as there can be.
fn takes_many_vertices<M: FromFaces + Footprint>() {
    let vertices = if M::BYTES.vertex == 0 { u32::MAX as usize } else { 1 << 20 };
    let faces = [FACE, [2, 1, vertices as u32 - 1]];
    let mesh = M::from_faces(vertices, &faces).unwrap();
    assert!(mesh.heap_bytes() <= M::BYTES.vertex * vertices + 1000);
}

/// A fan of many faces in no order: no list is walked for every face.
fn takes_a_hub<M: FromFaces>() {
    const FACES: u32 = 100_000;
    // A step that has no factor in common with the number of faces visits each once.
    let face = |i: u32| {
        let i = (u64::from(i) * 61_803 % u64::from(FACES)) as u32;
        [0, 1 + i, 1 + (i + 1) % FACES]
    };
    let faces: Vec<_> = (0..FACES).map(face).collect();
    let mesh = M::from_faces(FACES as usize + 1, &faces);
    assert_eq!(mesh.err(), None);
}

macro_rules! backends {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {$(
        #[test]
        fn $name() {
            refuses_too_many_vertices::<$mesh>();
            refuses_a_face_without_vertices::<$mesh>();
            takes_many_vertices::<$mesh>();
            takes_a_hub::<$mesh>();
        }
    )+};
}
onering::with_backends!(backends);

#[test]
fn every_flaw_has_the_name_that_the_registry_gives_it() {
    for entry in registry::BACKENDS {
        assert_eq!(Flaw::named(entry.holds).len(), entry.holds.len(), "{}", entry.name);
    }
}

#[test]
fn adaptors_refuse_too_many_vertices() {
    /// Points, as many as are asked for.
    struct Points(usize);

    impl Topology for Points {
        type Vertex = VertexId;
        type HalfEdge = HalfEdgeId;
        type Face = FaceId;

        fn vertex_count(&self) -> usize {
            self.0
        }

        fn face_count(&self) -> usize {
            0
        }

        fn origin(&self, h: HalfEdgeId) -> VertexId {
            panic!("{h:?} in a mesh without faces")
        }
    }

    impl Adjacency for Points {
        fn opposite(&self, _: HalfEdgeId) -> Option<HalfEdgeId> {
            None
        }
    }

    let refused = |error| matches!(error, Some(BuildError::TooManyVertices { .. }));
    assert!(refused(WithOpposites::new(Points(usize::MAX)).err()));
    assert!(refused(WithOutgoing::new(Points(usize::MAX)).err()));
    assert!(WithOpposites::new(Points(u32::MAX as usize)).is_ok());
}

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
mod hub {
    use super::*;
    use onering::neighbours::Neighbours;

    pub(super) const FACES: usize = 100_000;

    pub(super) fn build<M: FromFaces>() -> M {
        // A step that has no factor in common with the number of faces visits each once.
        let face = |i: usize| [0, 1 + i * 61_803 % FACES, 1 + (i * 61_803 + 1) % FACES].map(|v| v as u32);
        M::from_face_vec(FACES + 1, (0..FACES).map(face).collect()).unwrap()
    }

    pub(super) fn topology<M: Topology>(mesh: &M) {
        assert_eq!(mesh.half_edges().count(), 3 * FACES);
    }

    pub(super) fn adjacency<M: Adjacency>(mesh: &M) {
        assert_eq!(mesh.half_edges().filter(|&h| mesh.opposite(h).is_some()).count(), 2 * FACES);
    }

    pub(super) fn incidence<M: Incidence>(mesh: &M) {
        let [hub, rim] = [0, 7].map(M::Vertex::new);
        assert_eq!((mesh.star(hub).count(), mesh.one_ring(hub).count()), (FACES, FACES));
        assert_eq!((mesh.star(rim).count(), mesh.one_ring(rim).count()), (2, 3));
        graph(mesh);
    }

    pub(super) fn graph<M: Neighbours>(mesh: &M) {
        let [hub, rim] = [0, 7].map(M::Node::new);
        assert_eq!((mesh.neighbours(hub).count(), mesh.neighbours(rim).count()), (FACES, 3));
    }

    pub(super) fn edge_map<M: EdgeMap>(mesh: &M) {
        assert_eq!(mesh.edge_count(), 2 * FACES);
    }

    pub(super) fn boundaries<M: Boundaries>(mesh: &M) {
        assert_eq!(mesh.curves().map(|c| mesh.curve(c).count()).collect::<Vec<_>>(), [FACES]);
    }
}

macro_rules! backends {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {$(
        #[test]
        fn $name() {
            refuses_too_many_vertices::<$mesh>();
            refuses_a_face_without_vertices::<$mesh>();
            takes_many_vertices::<$mesh>();
            let hub: $mesh = hub::build();
            $(hub::$has(&hub);)*
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

//! Laws of [`FromFaces`].
use crate::{
    BuildError, FromFaces, Pairing, Topology,
    conformance::{Case, slow::FaceList},
};
use alloc::{borrow::Cow, vec::Vec};

/// Laws of [`FromFaces`], for a case that the backend accepts: however it is built, and from whatever other mesh, it
/// gives the faces back.
pub fn from_faces<M: FromFaces + Topology>(case: &Case, mesh: &M) {
    let (n, faces) = (case.vertices, &case.faces);
    let same = |how: &str, built: Result<M, BuildError>| match built {
        Ok(built) => {
            assert_eq!(built.vertex_count(), n, "{}: vertices, {how}", case.name);
            assert_eq!(built.to_faces(), *faces, "{}: faces, {how}", case.name);
        }
        Err(error) => panic!("{}: {how}: {error}", case.name),
    };
    same("from a slice", M::from_faces(n, faces));
    same("from a vector", M::from_face_vec(n, faces.clone()));
    let mut roomy = Vec::with_capacity(2 * faces.len() + 1);
    roomy.extend_from_slice(faces);
    same("from a vector with room to spare", M::from_face_vec(n, roomy));
    for pairing in Pairing::ALL.into_iter().chain([Pairing::Auto]) {
        same("with a pairing, borrowed", M::build(n, Cow::Borrowed(faces), pairing));
        same("with a pairing, owned", M::build(n, Cow::Owned(faces.clone()), pairing));
    }
    same("from another mesh", M::from_topology(&FaceList { vertices: n, faces }));
    same("from itself", M::from_topology(mesh));
    same("from a reference to itself", M::from_topology(&mesh));
}

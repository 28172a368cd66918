//! [`FromFaces`]: construction, the same for every backend.
use crate::{BuildError, Pairing, Topology};
use alloc::{borrow::Cow, vec::Vec};

/// Made from a list of triangles.
///
/// Faces are three vertex indices each, counter-clockwise; vertices are `0..vertex_count`. Any list whatever is
/// an answer, `Ok` or a [`BuildError`] that names an element: no panic, no silent mis-pairing.
pub trait FromFaces: Sized {
    /// The topology of `faces`, with the choice how to pair half-edges. O(faces) time but where `pairing` says
    /// otherwise; a backend keeps an owned list as its column where it can, without a copy.
    ///
    /// # Errors
    /// What the backend cannot hold, the first element that is at fault; see [`BuildError`].
    fn build(vertex_count: usize, faces: Cow<'_, [[u32; 3]]>, pairing: Pairing) -> Result<Self, BuildError>;

    /// The topology of `faces`.
    ///
    /// # Errors
    /// As for [`build`](Self::build).
    fn from_faces(vertex_count: usize, faces: &[[u32; 3]]) -> Result<Self, BuildError> {
        Self::build(vertex_count, faces.into(), Pairing::Auto)
    }

    /// The topology of `faces`, which it keeps as its column where it can.
    ///
    /// # Errors
    /// As for [`build`](Self::build).
    fn from_face_vec(vertex_count: usize, faces: Vec<[u32; 3]>) -> Result<Self, BuildError> {
        Self::build(vertex_count, faces.into(), Pairing::Auto)
    }

    /// The same topology as `mesh`, stored as this backend does. Vertices and faces keep their order.
    ///
    /// # Errors
    /// As for [`build`](Self::build).
    fn from_topology(mesh: &impl Topology) -> Result<Self, BuildError> {
        Self::from_face_vec(mesh.vertex_count(), mesh.to_faces())
    }
}

//! [`Builder`]: mesh after mesh in the same memory.
use crate::{BuildError, FromFaces, Pairing, memory::Spare};
use alloc::borrow::Cow;

/// Builds mesh after mesh in the same memory: [`recycle`](Self::recycle) takes back a mesh that is no longer needed, and
/// [`build`](Self::build) writes the next one where it was. The system hands out fresh memory page by page, which for large
/// meshes takes longer than to fill it.
///
/// Meshes are the same as those of [`FromFaces::from_faces`], and take no more memory. What is spare is kept, with the
/// scratch of the pairing (12 bytes a vertex on a mesh in order), until a mesh of about the same size takes it, or until
/// the builder is dropped. A table serves whichever structure has one of its size next.
///
/// ```
/// # use onering::*;
/// let mut builder = Builder::new();
/// for faces in [[[0, 1, 2], [2, 1, 3]], [[0, 1, 3], [0, 3, 2]]] {
///     let mesh: CheL1 = builder.build(4, &faces)?;
///     assert_eq!(mesh.face_count(), 2);
///     builder.recycle(mesh);
/// }
/// # Ok::<(), BuildError>(())
/// ```
#[derive(Debug)]
pub struct Builder {
    spare: Spare,
}

impl Builder {
    /// With nothing to spare: the first mesh is built in fresh memory.
    pub fn new() -> Self {
        Self { spare: Spare::kept() }
    }

    /// The topology of `faces`, in memory that is spare, as far as there is any.
    ///
    /// # Errors
    /// As for [`FromFaces::build`]. The builder can go on; what the mesh would have been made of may be freed.
    pub fn build<M: Recycle>(&mut self, vertex_count: usize, faces: &[[u32; 3]]) -> Result<M, BuildError> {
        M::build_in(vertex_count, faces.into(), Pairing::Auto, &mut self.spare)
    }

    /// Takes the memory of a mesh, whoever built it. O(1).
    pub fn recycle<M: Recycle>(&mut self, mesh: M) {
        mesh.leave(&mut self.spare);
    }
}

impl Default for Builder {
    fn default() -> Self {
        Self::new()
    }
}

/// A structure that can be built in the memory of another one, by a [`Builder`]. Others are built by [`FromFaces`] alone:
///
/// ```compile_fail,E0277
/// # use onering::*;
/// let mesh: HalfEdgeMesh = Builder::new().build(3, &[[0, 1, 2]])?;
/// # Ok::<(), BuildError>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is always built in fresh memory",
    note = "build it by `FromFaces`; the rows of `onering::layout` and `MateFace` can be built by a `Builder`"
)]
pub trait Recycle: FromFaces {
    /// As [`build`](FromFaces::build), in spare tables where there are any.
    ///
    /// # Errors
    /// As for [`build`](FromFaces::build).
    fn build_in(
        vertex_count: usize,
        faces: Cow<'_, [[u32; 3]]>,
        pairing: Pairing,
        spare: &mut Spare,
    ) -> Result<Self, BuildError>;

    /// Leaves its tables to the next mesh.
    fn leave(self, spare: &mut Spare);
}

//! Any structure of the registry, by its name.
use super::File;
use super::problem::{Problem, of_header, of_section};
use crate::columns::Columns;
use crate::{BuildError, FromFaces, Handle, Pairing, Topology, memory};
use alloc::{borrow::Cow, boxed::Box, format, vec::Vec};
use onering_io::{Error, Triangles};

macro_rules! by_name {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {
        /// Builds the structure of this name, as the registry has it, from a list of triangles, to be
        /// [written](super::write()). `None` where the registry has no such name.
        ///
        /// # Errors
        /// What the structure says: see [`FromFaces::build`].
        pub fn build(
            backend: &str,
            vertex_count: usize,
            faces: Cow<'_, [[u32; 3]]>,
        ) -> Option<Result<Box<dyn Columns>, BuildError>> {
            fn boxed<M: FromFaces + Columns + 'static>(
                vertex_count: usize,
                faces: Cow<'_, [[u32; 3]]>,
            ) -> Result<Box<dyn Columns>, BuildError> {
                Ok(Box::new(M::build(vertex_count, faces, Pairing::Auto)?))
            }
            match backend {
                $($text => Some(boxed::<$mesh>(vertex_count, faces)),)+
                _ => None,
            }
        }

        /// The faces of the mesh in a file, whichever structure of the registry it is. O(elements), for it is
        /// validated unless the file is trusted.
        ///
        /// # Errors
        /// Those of [`File::mesh`]; a structure that is not in the registry, and the vertex graph, which has no faces.
        pub fn faces(file: &File) -> Result<Vec<[u32; 3]>, Error> {
            match file.backend() {
                $($text => by_name!(@ $($has)*; $mesh, file),)+
                other => Err(file.error(of_header(48, format!("{other} is no structure of the registry")))),
            }
        }
    };
    (@ graph; $mesh:ty, $file:ident) => {
        Err($file.error(of_header(48, format!("the structure is {}, which has no faces", $file.backend()))))
    };
    (@ topology $($more:ident)*; $mesh:ty, $file:ident) => {{
        let mesh = $file.mesh::<$mesh>()?;
        let faces = mesh.faces().map(|f| mesh.face_vertices(f).map(|v| v.index() as u32));
        memory::collected(faces).map_err(|_| $file.error(Problem::OutOfMemory { bytes: 12 * mesh.face_count() }))
    }};
}
with_backends!(by_name);

/// The triangles in a file, whichever structure of the registry it is, as the readers of other formats give them.
///
/// # Errors
/// As [`faces`], and for a file without positions.
pub fn triangles(file: &File) -> Result<Triangles, Error> {
    let Some(positions) = file.positions() else {
        return Err(file.error(of_section(super::file::POSITIONS, 0, "is missing")));
    };
    let out_of_memory = |_| file.error(Problem::OutOfMemory { bytes: size_of_val(positions) });
    let positions = memory::collected(positions.iter().copied()).map_err(out_of_memory)?;
    Ok(Triangles::new(positions, faces(file)?))
}

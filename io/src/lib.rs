//! Mesh files in and out of onering.
//!
//! [`load`] reads a file, [`read`] reads bytes; both give [`Triangles`]: positions, faces, how the
//! polygons were cut, and [notes](Note) on what was left out. What cannot be read is an [`Error`] that
//! names the line or the element at fault. No input makes a reader panic, and how much time and memory one
//! may take is bounded by its size: see [`load`].
//!
//! | format | extensions | module |
//! |---|---|---|
//! | Wavefront OBJ | `.obj` | [`obj`] |
//! | glTF 2.0 | `.gltf`, `.glb` | [`gltf`] |
//! | PLY | `.ply` | [`ply`] |
//! | X3D, as XML | `.x3d` | [`x3d`] |
//! | VRML97, and X3D in its classic encoding | `.wrl`, `.vrml`, `.x3dv` | [`vrml`] |
//! | STL | `.stl` | [`stl`] |
//! | OFF | `.off` | [`off`] |
//!
//! With the feature `tobj`, `obj_attributes` reads the texture coordinates, normals and materials of an OBJ
//! file, corner by corner of the same faces.
//!
//! ```
//! let square = b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n";
//! let mesh = onering_io::read(square)?;
//! assert_eq!(mesh.faces, [[0, 1, 2], [0, 2, 3]]);
//! assert_eq!(mesh.polygon_count(), 1);
//! # Ok::<(), onering_io::Error>(())
//! ```
//!
//! # What every reader keeps to
//! - Vertices and faces come in the order of the file. No vertex is dropped or merged, but for the corners of
//!   STL: see [`Options::weld_stl`].
//! - A polygon `a b c d ...` becomes the fan `a b c`, `a c d`, ... from its first corner.
//! - Coordinates are `f32`, each rounded once from what the file says. `inf` and `nan` are kept where a
//!   file has them.
//! - Degenerate, duplicate and non-manifold faces are kept: finding and mending them is the library's work.

mod attribute;
mod beside;
mod block;
pub mod colour;
mod decimal;
mod error;
mod format;
pub mod gltf;
mod gzip;
mod lines;
mod load;
mod memory;
mod mesh_ref;
#[cfg(feature = "tobj")]
mod mtl;
mod number;
pub mod obj;
#[cfg(feature = "tobj")]
pub mod obj_attributes;
pub mod off;
mod place;
pub mod ply;
mod polygons;
mod proportion;
mod replacement;
pub mod ring;
mod save;
mod scene;
pub mod stl;
mod text;
mod triangles;
pub mod vrml;
mod words;
pub mod x3d;

pub use attribute::{Attribute, Values};
pub use error::{Error, Reason, one_line};
pub use format::Format;
pub use gzip::unpacked;
pub use lines::{Line, Lines};
pub use load::{Options, bytes_of, load, read, read_as, read_at};
pub use mesh_ref::MeshRef;
pub use place::{Item, Place};
pub use replacement::Replacement;
pub use save::{SaveOptions, save, save_as, write};
pub use triangles::{Note, Skipped, Triangles};

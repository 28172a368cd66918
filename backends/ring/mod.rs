//! `.ring`: onering's own binary file, to be opened without building anything again.
//!
//! A file holds the columns of one structure, any in the [registry](crate::registry), as they are in memory, and
//! positions beside them. Opening maps it and looks at what is there; a mesh then borrows its columns from
//! the file.
//!
//! ```
//! use onering::ring::{self, File};
//! use onering::{CheL2, FromFaces, Incidence, Topology};
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! # let path = std::env::temp_dir().join(format!("onering-doc-{}.ring", std::process::id()));
//! let positions = [[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]];
//! let mesh = CheL2::from_faces(4, &[[0, 1, 2], [0, 2, 3]])?;
//! ring::save(&path, &mesh, Some(&positions))?;
//!
//! let file = File::read(&path)?; // or `unsafe { File::open(&path) }?`, which maps it
//! let mesh = file.mesh::<CheL2>()?;
//! let v = mesh.vertices().next().unwrap();
//! assert_eq!((mesh.one_ring(v).count(), file.positions().map(<[_]>::len)), (3, Some(4)));
//! # std::fs::remove_file(&path)?;
//! # Ok(())
//! # }
//! ```
//!
//! # Which way to open
//! | | takes | looks at | safe |
//! |---|---|---|---|
//! | [`File::read`] | memory of the size of the file | everything | yes |
//! | [`File::open`] (feature `mmap`) | a map | everything | where nobody changes the file meanwhile |
//! | [`File::open_trusted`] (feature `mmap`) | a map | the head | where it is, besides, as it was written |
//!
//! `open` is `unsafe` because a map shows what others write to the file later, whatever was checked before: a safe
//! function could not keep its word. What a file holds is never the matter: every column is plain words, all
//! accessors check bounds, of owned columns as of borrowed ones, and over borrowed ones every step around a vertex does.
//!
//! # Layout, version 1
//! All numbers are little-endian; a big-endian machine refuses to read and write. Reserved bytes are 0, and so are those
//! between sections. Names are ASCII `a-z`, `0-9`, `-` and `_`, padded with zeros.
//!
//! | byte | type | |
//! |---|---|---|
//! | 0 | `[u8; 8]` | `89 72 69 6E 67 0D 0A 1A`: [`onering_io::ring::MAGIC`] |
//! | 8 | `u32` | version: 1 |
//! | 12 | `u32` | `0x01020304`, so the bytes `04 03 02 01` |
//! | 16 | `u64` | length of the file in bytes |
//! | 24 | `u64` | number of vertices, at most 2^32 - 1 |
//! | 32 | `u64` | number of faces; 0 for the vertex graph |
//! | 40 | `u32` | number n of sections, at most 64 |
//! | 44 | `u32` | reserved |
//! | 48 | `[u8; 64]` | name of the structure in the registry: `che-l2` |
//! | 112 | `[u8; 16]` | reserved |
//! | 128 + 64 i | 64 bytes | entry of section i, see below |
//! | 128 + 64 n | `u64` | XXH3-64 (seed 0) of all bytes before it |
//! | 136 + 64 n | `[u8; 56]` | reserved |
//! | 192 + 64 n | | the first section |
//!
//! | byte of an entry | type | |
//! |---|---|---|
//! | 0 | `[u8; 24]` | name: each is there once |
//! | 24 | `u32` | bytes of an element |
//! | 28 | `u32` | reserved |
//! | 32 | `u64` | first byte of the section: the first multiple of 64 from the end of the one before |
//! | 40 | `u64` | length in bytes, a multiple of that of an element |
//! | 48 | `u64` | XXH3-64 (seed 0) of the section |
//! | 56 | `u64` | reserved |
//!
//! The file ends where the last section does. Section `positions`, where it is there, has three `f32` for each vertex. A
//! section that the structure does not have is left alone, so that others can keep attributes there; its
//! checksum has to be good. A change of any of this that an old reader would misread is another version.
//!
//! # Sections of the structures
//! V, F and H = 3F are the numbers of vertices, faces and half-edges; half-edge 3f + k starts at corner k of face f. A
//! *slot* is a `u32`, a number or `FFFFFFFF` for none. A *coded link* is an `i32`: a half-edge from 0 up, -1 for none,
//! -(k + 2) for number k. *Records* are lists one after the other, each its length and then its numbers, named by the
//! place of the length.
//!
//! | structure | sections, in this order |
//! |---|---|
//! | `shared-vertex`, `che-l0` | `origin` `u32` x H |
//! | `che-l1` | and `opposite` slot x H |
//! | `che-l2` | and `outgoing` slot x V; `edge_list` `u32`, the least half-edge of each edge, ascending |
//! | `che-l2-edge-table` | and `edge_index` `u32` x H, places in `edge_list` |
//! | `che-l3` | as `che-l2`, links coded; `curve_list` `u32`, the first half-edge of each curve; -(k + 2) in `opposite` is curve k |
//! | `directed-edges-small` | `target` `u32` x H; `rotate_ccw` coded x H, where cell next(h) is the link across h; `outgoing` coded x V; `edge_records`, `vertex_records` `u32` |
//! | `directed-edges-medium` | and `prev` `u32` x H, after `target` |
//! | `directed-edges-full` | and `origin` before `target`, `next` after it |
//! | `mate-face` | `cells` x F: three vertices, three slots of mates; `vertices` coded links to faces x V; `records` `u32` |
//! | `half-edge` | `records` x H: vertex, next, prev, slot of the opposite, face; `outgoing` slot x V |
//! | `winged-edge` | `edges`: two vertices, slots of two faces, two next edges, two previous; `vertices` slot x V; `faces` `u32` x F |
//! | `vertex-graph` | `offsets` `u32` x (V + 1); `neighbours` `u32` |
//! | `adjacency-graph` | those of `directed-edges-small`; `offsets` `u32` x (V + 1); `neighbours` `u32` |
//!
//! # What is validated
//! Of the file: the head as above, that sections lie one after the other inside the file, and all checksums, so a byte
//! that is lost or changed by accident is found. A checksum does not stop who means harm, so
//! [`File::mesh`] looks at the columns as if anything could be in them
//! ([`Columns::validate`](crate::columns::Columns::validate)):
//! - Lengths are those of the counts; every number of an element is below the number of them.
//! - Stored `target`, `next`, `prev` and `face` are what the faces say; three vertices of a face are different, where the
//!   structure refuses degenerate faces.
//! - Opposites come in pairs that run along one edge in opposite directions. (Mates share the edge; the sides of a winged
//!   edge are next and previous to one another, three to a face.)
//! - Records are whole, of one irregular edge or vertex each, ascending, and named by just their members.
//! - The fans that `outgoing` and the vertex records begin are all there are, each once, of that vertex, an open one
//!   from its clockwise end: every half-edge is walked over once.
//! - No two edges join the same vertices, so that what has no opposite has none to be paired with.
//! - Edge list, edge index, boundary curves and lists of neighbours are those of that mesh; lists of the vertex graph
//!   ascend and are symmetric.
//!
//! So a mesh from a file obeys the laws of `conformance` over its own faces. It may differ from what building gives in what
//! the laws leave open: a closed fan of the only one of a vertex may start at any of its half-edges, a winged
//! edge may be listed anywhere and with either side first. Not checked are coordinates, which may be infinite or NaN.
//!
//! O(bytes) for the file and O(elements) for the mesh, with 4 bytes a vertex of scratch; `che-l1`, which has no start
//! for a vertex, is paired again and compared.
mod any;
mod bytes;
mod file;
mod head;
mod problem;
mod write;

pub use any::{build, faces, triangles};
pub use file::File;
pub use head::VERSION;
pub use write::{save, write};

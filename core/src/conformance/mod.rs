//! The laws that every backend obeys, and a corpus of meshes with hand-counted elements to try them on.
//!
//! For the tests of a backend, with the feature `conformance`. Each law is a generic function that panics where
//! it is broken, one for each trait. What it expects is a hand count of the [`Case`], or what a slow search
//! over all half-edges finds, never what another backend says.
//!
//! ```
//! use onering_core::{FromFaces, conformance as laws};
//! # use onering_core::{BuildError, Pairing, Topology, VertexId, HalfEdgeId, FaceId, Handle, pairing};
//! # use std::borrow::Cow;
//! # #[derive(Clone)] struct Soup(usize, Vec<[u32; 3]>);
//! # impl Topology for Soup {
//! #     type Vertex = VertexId;
//! #     type HalfEdge = HalfEdgeId;
//! #     type Face = FaceId;
//! #     fn vertex_count(&self) -> usize { self.0 }
//! #     fn face_count(&self) -> usize { self.1.len() }
//! #     fn origin(&self, h: HalfEdgeId) -> VertexId {
//! #         VertexId::new(self.1.as_flattened()[h.index()] as usize)
//! #     }
//! # }
//! # impl FromFaces for Soup {
//! #     fn build(n: usize, faces: Cow<'_, [[u32; 3]]>, _: Pairing) -> Result<Self, BuildError> {
//! #         pairing::check_counts(n, faces.len(), u32::MAX as usize - 1)?;
//! #         pairing::check_vertices(n, &faces)?;
//! #         Ok(Soup(n, faces.into_owned()))
//! #     }
//! # }
//! use laws::Flaw::{Degenerate, NonManifoldEdge, SameDirection, SeveralFans};
//! let holds = [Degenerate, NonManifoldEdge, SameDirection, SeveralFans];
//! for case in laws::corpus() {
//!     // Accepted or refused, exactly as `holds` says.
//!     if let Some(mesh) = laws::build::<Soup>(&case, &holds) {
//!         laws::topology(&case, &mesh);
//!         laws::topology(&case, &&mesh);
//!         laws::from_faces(&case, &mesh);
//!     }
//! }
//! ```
mod case;
mod corpus;
mod laws;
mod slow;

pub use case::{Case, Flaw, build};
pub use corpus::{corpus, torus};
pub use laws::{adjacency, boundaries, edge_map, footprint, from_faces, graph, incidence, topology};

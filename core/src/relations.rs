//! The nine relations between vertices, edges and faces (Woo 1985; Emme 2012, section 2.2), of which TopTri
//! (Figueiredo et al. 2014, Tables 1 and 2) has six as queries.
//!
//! | relation | function | in TopTri | trait | steps |
//! |---|---|---|---|---|
//! | V -> V | [`vertex_vertices`] | `vGetAdjacentVertices` | [`Neighbours`](crate::neighbours::Neighbours) | d + 1, and 4 d where fans are several |
//! | V -> E | [`vertex_edges`] | `vGetIncidentEdges` | [`Incidence`](crate::Incidence) | 3 d |
//! | V -> F | [`vertex_faces`] | `vGetIncidentFaces` | [`Incidence`](crate::Incidence) | d |
//! | E -> V | [`edge_vertices`] | (the name of an edge) | [`Topology`](crate::Topology) | 2 |
//! | E -> E | [`edge_edges`] | `eGetAdjacentEdges` | [`Incidence`](crate::Incidence) | 3 (d + d') |
//! | E -> F | [`edge_faces`] | `eGetIncidentFaces` | [`Adjacency`](crate::Adjacency) | k |
//! | F -> V | [`face_vertices`] | (the name of a face) | [`Topology`](crate::Topology) | 3 |
//! | F -> E | [`face_edges`] | - | [`Adjacency`](crate::Adjacency) | 3 |
//! | F -> F | [`face_faces`] | `fGetAdjacentFaces` | [`Adjacency`](crate::Adjacency) | k + k' + k'' |
//!
//! A step reads what lies across a half-edge, or in its face; d is the number of faces at a vertex, k of those along an
//! edge. Nothing is allocated. A step is O(1) but on [`Searched`](crate::Searched), where it is a search of all
//! faces. The bare vertex graph of TopTri answers its six queries itself, with cycles of three edges for faces.
//!
//! **An edge** is named by a half-edge along it, the least ([`edge`]), so that equal edges compare equal; any
//! half-edge along it may be asked about. On an [`EdgeMap`](crate::EdgeMap), `mesh.edge(h)` is its number.
//!
//! **Each result comes once**, and never what was asked about: an edge of three faces is one edge at its ends, a
//! vertex of several fans has the edges of all of them, and a face that shares two or three edges with another is one
//! neighbour of it. Order is that of the walk, and no caller may rely on it. At a boundary there is less to list,
//! at an isolated vertex nothing. A face that names a vertex twice, which `Searched` alone holds, counts by its
//! corners and sides: where faces are listed it may come once for each.
//!
//! **A sweep** over all vertices, edges or faces takes time linear in the mesh and the results together, whatever
//! the mesh, with two exceptions. E -> E takes d for each edge at a vertex, so where faces are many and edges few
//! (faces that are there many times over) it takes more than it lists: the sum of edges times faces over all vertices.
//! And F -> F looks three times at a face with the same three vertices that it lists once.
mod of_edge;
mod of_face;
mod of_vertex;

pub use of_edge::{edge, edge_edges, edge_faces, edge_vertices};
pub use of_face::{face_edges, face_faces, face_vertices};
pub use of_vertex::{vertex_edges, vertex_faces, vertex_vertices};

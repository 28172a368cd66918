//! What is particular to each hand-written backend. The laws that all backends obey are elsewhere.
mod adjacency_graph;
mod mate_face;
mod meshes;
#[path = "../common/random.rs"]
mod random;
mod vertex_graph;
mod winged_edge;

use onering::*;

#[test]
fn backends_are_printed_by_their_counts() {
    fn print<M: FromFaces + std::fmt::Debug>() -> String {
        format!("{:?}", M::from_faces(4, &meshes::TETRAHEDRON).unwrap())
    }
    assert_eq!(print::<MateFace>(), "MateFace { vertices: 4, faces: 4 }");
    assert_eq!(print::<HalfEdgeMesh>(), "HalfEdgeMesh { vertices: 4, faces: 4 }");
    assert_eq!(print::<WingedEdge>(), "WingedEdge { vertices: 4, edges: 6, faces: 4 }");
    assert_eq!(print::<VertexGraph>(), "VertexGraph { vertices: 4, edges: 6 }");
    assert_eq!(print::<AdjacencyGraph>(), "AdjacencyGraph { vertices: 4, faces: 4 }");
}

//! The nine relations between vertices, edges and faces, on a square whose diagonal has three faces:
//!
//! `cargo run --example nine_relations`
use onering::{BuildError, DirectedEdgesSmall, FromFaces, Handle, Incidence, relations};

/// Generic code asks for the trait that it needs, and names no structure.
fn around<M: Incidence>(mesh: &M, v: M::Vertex) {
    println!("around {v:?}");
    println!("  V -> V  {:?}", relations::vertex_vertices(mesh, v).collect::<Vec<_>>());
    // An edge is named by its least half-edge; its ends say more to people.
    let ends = |h| relations::edge_vertices(mesh, h);
    println!("  V -> E  {:?}", relations::vertex_edges(mesh, v).map(ends).collect::<Vec<_>>());
    println!("  V -> F  {:?}", relations::vertex_faces(mesh, v).collect::<Vec<_>>());
}

fn along<M: Incidence>(mesh: &M, h: M::HalfEdge) {
    println!("along {:?}, which is edge {:?}", h, relations::edge(mesh, h));
    println!("  E -> V  {:?}", relations::edge_vertices(mesh, h));
    println!("  E -> E  {:?}", relations::edge_edges(mesh, h).collect::<Vec<_>>());
    println!("  E -> F  {:?}", relations::edge_faces(mesh, h).collect::<Vec<_>>());
}

fn across<M: Incidence>(mesh: &M, f: M::Face) {
    println!("across the sides of {f:?}");
    println!("  F -> V  {:?}", relations::face_vertices(mesh, f));
    println!("  F -> E  {:?}", relations::face_edges(mesh, f));
    println!("  F -> F  {:?}", relations::face_faces(mesh, f).collect::<Vec<_>>());
}

fn main() -> Result<(), BuildError> {
    let mesh = DirectedEdgesSmall::from_faces(5, &[[0, 1, 2], [0, 2, 3], [2, 0, 4]])?;
    around(&mesh, Handle::new(0));
    along(&mesh, Handle::new(3)); // from 0 to 2, in the second face
    across(&mesh, Handle::new(1));
    Ok(())
}

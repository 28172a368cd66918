//! The same program on the structure that the cargo features pick:
//!
//! `cargo run --example pick_a_backend --features che-l3`
//! `cargo run --example pick_a_backend --features directed-edges-small,edge-map`
//! `cargo run --example pick_a_backend --features mate-face`
use onering::footprint::Footprint;
use onering::{Adjacency, BuildError, FromFaces, Mesh, Topology, WithOpposites};

/// Generic code asks for the trait that it needs, and names no structure.
fn boundary_length(mesh: &impl Adjacency) -> usize {
    mesh.half_edges().filter(|&h| mesh.is_boundary(h)).count()
}

fn main() -> Result<(), BuildError> {
    // A square of two triangles, and a third that folds up from its diagonal where the structure holds that.
    let square = [[0, 1, 2], [0, 2, 3]];
    let folded = [[0, 1, 2], [0, 2, 3], [2, 0, 4]];
    let mesh = match Mesh::from_faces(5, &folded) {
        Ok(mesh) => mesh,
        Err(error) => {
            println!("not this one: {error}");
            Mesh::from_faces(4, &square)?
        }
    };
    println!("{mesh:?} in {} bytes: {}", mesh.heap_bytes(), Mesh::BYTES);

    // What the structure lacks, an adaptor adds, at a cost that can be seen here.
    match WithOpposites::new(&mesh) {
        Ok(mesh) => {
            println!("{} of {} half-edges on the boundary", boundary_length(&mesh), mesh.half_edge_count())
        }
        Err(error) => println!("no table of opposites: {error}"),
    }
    Ok(())
}

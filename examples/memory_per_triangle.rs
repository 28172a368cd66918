//! What each data structure takes in memory: by its formula, and on a mesh.
//!
//! `cargo run --release --example memory_per_triangle`
use onering::footprint::Footprint;
use onering::registry::BACKENDS;
use onering::{BuildError, FromFaces};

/// An open grid of squares, two triangles each.
fn grid(columns: u32, rows: u32) -> (usize, Vec<[u32; 3]>) {
    let v = |c, r| r * (columns + 1) + c;
    let square = |c, r| [[v(c, r), v(c + 1, r), v(c + 1, r + 1)], [v(c, r), v(c + 1, r + 1), v(c, r + 1)]];
    let faces = (0..rows).flat_map(|r| (0..columns).flat_map(move |c| square(c, r))).collect();
    ((columns + 1) as usize * (rows + 1) as usize, faces)
}

fn measured<M: FromFaces + Footprint>(vertex_count: usize, faces: &[[u32; 3]]) -> Result<f64, BuildError> {
    Ok(M::from_faces(vertex_count, faces)?.heap_bytes() as f64 / faces.len() as f64)
}

type Measure = fn(usize, &[[u32; 3]]) -> Result<f64, BuildError>;

macro_rules! all {
    ($($name:ident $text:literal $mesh:ty [$($has:ident)*] [$($holds:ident)*];)+) => {
        const MEASURES: &[Measure] = &[$(measured::<$mesh>),+];
    };
}
onering::with_backends!(all);

fn main() -> Result<(), BuildError> {
    let (vertex_count, faces) = grid(300, 200);
    println!(
        "bytes a triangle: on a closed mesh by the formula, and on an open grid of {} triangles\n",
        faces.len()
    );
    for (backend, measure) in BACKENDS.iter().zip(MEASURES) {
        let on_grid = measure(vertex_count, &faces)?;
        println!("{:22} {:3}  {on_grid:6.2}   {}", backend.name, backend.bytes.per_triangle(), backend.bytes);
    }
    Ok(())
}

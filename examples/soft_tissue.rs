//! A ball of soft tissue, held from below and pressed from above: where it comes to rest, on three structures.
//!
//! `cargo run --release --example soft_tissue`
use onering::nearest::nearest_vertex;
use onering::spring::{Options, Simulation, Stiffness};
use onering::{CheL2, DirectedEdgesSmall, FromFaces, Incidence, Map, MateFace, vector};
use std::{error::Error, f32::consts::PI};

/// A unit sphere of rings from pole to pole.
fn sphere(columns: u32, rows: u32) -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let mut positions = vec![[0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
    let v = |c: u32, r: u32| match r {
        0 => 0,
        r if r == rows => 1,
        r => 2 + (r - 1) * columns + c % columns,
    };
    let mut faces = Vec::new();
    for (r, c) in (0..rows).flat_map(|r| (0..columns).map(move |c| (r, c))) {
        let [a, b, d, e] = [v(c, r), v(c + 1, r), v(c, r + 1), v(c + 1, r + 1)];
        if r + 1 < rows {
            let (height, turn) = (PI * (r + 1) as f32 / rows as f32, 2.0 * PI * c as f32 / columns as f32);
            positions.push([height.sin() * turn.cos(), height.sin() * turn.sin(), height.cos()]);
            faces.push([a, d, e]);
        }
        if r > 0 {
            faces.push([a, e, b]);
        }
    }
    (positions, faces)
}

fn press<M: Incidence + FromFaces>(
    name: &str,
    positions: &[[f32; 3]],
    faces: &[[u32; 3]],
) -> Result<(), Box<dyn Error>> {
    let mesh = M::from_faces(positions.len(), faces)?;
    let positions: Map<M::Vertex, _> = positions.to_vec().into();
    let fixed = mesh.vertices().filter(|&v| positions[v][2] < -0.5).collect();
    let options = Options { fixed, stiffness: Stiffness::OverLength(1.0), ..Options::default() };
    let mut ball = Simulation::new(&mesh, &positions, &options)?;
    let touched = nearest_vertex(&positions, [0.3, 0.0, 1.2]).ok_or("no vertex")?;
    ball.push(touched, [0.0, 0.0, -1.0], 4)?;
    let solved = ball.solve(1e-8, 10_000)?;
    let largest = ball.displacements().iter().map(|(_, &d)| vector::length(d)).fold(0.0, f64::max);
    println!(
        "{name:22} {} iterations, {touched:?} pressed, largest displacement {largest:.6}",
        solved.iterations
    );
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let (positions, faces) = sphere(48, 32);
    press::<CheL2>("che-l2", &positions, &faces)?;
    press::<DirectedEdgesSmall>("directed-edges-small", &positions, &faces)?;
    press::<MateFace>("mate-face", &positions, &faces)
}

//! The stalactites of a cave, and contours of its roof: the applications of Figueiredo et al. (2014), section 6.
//!
//! `cargo run --release --example cave`, or with a file of triangles, z up, whose faces are seen from inside.
use onering::{DirectedEdgesSmall, FromFaces, Map, contours, critical, region};
use std::error::Error;

/// A wavy roof with six cones that hang from it, faces seen from below.
fn roof() -> (Vec<[f32; 3]>, Vec<[u32; 3]>) {
    let (side, row) = (160, 161);
    let corner = |i: u32| {
        let [x, y] = [i % row, i / row].map(|k| k as f32 / side as f32 * 4.0);
        let cones = (0..6u8).map(|k| {
            let [cx, cy] = [0.7 + 1.3 * f32::from(k % 3), 1.0 + 2.0 * f32::from(k / 3)];
            (4.0 * (x - cx).hypot(y - cy) - 0.4 - 0.1 * f32::from(k)).min(0.0)
        });
        [x, y, 3.0 + 0.1 * (1.5 * x).sin() * (1.1 * y).cos() + cones.sum::<f32>()]
    };
    let cell = |i: u32| {
        let a = i / side * row + i % side;
        [[a, a + row + 1, a + 1], [a, a + row, a + row + 1]]
    };
    ((0..row * row).map(corner).collect(), (0..side * side).flat_map(cell).collect())
}

fn main() -> Result<(), Box<dyn Error>> {
    let (corners, faces) = match std::env::args().nth(1) {
        Some(path) => onering_io::load(path).map(|mesh| (mesh.positions, mesh.faces))?,
        None => roof(),
    };
    let mesh = DirectedEdgesSmall::from_faces(corners.len(), &faces)?;
    let positions = Map::from(corners);

    let tips = critical::stalactite_tips(&mesh, &positions)?;
    println!("{} triangles, {} tips", faces.len(), tips.len());
    if let Some(&tip) = tips.first() {
        let found = region::stalactite(&mesh, &positions, tip, region::StalactiteOptions::default())?;
        let [min, max] = found.bounding_box(&positions);
        let size = [0, 1, 2].map(|i| max[i] - min[i]);
        println!(
            "the first, {tip:?}: {} triangles, area {:.3}",
            found.faces().len(),
            found.area(&mesh, &positions)
        );
        println!("  box {:.3} x {:.3} x {:.3} at {min:.3?}", size[0], size[1], size[2]);
    }

    let height: Map<_, f32> = positions.as_slice().iter().map(|p| p[2]).collect();
    let [low, high] = height.as_slice().iter().fold([f32::MAX, f32::MIN], |[a, b], &z| [a.min(z), b.max(z)]);
    let levels = contours::levels((high - low) / 10.0, low, high);
    let lines = contours::contours(&mesh, &height, &levels)?;
    println!("height  lines  closed  length");
    for level in levels {
        let at: Vec<_> = lines.lines().filter(|line| line.level == level).collect();
        let closed = at.iter().filter(|line| line.is_closed).count();
        let length: f64 = at.iter().map(|line| line.length(&mesh, &positions)).sum();
        println!("{level:6.2} {:6} {closed:7} {length:7.3}", at.len());
    }
    Ok(())
}

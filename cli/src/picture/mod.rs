//! Pictures of meshes: a small renderer in software, as a picture in a report needs no graphics card.
//!
//! Triangles are filled into a depth buffer of nine samples a pixel ([`raster`]), which keeps the face that is seen;
//! only what is seen is shaded ([`shade`]), and the samples of a pixel are averaged in linear light.

mod camera;
mod normals;
mod png;
mod raster;
mod shade;

pub(crate) use camera::Axes;
pub(crate) use png::write;

use camera::Camera;
use onering_io::colour::{Rgb, srgb_of_linear};
use raster::Samples;
use shade::{Linear, Shading};

/// Samples along each side of a pixel.
const SIDE: usize = 3;

/// Pixels between two surfaces side by side.
const GAP: usize = 2;

/// A mesh to be drawn. All positions are finite, all corners in range.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Surface<'a> {
    pub(crate) positions: &'a [[f32; 3]],
    pub(crate) faces: &'a [[u32; 3]],
    /// What to tint it by, 0 (not at all) to 1, for each vertex.
    pub(crate) shares: Option<&'a [f32]>,
}

/// Pixels, row after row from the top.
#[derive(Clone, Debug)]
pub(crate) struct Picture {
    pub(crate) width: usize,
    pub(crate) height: usize,
    pub(crate) pixels: Vec<Rgb>,
}

/// The surfaces beside each other, seen by the same camera, so that what differs in the picture differs in space.
/// O(vertices + faces + samples covered).
pub(crate) fn side_by_side(surfaces: &[Surface<'_>], axes: &Axes, width: usize) -> Picture {
    let each = (width - GAP * (surfaces.len() - 1)) / surfaces.len();
    let points = || surfaces.iter().flat_map(|surface| surface.positions);
    let camera = Camera::fitted(*axes, points, each);
    let panels: Vec<Picture> = surfaces.iter().map(|surface| panel(surface, &camera)).collect();
    let rule = [[255; 3]; GAP];
    let row = |y: usize| {
        let rows = panels.iter().map(move |panel| &panel.pixels[y * each..][..each]);
        rows.collect::<Vec<_>>().join(&rule[..])
    };
    let pixels: Vec<Rgb> = (0..camera.height).flat_map(row).collect();
    Picture { width: pixels.len() / camera.height, height: camera.height, pixels }
}

fn panel(surface: &Surface<'_>, camera: &Camera) -> Picture {
    // In samples, from the middle of the picture, y up: near zero `f32` is finest.
    let seen: Vec<[f32; 3]> = surface.positions.iter().map(|&p| camera.see(p, SIDE as f64)).collect();
    let mut samples = Samples::new(SIDE * camera.width, SIDE * camera.height);
    for (f, &face) in surface.faces.iter().enumerate() {
        samples.fill(f as u32, face.map(|v| seen[v as usize]));
    }
    let normals = normals::of(&seen, surface.faces);
    let shading = Shading::new(surface, &seen, &normals);
    let pixels = (0..camera.width * camera.height).map(|i| {
        let [x, y] = [i % camera.width, i / camera.width];
        encoded(pixel(&samples, &shading, x, y, shade::background(y as f32 / camera.height as f32)))
    });
    Picture { width: camera.width, height: camera.height, pixels: pixels.collect() }
}

/// The mean of its samples.
fn pixel(samples: &Samples, shading: &Shading<'_>, x: usize, y: usize, background: Linear) -> Linear {
    let mut sum = [0.0; 3];
    for i in 0..SIDE * SIDE {
        let [x, y] = [SIDE * x + i % SIDE, SIDE * y + i / SIDE];
        let colour = samples.face(x, y).map_or(background, |f| shading.colour(f, samples.centre(x, y)));
        (0..3).for_each(|c| sum[c] += colour[c] / (SIDE * SIDE) as f32);
    }
    sum
}

fn encoded(linear: Linear) -> Rgb {
    linear.map(|channel| (srgb_of_linear(f64::from(channel.clamp(0.0, 1.0))) * 255.0).round() as u8)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From the front.
    fn front() -> Axes {
        Axes::looking_from([0.0, 0.0, 1.0], [0.0, 1.0, 0.0]).unwrap()
    }

    #[test]
    fn a_square_fills_its_share_of_two_panels() {
        let positions = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0], [-1.0, 1.0, 0.0]];
        let surface = Surface { positions: &positions, faces: &[[0, 1, 2], [0, 2, 3]], shares: None };
        let picture = side_by_side(&[surface; 2], &front(), 202);
        assert_eq!((picture.width, picture.height, picture.pixels.len()), (202, 100, 20_200));
        let middle = |panel: usize| picture.pixels[50 * 202 + panel * 102 + 50];
        let corner = picture.pixels[0];
        assert_eq!(middle(0), middle(1));
        assert!(corner.iter().all(|&c| c > 225) && middle(0)[2] < 200, "{corner:?} {:?}", middle(0));
        let covered = picture.pixels.iter().filter(|pixel| **pixel == middle(0)).count() as f64;
        let side = 100.0 * (1.0 - 2.0 * camera::MARGIN);
        assert!((covered / (2.0 * side * side) - 1.0).abs() < 0.05, "{covered}");
    }

    #[test]
    fn both_sides_of_a_face_are_lit_alike() {
        let positions = [[-1.0, -1.0, 0.0], [1.0, -1.0, 0.0], [1.0, 1.0, 0.0]];
        let of = |face: [u32; 3]| {
            let faces = [face];
            let surface = Surface { positions: &positions, faces: &faces, shares: None };
            side_by_side(&[surface], &front(), 64).pixels
        };
        assert_eq!(of([0, 1, 2]), of([0, 2, 1]));
    }

    #[test]
    fn nothing_and_a_point_are_drawn_as_background() {
        for positions in [&[][..], &[[1e38, 2.0, 3.0]]] {
            let surface = Surface { positions, faces: &[], shares: None };
            let picture = side_by_side(&[surface], &front(), 40);
            assert!(picture.pixels.iter().flatten().all(|&channel| channel > 200));
        }
    }
}

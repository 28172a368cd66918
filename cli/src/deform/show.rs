//! The picture of a press: before and after.

use super::press::Pressed;
use crate::args;
use crate::failure::Failure;
use crate::picture::{self, Axes, Surface};
use onering::vector::{self, Vector};
use onering_io::{Replacement, Triangles};

/// How far the camera stands beside the normal, and above it: so that a dent is seen from its rim.
const BESIDE: f64 = 0.55;
const ABOVE: f64 = 0.25;

/// From where to look, at what is pressed where the normal is.
///
/// # Errors
/// Where --view and --up are parallel.
pub(crate) fn axes(options: &args::Deform, normal: Option<Vector>) -> Result<Axes, Failure> {
    let up = options.up;
    if let Some(view) = options.view {
        let parallel = || Failure::Usage("--view is parallel to --up: say another --up".into());
        return Axes::looking_from(view, up).ok_or_else(parallel);
    }
    let normal = normal.unwrap_or([0.0, 0.0, 1.0]);
    let length = vector::length(up);
    let above = vector::plus(normal, vector::times(ABOVE / length, up));
    let beside = vector::direction(vector::cross(up, normal)).unwrap_or([0.0; 3]);
    let view = vector::plus(above, vector::times(BESIDE, beside));
    let around = [[0.0, 0.0, 1.0], [1.0, 0.0, 0.0]];
    let axes = Axes::looking_from(view, up);
    // A normal that is up leaves the choice of what is up in the picture.
    let axes = axes.or_else(|| around.into_iter().find_map(|up| Axes::looking_from(view, up)));
    axes.ok_or_else(|| Failure::Usage("--view is needed here: the surface has no direction".into()))
}

/// Draws the mesh before and after.
pub(crate) fn draw(
    options: &args::Deform,
    mesh: &Triangles,
    pressed: &Pressed,
    axes: &Axes,
    file: Replacement,
    name: &str,
) -> Result<(), Failure> {
    let largest = pressed.largest().max(f64::MIN_POSITIVE);
    let shares: Vec<f32> =
        pressed.displacements.iter().map(|&d| (vector::length(d) / largest) as f32).collect();
    let before = Surface { positions: &mesh.positions, faces: &mesh.faces, shares: None };
    let after = Surface { positions: &pressed.positions, faces: &mesh.faces, shares: Some(&shares) };
    let picture = picture::side_by_side(&[before, after], axes, usize::from(options.width));
    picture::write(&picture, name, file)
}

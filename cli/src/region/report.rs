//! What is said of a region.

use super::Found;
use crate::surface::Surface;
use onering_io::one_line;
use serde::Serialize;

/// The figures, under the names that JSON has.
#[derive(Debug, Serialize)]
pub(super) struct Report<'a> {
    file: &'a str,
    backend: &'a str,
    up: String,
    unit: &'a str,
    /// The vertex that it was grown from.
    at: usize,
    triangles: usize,
    vertices: usize,
    area: f64,
    bbox_min: [f32; 3],
    bbox_max: [f32; 3],
    /// Of the box, along x, y and z.
    size: [f32; 3],
    seconds: f64,
}

impl<'a> Report<'a> {
    pub(super) fn new(backend: &'a str, surface: &'a Surface, found: &Found) -> Self {
        let [bbox_min, bbox_max] = found.bounds;
        let side = |i: usize| (f64::from(bbox_max[i]) - f64::from(bbox_min[i])) as f32;
        Self {
            file: &surface.name,
            backend,
            up: surface.up.to_string(),
            unit: &surface.unit,
            at: found.seed,
            triangles: found.part.faces.len(),
            vertices: found.part.positions.len(),
            area: found.area,
            bbox_min,
            bbox_max,
            size: [0, 1, 2].map(side),
            seconds: found.seconds,
        }
    }

    /// One line.
    pub(super) fn json(&self) -> String {
        serde_json::to_string(self).expect("names and numbers are JSON") + "\n"
    }

    /// A figure a line.
    pub(super) fn text(&self) -> String {
        let Self { up, at, triangles, vertices, area, bbox_min, bbox_max, size, .. } = self;
        let unit = if self.unit.is_empty() { String::new() } else { format!(" {}", self.unit) };
        let square = if self.unit.is_empty() { "" } else { "\u{b2}" };
        let point = |[x, y, z]: &[f32; 3]| format!("{x} {y} {z}");
        let [width, depth, height] = size;
        format!(
            "{}: the region at vertex {at}, up is {up}\n  \
             triangles  {triangles}\n  \
             vertices   {vertices}\n  \
             area       {area}{unit}{square}\n  \
             size       {width} x {depth} x {height}{unit}\n  \
             bbox_min   {}\n  \
             bbox_max   {}\n",
            one_line(self.file),
            point(bbox_min),
            point(bbox_max),
        )
    }
}

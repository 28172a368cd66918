//! What is said of minima, maxima and saddles.

use super::{Extrema, Extremum};
use crate::args;
use crate::surface::Surface;
use onering_io::one_line;
use serde::Serialize;
use std::fmt::Write;

/// The figures, under the names that JSON has. Kinds that were not looked for are not there.
#[derive(Debug, Serialize)]
pub(super) struct Report<'a> {
    file: &'a str,
    backend: &'a str,
    vertices: usize,
    triangles: usize,
    up: String,
    field: &'a str,
    unit: &'a str,
    #[serde(skip_serializing_if = "Option::is_none")]
    minima: Option<&'a [Extremum]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    stalactites: Option<&'a [Extremum]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    maxima: Option<&'a [Extremum]>,
    #[serde(skip_serializing_if = "Option::is_none")]
    saddles: Option<&'a [Extremum]>,
    seconds: f64,
}

impl<'a> Report<'a> {
    pub(super) fn new(
        options: &'a args::Minima,
        surface: &'a Surface,
        extrema: &'a Extrema,
        seconds: f64,
    ) -> Self {
        let Extrema { minima, maxima, saddles } = extrema;
        Self {
            file: &surface.name,
            backend: &options.mesh.backend,
            vertices: surface.mesh.positions.len(),
            triangles: surface.mesh.faces.len(),
            up: surface.up.to_string(),
            field: surface.field_name(),
            unit: &surface.unit,
            minima: (!options.stalactites).then_some(minima),
            stalactites: options.stalactites.then_some(minima),
            maxima: options.maxima.then_some(maxima),
            saddles: options.saddles.then_some(saddles),
            seconds,
        }
    }

    /// One line.
    pub(super) fn json(&self) -> String {
        serde_json::to_string(self).expect("names and numbers are JSON") + "\n"
    }

    /// A vertex a line, kind after kind.
    pub(super) fn text(&self) -> String {
        let Self { file, triangles, up, field, .. } = self;
        let mut text = format!("{}: {field} of {triangles} triangles, up is {up}\n", one_line(file));
        let kinds = [
            ("stalactites", self.stalactites),
            ("minima", self.minima),
            ("maxima", self.maxima),
            ("saddles", self.saddles),
        ];
        for (kind, found) in kinds.iter().filter_map(|(kind, found)| Some((kind, (*found)?))) {
            let _ = writeln!(text, "{} {kind}", found.len());
            for Extremum { vertex, position: [x, y, z], value, multiplicity } in found {
                let times =
                    multiplicity.filter(|times| *times > 1).map_or(String::new(), |n| format!("  x {n}"));
                let _ = writeln!(text, "{vertex:>10}  {field} {value:<14} at {x} {y} {z}{times}");
            }
        }
        text
    }
}

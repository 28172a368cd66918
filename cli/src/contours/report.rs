//! What is said of contours.

use super::trace::{Figures, Traced};
use crate::level::Levels;
use crate::minima::{Extrema, Extremum};
use crate::surface::Surface;
use onering_io::one_line;
use serde::Serialize;
use std::fmt::Write;

/// The figures, under the names that JSON has.
#[derive(Debug, Serialize)]
pub(crate) struct Report<'a> {
    file: &'a str,
    backend: &'a str,
    vertices: usize,
    triangles: usize,
    up: String,
    field: &'a str,
    unit: &'a str,
    /// The least and the largest value; `null` without faces.
    range: Option<[f32; 2]>,
    step: Option<f64>,
    levels: Vec<Row>,
    closed: usize,
    open: usize,
    length: f64,
    #[serde(skip_serializing_if = "<[Extremum]>::is_empty")]
    minima: &'a [Extremum],
    seconds: f64,
}

#[derive(Debug, Serialize)]
struct Row {
    level: f32,
    closed: usize,
    open: usize,
    length: f64,
}

impl<'a> Report<'a> {
    pub(crate) fn new(
        backend: &'a str,
        surface: &'a Surface,
        levels: &Levels,
        traced: &Traced,
        extrema: &'a Extrema,
    ) -> Self {
        let row = |(level, figures): (f32, &Figures)| {
            let &Figures { closed, open, length } = figures;
            Row { level, closed, open, length }
        };
        Self {
            file: &surface.name,
            backend,
            vertices: surface.mesh.positions.len(),
            triangles: surface.mesh.faces.len(),
            up: surface.up.to_string(),
            field: surface.field_name(),
            unit: &surface.unit,
            range: surface.range(),
            step: levels.step,
            levels: levels.heights().into_iter().zip(&traced.figures).map(row).collect(),
            closed: traced.figures.iter().map(|figures| figures.closed).sum(),
            open: traced.figures.iter().map(|figures| figures.open).sum(),
            length: traced.figures.iter().map(|figures| figures.length).sum(),
            minima: &extrema.minima,
            seconds: traced.seconds,
        }
    }

    /// One line.
    pub(crate) fn json(&self) -> String {
        serde_json::to_string(self).expect("names and numbers are JSON") + "\n"
    }

    /// A level a line.
    pub(crate) fn text(&self, surface: &Surface) -> String {
        let unit = surface.with_unit("");
        let mut text = format!(
            "{}: {} of {} triangles, up is {}\n",
            one_line(self.file),
            self.field,
            self.triangles,
            self.up
        );
        match self.range {
            Some([least, most]) => {
                let _ = writeln!(text, "from {least} to {most}{unit}, {} levels", self.levels.len());
            }
            None => text += "no faces, and so no levels\n",
        }
        if !self.levels.is_empty() {
            let _ = writeln!(text, "{:>16}{:>10}{:>10}{:>16}", "level", "closed", "open", "length");
        }
        for Row { level, closed, open, length } in &self.levels {
            let _ = writeln!(text, "{level:>16}{closed:>10}{open:>10}{length:>16.6}");
        }
        let Self { closed, open, length, .. } = self;
        let _ = writeln!(text, "{:>16}{closed:>10}{open:>10}{length:>16.6}", "all");
        if !self.minima.is_empty() {
            let _ = writeln!(text, "{} minima", self.minima.len());
        }
        text
    }
}

//! A line for each structure, its name at its end.

use super::axis::Axis;
use super::figure::{Frame, Tone, mark, write};
use super::labels;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

pub(super) struct Line<'a> {
    pub(super) name: &'a str,
    /// Which colour and mark it has: the same in all plots.
    pub(super) place: usize,
    /// By rising x.
    pub(super) points: Vec<(f64, f64)>,
}

/// Names of axes, the axis below, and the lines.
pub(super) fn draw(id: &str, words: [&str; 4], x: Axis, lines: &[Line<'_>]) -> String {
    let [title, description, below, beside] = words;
    let values = lines.iter().flat_map(|line| line.points.iter().map(|point| point.1));
    let frame = Frame {
        id,
        title,
        description,
        x: (x, below),
        y: (Axis::around(values), beside),
        height: 470,
        top: 8,
        sides: [64, 190],
    };
    frame.draw(|chart, root| {
        let (across, up) = chart.plotting_area().get_pixel_range();
        let place = |point: &(f64, f64)| chart.backend_coord(point);
        let ends: Vec<(i32, i32)> = lines.iter().filter_map(|line| line.points.last()).map(place).collect();
        let wished: Vec<f64> = ends.iter().map(|end| f64::from(end.1)).collect();
        let heights = labels::apart(&wished, f64::from(up.start), f64::from(up.end));
        let known = lines.iter().filter(|line| !line.points.is_empty());
        for ((line, end), height) in known.zip(ends).zip(heights) {
            let (colour, y) = (Tone::of(line.place).rgb(), height.round() as i32);
            let pixels: Vec<(i32, i32)> = line.points.iter().map(place).collect();
            root.draw(&PathElement::new(pixels.clone(), colour.stroke_width(2)))?;
            pixels.into_iter().try_for_each(|pixel| mark(root, line.place, pixel))?;
            let leader = [(end.0 + 7, end.1), (across.end + 8, y), (across.end + 18, y)];
            root.draw(&PathElement::new(leader, colour.mix(0.6)))?;
            write(root, line.name, (across.end + 22, y), HPos::Left)?;
        }
        Ok(())
    })
}

//! A row for each structure, and a mark for each figure of it.

use super::axis::Axis;
use super::figure::{Area, Drawn, Frame, Tone, mark, ring, write};
use crate::timing::Timing;
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

pub(super) struct Row<'a> {
    pub(super) name: &'a str,
    /// One for each of the figures; `None` where there is none.
    pub(super) values: Vec<Option<Timing>>,
}

const ROW: u32 = 24;

/// The first figure is a ring around whichever of the others it is the same as.
fn symbol(root: &Area<'_>, place: usize, at: (i32, i32)) -> Drawn {
    if place == 0 { ring(root, place, at) } else { mark(root, place, at) }
}

/// Names of the axis and its unit in nanoseconds, and what the marks are.
pub(super) fn draw(id: &str, words: [&str; 3], unit: f64, marks: &[String], rows: &[Row<'_>]) -> String {
    let [title, description, x] = words;
    let all = rows.iter().flat_map(|row| row.values.iter().flatten());
    let frame = Frame {
        id,
        title,
        description,
        x: (Axis::around(all.flat_map(|t| [t.min_ns / unit, t.median_ns / unit])), x),
        y: (Axis::Rows(rows.len().max(1)), ""),
        height: 100 + ROW * rows.len().max(1) as u32,
        top: 34,
        sides: [172, 16],
    };
    frame.draw(|chart, root| {
        let (across, up) = chart.plotting_area().get_pixel_range();
        for (row, y) in rows.iter().zip(0..) {
            let place = |ns: f64| chart.backend_coord(&(ns / unit, f64::from(y)));
            let middle = place(unit).1;
            write(root, row.name, (across.start - 10, middle), HPos::Right)?;
            for (i, timing) in row.values.iter().enumerate() {
                let Some(timing) = timing else { continue };
                let (low, _) = place(timing.min_ns);
                let high = place(timing.quartile_ns).0.min(across.end);
                let spread = [(low, middle), (high, middle)];
                root.draw(&PathElement::new(spread, Tone::of(i).rgb().mix(0.6)))?;
                symbol(root, i, place(timing.median_ns))?;
            }
        }
        legend(root, marks, (across.start, up.start - 14))
    })
}

/// The marks with their names in one line.
fn legend(root: &Area<'_>, marks: &[String], (left, y): (i32, i32)) -> Drawn {
    let mut x = left + 6;
    for (i, name) in marks.iter().enumerate() {
        symbol(root, i, (x, y))?;
        write(root, name, (x + 14, y), HPos::Left)?;
        x += 34 + super::labels::width(name) as i32;
    }
    Ok(())
}

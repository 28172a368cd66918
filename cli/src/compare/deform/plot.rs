//! The figure: time over vertices, both on logarithmic scales, as SVG.

use super::record::{Line, Point, Run};
use crate::timing::Timing;
use plotters::prelude::*;
use plotters::style::RGBColor;
use std::error::Error;

/// Pixels.
const SIZE: (u32, u32) = (900, 560);
/// How far the scale goes on to the right of the last size, for the legend to stand there.
const LEGEND: f64 = 8.0;
const FONT: &str = "sans-serif";

/// Black for the first; then those of Okabe and Ito (2008) that are dark enough for a line, and five between them.
const COLOURS: [[u8; 3]; 12] = [
    [0, 0, 0],
    [0, 114, 178],
    [86, 180, 233],
    [0, 60, 100],
    [0, 158, 115],
    [120, 190, 60],
    [0, 90, 60],
    [213, 94, 0],
    [204, 121, 167],
    [230, 159, 0],
    [128, 128, 128],
    [120, 60, 20],
];

/// Neighbours by a solid line, the total by a dashed one.
pub(crate) fn of(run: &Run) -> String {
    let mut svg = String::new();
    // A string takes all that is written to it.
    draw(run, &mut svg).expect("an SVG in memory cannot fail");
    svg
}

fn draw(run: &Run, svg: &mut String) -> Result<(), Box<dyn Error>> {
    let sizes: Vec<f64> = run.sizes.iter().map(|size| size.vertices as f64).collect();
    let times: Vec<f64> =
        run.lines.iter().flat_map(|line| line.points.iter().flatten()).flat_map(both).collect();
    let root = SVGBackend::with_string(svg, SIZE).into_drawing_area();
    root.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&root)
        .caption("Deformation of an organ: first rings (solid), total (dashed)", (FONT, 18))
        .margin(12)
        .x_label_area_size(45)
        .y_label_area_size(70)
        .build_cartesian_2d(around(&sizes, LEGEND).log_scale(), around(&times, 1.4).log_scale())?;
    chart
        .configure_mesh()
        .x_desc("vertices")
        .y_desc("milliseconds")
        .label_style((FONT, 13))
        .light_line_style(RGBColor(240, 240, 240))
        .x_label_formatter(&|x| format!("{x}"))
        .y_label_formatter(&|y| format!("{y}"))
        .draw()?;
    for (i, line) in run.lines.iter().enumerate() {
        let [r, g, b] = COLOURS[i % COLOURS.len()];
        let style = RGBColor(r, g, b).stroke_width(2);
        let solid = LineSeries::new(points(line, &sizes, |point| point.neighbours), style);
        chart
            .draw_series(solid)?
            .label(line.name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 22, y)], style));
        let total: Vec<_> = points(line, &sizes, |point| point.total).collect();
        chart.draw_series(DashedLineSeries::new(total, 6, 4, style))?;
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::MiddleRight)
        .label_font((FONT, 13))
        .background_style(WHITE.mix(0.85))
        .border_style(RGBColor(200, 200, 200))
        .draw()?;
    root.present()?;
    Ok(())
}

fn milliseconds(timing: Timing) -> f64 {
    timing.median_ns / 1e6
}

fn both(point: &Point) -> [f64; 2] {
    [point.neighbours, point.total].map(milliseconds)
}

fn points<'a>(
    line: &'a Line,
    sizes: &'a [f64],
    time: fn(&Point) -> Timing,
) -> impl Iterator<Item = (f64, f64)> + 'a {
    let known = sizes.iter().zip(&line.points).filter_map(|(&size, point)| Some((size, point.as_ref()?)));
    known.map(move |(size, point)| (size, milliseconds(time(point))))
}

/// A range with some room below, and as many times the largest value above.
fn around(values: &[f64], above: f64) -> std::ops::Range<f64> {
    let least = values.iter().copied().fold(f64::INFINITY, f64::min);
    let most = values.iter().copied().fold(0.0, f64::max);
    // Nothing was measured, or all of it in no time at all.
    if !(least > 0.0 && most > 0.0 && most.is_finite()) {
        return 1.0..10.0;
    }
    least * 0.8..most * above
}

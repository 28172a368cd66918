//! The figures as SVG: a line for each structure, a dot on it for each mesh, on a logarithmic scale.

use crate::record::{BUILD, FOUR_RING, PAIR, RING, Record, Row, Table};
use plotters::prelude::*;
use std::error::Error;
use std::path::Path;

type Outcome = Result<(), Box<dyn Error>>;

/// Pixels of a line, and of the figure beside the lines.
const LINE: u32 = 19;
const WIDTH: u32 = 940;
const NAMES: u32 = 190;
const LEGEND: u32 = 190;
/// Of a dot.
const RADIUS: i32 = 4;
const AROUND: u32 = 90;
const FONT: &str = "sans-serif";

/// Those of Okabe and Ito (2008) that are dark enough for a dot.
const COLOURS: [RGBColor; 6] = [
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(0, 0, 0),
];

/// What one figure shows of a structure on a mesh.
type Value = fn(&Table, &Row) -> Option<f64>;

/// Name of the file, title, and value.
const FIGURES: [(&str, &str, Value); 4] = [
    ("build", "Build, million triangles a second: further right is faster", |table, row| {
        task(table, row, BUILD)
    }),
    ("ring", "One-ring, nanoseconds: further left is faster", |table, row| task(table, row, RING)),
    ("four_ring", "4-ring of a random vertex, microseconds: further left is faster", |table, row| {
        task(table, row, FOUR_RING)
    }),
    ("peak", "Most memory during the build, bytes a triangle: further left is less", |table, row| {
        row.runs.last().map(|run| run.peak_bytes as f64 / table.triangles as f64)
    }),
];

fn task(table: &Table, row: &Row, task: &str) -> Option<f64> {
    row.median(task).map(|seconds| table.shown(task, seconds))
}

/// Every figure as a file of its own in the folder.
pub(crate) fn draw(record: &Record, folder: &Path) -> Outcome {
    for (name, title, value) in FIGURES {
        let names = structures(record, value);
        if !names.is_empty() {
            figure(record, &names, title, value, &folder.join(name).with_extension("svg"))?;
        }
    }
    Ok(())
}

/// All structures that have a value on some mesh, in the order of the tables.
fn structures(record: &Record, value: Value) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for table in &record.meshes {
        let shown = |row: &&Row| row.median(PAIR).is_none() && value(table, row).is_some();
        for row in table.rows.iter().filter(shown) {
            if !names.contains(&&*row.peer) {
                names.push(&row.peer);
            }
        }
    }
    names
}

fn figure(record: &Record, names: &[&str], title: &str, value: Value, file: &Path) -> Outcome {
    let shown = |table, name| Table::row(table, name).and_then(|row| value(table, row));
    let values =
        record.meshes.iter().flat_map(|table| names.iter().filter_map(move |name| shown(table, name)));
    let (least, most) = values.fold((f64::MAX, f64::MIN), |(a, b), x| (a.min(x), b.max(x)));
    let count = names.len();
    let root = SVGBackend::new(file, (WIDTH, count as u32 * LINE + AROUND)).into_drawing_area();
    root.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&root)
        .caption(title, (FONT, 16))
        .margin(8)
        .margin_right(LEGEND)
        .x_label_area_size(30)
        .y_label_area_size(NAMES)
        .build_cartesian_2d((least / 1.2..most * 1.2).log_scale(), (0..count).into_segmented())?;
    // The first structure is on top.
    let line = |i: usize| SegmentValue::CenterOf(count - 1 - i);
    let name = |line: &SegmentValue<usize>| match line {
        SegmentValue::CenterOf(i) if *i < count => names[count - 1 - i].into(),
        _ => String::new(),
    };
    chart
        .configure_mesh()
        .x_label_formatter(&|x| format!("{x}"))
        .y_labels(count)
        .y_label_formatter(&name)
        .label_style((FONT, 12))
        .light_line_style(RGBColor(240, 240, 240))
        .draw()?;
    for (table, style) in record.meshes.iter().zip(styles(record)) {
        let dot = |(i, name)| Some(Circle::new((shown(table, name)?, line(i)), RADIUS, style));
        chart
            .draw_series(names.iter().copied().enumerate().filter_map(dot))?
            .label(&*table.mesh)
            .legend(move |(x, y)| Circle::new((x + 12, y), RADIUS, style));
    }
    // Right of the plot, where the margin leaves room.
    let right = chart.plotting_area().dim_in_pixel().0 as i32 + 12;
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::Coordinate(right, 0))
        .label_font((FONT, 12))
        .draw()?;
    root.present()?;
    Ok(())
}

/// A colour for each mesh: full in the order that it was made in, a circle where it is shuffled.
fn styles(record: &Record) -> Vec<ShapeStyle> {
    let base = |table: &Table| table.mesh.trim_end_matches("-shuffled").to_owned();
    let mut bases = Vec::new();
    let mut colour = |name: String| {
        let at = bases.iter().position(|other| *other == name).unwrap_or_else(|| {
            bases.push(name);
            bases.len() - 1
        });
        COLOURS[at % COLOURS.len()]
    };
    let style = |table: &Table| {
        let is_shuffled = table.mesh.ends_with("-shuffled");
        let colour = colour(base(table));
        ShapeStyle { color: colour.to_rgba(), filled: !is_shuffled, stroke_width: 1 }
    };
    record.meshes.iter().map(style).collect()
}

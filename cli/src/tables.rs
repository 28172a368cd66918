//! Tables for people to read.

use crate::timing::Timing;
use comfy_table::{CellAlignment, LineStyle, Table, TableStyle};

/// A rule above, one under the header, one below.
const RULES: TableStyle = TableStyle::new()
    .top_border(LineStyle::none().fill('─').junction('─'))
    .header_separator(LineStyle::none().fill('─').junction('─'))
    .bottom_border(LineStyle::none().fill('─').junction('─'));

/// A table whose first `left` columns are words, the others numbers.
pub(crate) fn table(header: &[&str], left: usize) -> Table {
    let mut table = Table::new();
    table.load_style(RULES).set_header(header.to_vec());
    for column in table.column_iter_mut().skip(left) {
        column.set_cell_alignment(CellAlignment::Right);
    }
    table
}

/// The median in this unit, or that there is none.
pub(crate) fn scaled(timing: Option<Timing>, unit: f64) -> String {
    timing.map_or("-".into(), |timing| cell(timing.median_ns / unit, timing))
}

/// A figure that was worked out from `timing`, marked where that is no median.
pub(crate) fn cell(value: f64, timing: Timing) -> String {
    digits(value) + if timing.runs == 1 { "*" } else { "" }
}

/// Three digits that count.
pub(crate) fn digits(value: f64) -> String {
    let places = match value {
        v if v >= 99.95 => 0,
        v if v >= 9.995 => 1,
        v if v >= 0.9995 => 2,
        v if v >= 0.09995 => 3,
        _ => 4,
    };
    format!("{value:.places$}")
}

/// Lines of at most 110 characters.
pub(crate) fn wrapped(text: &str) -> String {
    let mut lines = vec![String::new()];
    for word in text.split_whitespace() {
        let last = lines.len() - 1;
        if !lines[last].is_empty() && lines[last].len() + 1 + word.len() > 110 {
            lines.push(format!("  {word}"));
        } else {
            let space = if lines[last].is_empty() { "" } else { " " };
            lines[last] += &format!("{space}{word}");
        }
    }
    lines.join("\n")
}

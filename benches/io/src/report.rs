//! Tables in Markdown, as docs/performance.md has them.

use crate::measure::Row;
use crate::shape::Shape;
use std::fmt::Write;

pub(crate) fn table(mesh: &Shape, rows: &[Row]) -> String {
    let mut text = format!("\n{} triangles, {} vertices\n\n", mesh.faces.len(), mesh.positions.len());
    text += "| format | file MB | what | ms, median | best | MB/s | of fs::read | peak MB |\n";
    text += "|---|---:|---|---:|---:|---:|---:|---:|\n";
    for row in rows {
        let read =
            rows.iter().find(|other| other.format == row.format && other.what == "read, std::fs::read");
        let ratio = read.map_or(0.0, |read| read.median_seconds / row.median_seconds);
        let megabytes = row.file_bytes as f64 / 1e6;
        let _ = writeln!(
            text,
            "| {} | {megabytes:.1} | {} | {:.1} | {:.1} | {:.0} | {ratio:.2} | {:.0} |",
            row.format,
            row.what,
            row.median_seconds * 1e3,
            row.best_seconds * 1e3,
            megabytes / row.median_seconds,
            row.peak_bytes as f64 / 1e6,
        );
    }
    text
}

//! Tables in Markdown, as docs/performance.md has them.

use crate::measure::{Medians, Outcome, Row};
use serde::Serialize;
use std::fmt::Write;

/// All structures on one mesh.
#[derive(Debug, Serialize)]
pub(crate) struct Table {
    pub(crate) mesh: &'static str,
    pub(crate) triangles: usize,
    pub(crate) vertices: usize,
    pub(crate) rows: Vec<Row>,
}

impl Table {
    /// Million triangles a second.
    fn build(&self, medians: &Medians) -> f64 {
        self.triangles as f64 / medians.build_seconds * 1e-6
    }

    /// Nanoseconds a vertex.
    fn ring(&self, medians: &Medians) -> Option<f64> {
        medians.sweep_seconds.map(|seconds| seconds * 1e9 / self.vertices as f64)
    }

    /// onering's backends that have rings.
    fn ours(&self) -> impl Iterator<Item = &Medians> {
        let ours = self.rows.iter().filter(|row| row.peer.starts_with("onering "));
        ours.filter_map(Row::medians).filter(|medians| medians.sweep_seconds.is_some())
    }

    /// The fastest of ours that has rings: who builds without them does less.
    fn best_build(&self) -> f64 {
        self.ours().map(|medians| self.build(medians)).fold(f64::NAN, f64::max)
    }

    fn best_ring(&self) -> f64 {
        self.ours().filter_map(|medians| self.ring(medians)).fold(f64::NAN, f64::min)
    }

    pub(crate) fn markdown(&self) -> String {
        let mut text =
            format!("\n{}: {} triangles, {} vertices\n\n", self.mesh, self.triangles, self.vertices);
        text +=
            "| structure | build, Mtri/s | of onering's best | ring, ns a vertex | onering's best of it | ";
        text += "live B/tri | peak B/tri |\n|---|---:|---:|---:|---:|---:|---:|\n";
        let (best_build, best_ring) = (self.best_build(), self.best_ring());
        for row in &self.rows {
            let _ = match &row.outcome {
                Outcome::Refused(reason) => writeln!(text, "| {} | - | | - | | | {reason} |", row.peer),
                Outcome::Medians(medians) => {
                    let build = self.build(medians);
                    let ring = self.ring(medians).map(|ring| (format!("{ring:.1}"), ratio(best_ring / ring)));
                    let (ring, of_ring) = ring.unwrap_or_default();
                    let [live, peak] = [medians.live_bytes, medians.peak_bytes]
                        .map(|bytes| bytes as f64 / self.triangles as f64);
                    let of_build = ratio(build / best_build);
                    let name = &row.peer;
                    writeln!(
                        text,
                        "| {name} | {build:.1} | {of_build} | {ring} | {of_ring} | {live:.0} | {peak:.0} |"
                    )
                }
            };
        }
        text
    }
}

/// Nothing where there is nothing of ours to compare with.
fn ratio(ratio: f64) -> String {
    if ratio.is_nan() { String::new() } else { format!("{ratio:.2}") }
}

//! Tables in Markdown, as docs/performance.md has them.

use crate::record::{BUILD, CHECK, COPY, FOUR_RING, LINKS, PAIR, RING, Record, Row, Table};
use std::fmt::Write;

/// All meshes, after the machine that they were measured on.
pub(crate) fn markdown(record: &Record) -> String {
    let tables: String = record.meshes.iter().map(table).collect();
    format!("{}\n{tables}", record.machine)
}

/// One mesh: all structures, then the phases of a build.
pub(crate) fn table(table: &Table) -> String {
    let mut text =
        format!("\n{}: {} triangles, {} vertices\n\n", table.mesh, table.triangles, table.vertices);
    text += "| structure | build, Mtri/s | of onering's best | ring, ns a vertex | onering's best of it | ";
    text += "4-ring, us | onering's best of it | live B/tri | peak B/tri | runs |\n";
    text += "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n";
    let best = [BUILD, RING, FOUR_RING].map(|task| table.best(task));
    for row in table.rows.iter().filter(|row| row.median(PAIR).is_none()) {
        text += &structure(table, row, best);
    }
    if table.rows.iter().any(|row| row.median(PAIR).is_some()) {
        text += "\n| ms | copy | check | pair | links out of vertices, fans | peak B/tri of pairing |\n";
        text += "|---|---:|---:|---:|---:|---:|\n";
    }
    for row in table.rows.iter().filter(|row| row.median(PAIR).is_some()) {
        let _ = write!(text, "| {} |", row.peer);
        for task in [COPY, CHECK, PAIR, LINKS] {
            text +=
                &row.median(task).map_or_else(|| " |".into(), |seconds| format!(" {:.2} |", seconds * 1e3));
        }
        let peak = row.runs.last().map_or(0, |run| run.peak_bytes);
        let _ = writeln!(text, " {:.0} |", peak as f64 / table.triangles as f64);
    }
    text
}

impl Table {
    /// A figure as it is shown: million triangles a second, nanoseconds a vertex,
    /// microseconds a 4-ring.
    pub(crate) fn shown(&self, task: &str, seconds: f64) -> f64 {
        match task {
            BUILD => self.triangles as f64 / seconds * 1e-6,
            RING => seconds * 1e9 / self.vertices as f64,
            _ => seconds * 1e6 / self.four_rings as f64,
        }
    }

    /// Seconds of the fastest of ours that has rings: who builds without them does less.
    fn best(&self, task: &str) -> f64 {
        let ours = self.rows.iter().filter(|row| row.is_ours() && row.median(RING).is_some());
        ours.filter_map(|row| row.median(task)).fold(f64::NAN, f64::min)
    }
}

fn structure(table: &Table, row: &Row, best: [f64; 3]) -> String {
    let mut text = format!("| {} |", row.peer);
    let Some(last) = row.runs.last() else {
        let reason = row.left_out.as_ref().map_or_else(|| "not asked".into(), ToString::to_string);
        return format!("{text} {reason} | | | | | | | | |\n");
    };
    for (task, best) in [BUILD, RING, FOUR_RING].into_iter().zip(best) {
        text += &row.median(task).map_or_else(
            || " | |".into(),
            |seconds| format!(" {:.1} | {} |", table.shown(task, seconds), ratio(best / seconds)),
        );
    }
    let [live, peak] = [last.live_bytes, last.peak_bytes].map(|bytes| bytes as f64 / table.triangles as f64);
    let after = row.left_out.as_ref().map(|reason| format!(", then {reason}")).unwrap_or_default();
    let _ = writeln!(text, " {live:.0} | {peak:.0} | {}{after} |", row.runs.len());
    text
}

/// Nothing where there is nothing of ours to compare with.
fn ratio(ratio: f64) -> String {
    if ratio.is_nan() { String::new() } else { format!("{ratio:.2}") }
}

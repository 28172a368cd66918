//! The report for people to read.

use super::measure::{HELD, RINGS, TOLERANCE};
use super::record::{Point, Run};
use crate::tables::{scaled, table, wrapped};
use crate::timing::Timing;
use std::fmt::Write;

pub(crate) const NOTES: &[&str] = &[
    "Neighbours: the first ring of every vertex, asked for once. Total: from the structure and the mesh at rest to the \
     displacements: every ring is asked for once, which gives the rows of a sparse matrix, then the linear system of Eq. (9) \
     of Biscaro et al. (2016) is solved by conjugate gradients. These are the solid and the dashed lines of their Figs. 18 \
     to 21. Building the structure is in neither.",
    "Times are medians of at least three runs, after one to warm up, in milliseconds. `*` is a single run, the first: of \
     `no data structure`, which searches all faces, where it takes over eight budgets (--budget), or of everything where \
     the budget is 0. `-` was left out (--quadratic-up-to).",
];

/// One of the two times of a deformation.
type Time = fn(&Point) -> Timing;

/// Everything.
pub(crate) fn of(run: &Run) -> String {
    let mut text = format!("onering {} on {}\n", run.version, run.machine);
    NOTES.iter().for_each(|note| text += &format!("{}\n", wrapped(note)));
    let _ = writeln!(
        text,
        "an organ (made here), {HELD} % of the vertices held, force over {RINGS} rings, tolerance {TOLERANCE:e}\n"
    );
    let times: [(&str, Time); 2] =
        [("Neighbours, ms", |point| point.neighbours), ("Total, ms", |point| point.total)];
    for (title, time) in times {
        let sizes: Vec<String> =
            run.sizes.iter().map(|size| format!("{}\nvertices", size.vertices)).collect();
        let header: Vec<&str> = std::iter::once(title).chain(sizes.iter().map(String::as_str)).collect();
        let mut rows = table(&header, 1);
        for line in &run.lines {
            let cells = line.points.iter().map(|point| scaled(point.as_ref().map(time), 1e6));
            rows.add_row(std::iter::once(line.name.to_owned()).chain(cells));
        }
        text += &format!("{rows}\n");
    }
    let iterations =
        |i: usize| run.lines.iter().find_map(|line| line.points[i].map(|point| point.iterations));
    let all: Vec<_> =
        (0..run.sizes.len()).map(|i| iterations(i).map_or("-".into(), |n| n.to_string())).collect();
    let _ = writeln!(text, "iterations: {}", all.join(", "));
    let _ = match run.mismatches.len() {
        0 => writeln!(text, "all neighbours and displacements agree"),
        n => writeln!(text, "{n} answers DIFFER"),
    };
    text
}

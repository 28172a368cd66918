//! Tables with a figure in each cell: its median, and how far the runs spread.

use crate::tables::digits;
use crate::timing::Timing;
use maud::{Markup, html};

/// What is in a cell.
#[derive(Clone, Debug)]
pub(super) enum Cell {
    Words(String),
    Number(Option<f64>),
    /// In nanoseconds a unit.
    Time(Option<Timing>, f64),
}

/// A table of structures.
#[derive(Debug)]
pub(super) struct Table {
    pub(super) caption: String,
    pub(super) header: Vec<String>,
    /// The name of each row, and its cells.
    pub(super) rows: Vec<(String, Vec<Cell>)>,
}

impl Table {
    /// Whether a column has words in it, after the names of rows.
    fn has_words(&self, column: usize) -> bool {
        let first = self.rows.first().and_then(|(_, cells)| cells.get(column.checked_sub(1)?));
        matches!(first, Some(Cell::Words(_)))
    }

    pub(super) fn markup(&self) -> Markup {
        html! {
            div.scroll tabindex="0" role="region" aria-label=(self.caption) {
                table {
                    caption { (self.caption) }
                    thead {
                        tr {
                            @for (i, name) in self.header.iter().enumerate() {
                                th.words[self.has_words(i)] scope="col" { (name) }
                            }
                        }
                    }
                    tbody {
                        @for (name, cells) in &self.rows {
                            tr { th scope="row" { (name) } @for cell in cells { (cell.markup()) } }
                        }
                    }
                }
            }
        }
    }
}

impl Cell {
    fn markup(&self) -> Markup {
        match self {
            Self::Words(words) => html! { td.words { (words) } },
            Self::Number(None) | Self::Time(None, _) => html! { td { "-" } },
            Self::Number(Some(number)) => html! { td { (format!("{number:.2}")) } },
            Self::Time(Some(timing), unit) => {
                let [median, min, quartile] =
                    [timing.median_ns, timing.min_ns, timing.quartile_ns].map(|ns| digits(ns / unit));
                html! {
                    td {
                        (median)
                        @if timing.runs == 1 { "*" } @else { " " span.low { (min) "–" (quartile) } }
                    }
                }
            }
        }
    }
}

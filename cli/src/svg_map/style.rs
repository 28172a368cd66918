//! Colours of a map, on paper and on a dark screen.
//!
//! Attributes say how a map looks on paper, so that programs without style sheets draw it; a style sheet says how it looks where
//! the reader has chosen dark screens.

use super::Map;
use onering_io::colour::viridis;
use std::fmt::Write;
use svg::node::element::Style;

/// The ground of the map, what is around it, and text and frames; on paper and on a dark screen.
pub(super) const GROUND: &str = "#fff";
pub(super) const AROUND: &str = "#f6f8fa";
pub(super) const INK: &str = "#24292f";
const DARK_GROUND: &str = "#161b22";
const DARK_AROUND: &str = "#0d1117";
const DARK_INK: &str = "#d0d7de";

/// Minima, as vermilion as flags are (Okabe and Ito, 2008): no colour of the scale is near to it.
pub(super) const MINIMUM: &str = "#d55e00";
const DARK_MINIMUM: &str = "#ff8a3d";

/// The part of viridis that stands out from the ground: its yellow does not from white, nor its violet from black.
const ON_PAPER: [f64; 2] = [0.0, 0.86];
const ON_DARK: [f64; 2] = [0.2, 1.0];

/// Places of the scale in the legend.
pub(super) const STOPS: usize = 16;

/// The colours of heights.
pub(super) struct Colours {
    /// Of each level, where it is between the least and the largest value.
    shares: Vec<f64>,
}

impl Colours {
    pub(super) fn of(map: &Map<'_>) -> Self {
        let [least, most] = map.surface.range().unwrap_or_default().map(f64::from);
        let share = |height: f32| (f64::from(height) - least) / (most - least);
        Self { shares: map.levels.all.iter().map(|level| share(level.height)).collect() }
    }

    /// The colour of a level on paper.
    pub(super) fn light(&self, level: usize) -> String {
        hex(self.shares[level], ON_PAPER)
    }
}

/// The colour of a stop of the legend on paper.
pub(super) fn stop(i: usize) -> String {
    hex(i as f64 / STOPS as f64, ON_PAPER)
}

/// The class of a level.
pub(super) fn class(level: usize) -> String {
    format!("l{level}")
}

/// How all looks on a dark screen.
pub(super) fn sheet(colours: &Colours) -> Style {
    let mut css = format!(
        "@media(prefers-color-scheme:dark){{.ground{{fill:{DARK_GROUND}}}.around{{fill:{DARK_AROUND}}}\
         .ink{{fill:{DARK_INK}}}.rule{{stroke:{DARK_INK}}}.halo{{stroke:{DARK_GROUND}}}\
         .minimum{{stroke:{DARK_MINIMUM}}}"
    );
    for (i, share) in colours.shares.iter().enumerate() {
        let _ = write!(css, ".{}{{stroke:{}}}", class(i), hex(*share, ON_DARK));
    }
    for i in 0..=STOPS {
        let _ = write!(css, ".s{i}{{stop-color:{}}}", hex(i as f64 / STOPS as f64, ON_DARK));
    }
    Style::new(css + "}")
}

fn hex(share: f64, [from, to]: [f64; 2]) -> String {
    let share = if share.is_nan() { 0.0 } else { share.clamp(0.0, 1.0) };
    let [r, g, b] = viridis(from + share * (to - from));
    format!("#{r:02x}{g:02x}{b:02x}")
}

//! Minima, maxima and saddles on a map.

use super::page::Page;
use super::{path, style};
use crate::minima::{Extrema, Extremum};
use crate::surface::Surface;
use svg::node::element::{Group, Path};

/// A kind of vertices, and how it is drawn.
pub(super) struct Symbol {
    pub(super) names: [&'static str; 2],
    of: fn(&Extrema) -> &[Extremum],
    /// Around its place, of this size; a dot where there is none.
    shape: Option<fn(i32) -> String>,
    class: &'static str,
    stroke: &'static str,
}

impl Symbol {
    /// Later ones are drawn over earlier ones.
    pub(super) const ALL: [Self; 3] = [
        Self {
            names: ["saddle", "saddles"],
            of: |extrema| &extrema.saddles,
            shape: Some(|r| format!("m-{r}-{r}l{d} {d}m0-{d}l-{d} {d}", d = 2 * r)),
            class: "rule",
            stroke: style::INK,
        },
        Self {
            names: ["maximum", "maxima"],
            of: |extrema| &extrema.maxima,
            shape: Some(|r| format!("m0-{}l{r} {}h-{}z", r * 6 / 5, 2 * r - r / 4, 2 * r)),
            class: "rule",
            stroke: style::INK,
        },
        Self {
            names: ["minimum", "minima"],
            of: |extrema| &extrema.minima,
            shape: None,
            class: "minimum",
            stroke: style::MINIMUM,
        },
    ];

    pub(super) fn of<'a>(&self, extrema: &'a Extrema) -> &'a [Extremum] {
        (self.of)(extrema)
    }

    pub(super) fn name(&self, count: usize) -> &'static str {
        self.names[usize::from(count != 1)]
    }

    /// The symbol at these places, in tenths of a pixel, smaller where there are many on the map; below it a broader one
    /// in the colour of the ground, which divides it from the lines.
    pub(super) fn draw(&self, places: &[[i32; 2]], count: usize) -> Group {
        // Half the size, the width of lines and that of the ground around them.
        let (size, width, gap) = match count {
            0..=250 => (30, 14, 13),
            251..=1000 => (20, 10, 8),
            _ => (12, 7, 4),
        };
        let mut data = path::Data::default();
        for &place in places {
            match self.shape {
                Some(shape) => data.shape(place, &shape(size)),
                None => data.dot(place),
            }
        }
        let Some(path) = data.path() else { return Group::new() };
        let width = if self.shape.is_some() { width } else { 2 * size };
        let path = path.set("fill", "none").set("stroke-linecap", "round").set("stroke-linejoin", "round");
        let halo = path.clone().set("class", "halo").set("stroke", style::GROUND);
        Group::new()
            .add(halo.set("stroke-width", width + 2 * gap))
            .add(self.coloured(path).set("stroke-width", width))
    }

    fn coloured(&self, path: Path) -> Path {
        path.set("class", self.class).set("stroke", self.stroke)
    }
}

/// All that was found.
pub(super) fn on_map(extrema: &Extrema, surface: &Surface, page: &Page) -> Group {
    let count = Symbol::ALL.iter().map(|symbol| symbol.of(extrema).len()).sum();
    Symbol::ALL.iter().fold(page.map_group(), |group, symbol| {
        let found = symbol.of(extrema);
        let place = |extremum: &Extremum| page.place(surface.up.turned(extremum.position));
        let places: Vec<_> = found.iter().map(place).collect();
        group.add(symbol.draw(&places, count))
    })
}

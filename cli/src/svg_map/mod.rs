//! A map: a mesh seen from above, with contours coloured by height, minima as dots, a legend and a scale.
//!
//! Colours are viridis. What is light on paper is dark on a screen that is set so, and the colours change with it, so that both
//! ends of the scale stand out from the ground: see [`style`].

mod labels;
mod legend;
mod number;
mod page;
mod path;
mod style;
mod symbols;

use crate::failure::Failure;
use crate::level::Levels;
use crate::minima::Extrema;
use crate::surface::Surface;
use onering_io::{Lines, Replacement};
use page::Page;
use std::io::Write;
use std::path::Path;
use style::Colours;
use svg::node::element::{Group, SVG, Title};

/// What is on a map.
pub(crate) struct Map<'a> {
    pub(crate) surface: &'a Surface,
    pub(crate) levels: &'a Levels,
    /// At these levels, each with its level as value.
    pub(crate) lines: &'a Lines,
    pub(crate) extrema: &'a Extrema,
}

/// Draws the map to a file, which appears whole or not at all.
pub(crate) fn save(path: &Path, map: &Map<'_>) -> Result<(), Failure> {
    let failed = |error| Failure::Output(format!("{}: {error}", path.display()));
    let mut file = Replacement::create(path).map_err(failed)?;
    writeln!(file, "{}", draw(map)).and_then(|()| file.finish()).map_err(failed)
}

fn draw(map: &Map<'_>) -> SVG {
    let page = Page::of(map.surface);
    let colours = Colours::of(map);
    let [width, height] = page.size();
    SVG::new()
        .set("viewBox", format!("0 0 {width} {height}"))
        .set("width", width)
        .set("height", height)
        .set("font-family", "system-ui, sans-serif")
        .set("font-size", 13)
        .add(Title::new(page::heading(map)))
        .add(style::sheet(&colours))
        .add(page.ground())
        .add(page.heading(map))
        .add(contours(map, &page, &colours))
        .add(labels::on_map(map, &page))
        .add(page.frame())
        .add(symbols::on_map(map.extrema, map.surface, &page))
        .add(legend::heights(map, &page))
        .add(legend::symbols(map.extrema, &page))
        .add(page.scale(map.surface))
}

/// A path for each level, the lowest first: where a surface lies over itself, what is higher is drawn over what is
/// lower.
fn contours(map: &Map<'_>, page: &Page, colours: &Colours) -> Group {
    // Many lines are fine ones.
    let width = if map.levels.all.len() > 60 { 7 } else { 10 };
    let group = page.map_group().set("fill", "none").set("stroke-linejoin", "round");
    let mut group = group.set("stroke-width", width);
    let mut lines = map.lines.iter().peekable();
    for (i, level) in map.levels.all.iter().enumerate() {
        let mut data = path::Data::default();
        while let Some(line) = lines.next_if(|line| line.value <= level.height) {
            data.line(line.points.iter().map(|p| page.place(map.surface.up.turned(*p))), line.is_closed);
        }
        if let Some(path) = data.path() {
            let path = path.set("class", style::class(i)).set("stroke", colours.light(i));
            let path = if level.is_index { path.set("stroke-width", 2 * width) } else { path };
            let label = format!("{}{}", level.height, map.surface.with_unit(""));
            group = group.add(path.add(Title::new(label)));
        }
    }
    group
}

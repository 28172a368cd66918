//! What colours and symbols mean.

use super::page::{Page, text};
use super::symbols::Symbol;
use super::{Map, number, style};
use crate::level::round_up;
use crate::minima::Extrema;
use svg::node::element::{Definitions, Group, LinearGradient, Path, Rectangle, Stop};

/// Width of the scale, and its greatest height.
const WIDTH: f64 = 16.0;
const HEIGHT: f64 = 300.0;
/// What the symbols need below it.
const SYMBOLS: f64 = 100.0;
const LINE: f64 = 22.0;

/// The scale of heights, with numbers at round ones.
pub(super) fn heights(map: &Map<'_>, page: &Page) -> Group {
    let Some([least, most]) = map.surface.range().map(|range| range.map(f64::from)) else {
        return Group::new();
    };
    let ([x, top], room) = page.legend();
    let height = (room - SYMBOLS).min(HEIGHT);
    let stops = (0..=style::STOPS).map(|i| {
        let offset = format!("{}%", 100.0 * i as f64 / style::STOPS as f64);
        Stop::new().set("class", format!("s{i}")).set("offset", offset).set("stop-color", style::stop(i))
    });
    let upwards =
        LinearGradient::new().set("id", "heights").set("x1", 0).set("x2", 0).set("y1", 1).set("y2", 0);
    let gradient = stops.fold(upwards, |gradient, stop| gradient.add(stop));
    let bar = Rectangle::new().set("fill", "url(#heights)").set("x", x).set("y", top + 16.0);
    let name = format!("{}{}", map.surface.field_name(), unit_in(map));
    let group = Group::new()
        .add(Definitions::new().add(gradient))
        .add(bar.set("width", WIDTH).set("height", height))
        .add(text(name, [x, top + 4.0]));
    let step = round_up((most - least) / 7.0);
    if step == 0.0 {
        return group.add(text(number::text(least, 1.0), [x + WIDTH + 8.0, top + 16.0 + height]));
    }
    let first = (least / step).ceil() as i64;
    let values =
        (first..first.saturating_add(20)).map(|i| i as f64 * step).take_while(|value| *value <= most);
    values.fold(group, |group, value| {
        let y = top + 16.0 + height * (most - value) / (most - least);
        let tick = Path::new()
            .set("d", format!("M{:.1} {y:.1}h5", x + WIDTH))
            .set("class", "rule")
            .set("stroke", style::INK);
        group.add(tick).add(text(number::text(value, step), [x + WIDTH + 9.0, y + 4.5]))
    })
}

fn unit_in(map: &Map<'_>) -> String {
    if map.surface.unit.is_empty() { String::new() } else { format!(" in {}", map.surface.unit) }
}

/// Each symbol that is on the map, and how often.
pub(super) fn symbols(extrema: &Extrema, page: &Page) -> Group {
    let ([x, top], room) = page.legend();
    let first = top + (room - SYMBOLS).min(HEIGHT) + 48.0;
    let found = Symbol::ALL.iter().filter(|symbol| !symbol.of(extrema).is_empty());
    found.enumerate().fold(Group::new(), |group, (i, symbol)| {
        let y = first + LINE * i as f64;
        let place = [x + WIDTH / 2.0, y - 4.5].map(|place| (10.0 * place).round() as i32);
        let tenths = Group::new().set("transform", "scale(0.1)");
        let words = format!("{} {}", symbol.of(extrema).len(), symbol.name(symbol.of(extrema).len()));
        group.add(tenths.add(symbol.draw(&[place], 1))).add(text(words, [x + WIDTH + 9.0, y]))
    })
}

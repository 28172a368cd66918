//! Heights written on lines.

use super::page::{Page, text};
use super::{Map, number, style};
use onering_io::Line;
use svg::node::element::Group;

/// All in tenths of a pixel: of lines that get a label, the least length; between labels, the least distance; to both
/// sides of a label, how far its line decides how it is turned.
const LENGTH: f64 = 1800.0;
const DISTANCE: f64 = 700.0;
const HALF: f64 = 140.0;
/// No more labels than one would read, and no more levels without an index that get one.
const MOST: usize = 60;
const FEW: usize = 12;

/// A place on a line, and how the line runs there, in degrees from -90 to 90.
struct Spot {
    place: [f64; 2],
    degrees: f64,
    height: f32,
}

/// A label at the middle of each line of an index that is long enough; where there is no index and levels are few, of
/// each line.
pub(super) fn on_map(map: &Map<'_>, page: &Page) -> Group {
    let all = &map.levels.all;
    let has_index = all.iter().any(|level| level.is_index);
    let is_labelled = |height: f32| {
        let i = all.partition_point(|level| level.height < height);
        all.get(i).is_some_and(|level| if has_index { level.is_index } else { all.len() <= FEW })
    };
    let labelled = map.lines.iter().filter(|line| is_labelled(line.value));
    let mut spots: Vec<(f64, Spot)> = labelled.filter_map(|line| middle(map, page, &line)).collect();
    // The longest lines choose first.
    spots.sort_by(|a, b| b.0.total_cmp(&a.0));
    let mut taken: Vec<[f64; 2]> = Vec::new();
    let mut group = page.map_group().set("font-size", 95).set("text-anchor", "middle");
    for (_, spot) in spots {
        if taken.len() == MOST {
            break;
        }
        if taken.iter().all(|other| distance(*other, spot.place) >= DISTANCE) {
            taken.push(spot.place);
            group = group.add(label(&spot));
        }
    }
    group
}

/// The length of a line and its middle; `None` where it is too short.
fn middle(map: &Map<'_>, page: &Page, line: &Line<'_>) -> Option<(f64, Spot)> {
    let closing = if line.is_closed { line.points.first() } else { None };
    let place = |p: &[f32; 3]| page.place(map.surface.up.turned(*p)).map(f64::from);
    let places: Vec<[f64; 2]> = line.points.iter().chain(closing).map(place).collect();
    let length: f64 = places.windows(2).map(|two| distance(two[0], two[1])).sum();
    if length < LENGTH {
        return None;
    }
    let [before, spot, after] = [-HALF, 0.0, HALF].map(|offset| along(&places, 0.5 * length + offset));
    let degrees = (after[1] - before[1]).atan2(after[0] - before[0]).to_degrees();
    // Nothing is upside down.
    let degrees = if degrees > 90.0 {
        degrees - 180.0
    } else if degrees < -90.0 {
        degrees + 180.0
    } else {
        degrees
    };
    Some((length, Spot { place: spot, degrees, height: line.value }))
}

/// The place this far along the line.
fn along(places: &[[f64; 2]], mut rest: f64) -> [f64; 2] {
    for two in places.windows(2) {
        let step = distance(two[0], two[1]);
        if rest <= step && step > 0.0 {
            return [0, 1].map(|i| two[0][i] + rest / step * (two[1][i] - two[0][i]));
        }
        rest -= step;
    }
    places.last().copied().unwrap_or_default()
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

/// The height over a broader one in the colour of the ground, which interrupts the line.
fn label(spot: &Spot) -> Group {
    let Spot { place: [x, y], degrees, height } = spot;
    let words = number::short((*height).into());
    let turn = format!("translate({x:.0} {y:.0}) rotate({degrees:.0})");
    let halo = text(words.clone(), [0.0, 33.0]).set("class", "halo").set("fill", "none");
    let halo = halo.set("stroke", style::GROUND).set("stroke-width", 40).set("stroke-linejoin", "round");
    Group::new().set("transform", turn).add(halo).add(text(words, [0.0, 33.0]))
}

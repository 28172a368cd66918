//! Where things are on the page, in pixels.

use super::{Map, number, style};
use crate::level::round_up;
use crate::surface::Surface;
use svg::node::element::{Group, Path, Rectangle, Text};

/// The longer side of the map.
const MAP: f64 = 720.0;
const MARGIN: f64 = 24.0;
const HEAD: f64 = 66.0;
const FOOT: f64 = 62.0;
/// What is beside the map, and how much height that needs.
const LEGEND: f64 = 150.0;
const LEGEND_HEIGHT: f64 = 300.0;
/// Coordinates are whole tenths of a pixel.
const TENTHS: f64 = 10.0;

/// The part of space that is on the map, and its scale.
pub(super) struct Page {
    /// The least coordinate to the right and the largest away, as seen from above.
    corner: [f64; 2],
    /// Width and height of what is on the map.
    extent: [f64; 2],
    /// Pixels a unit.
    scale: f64,
}

impl Page {
    /// The corners of all faces are on the map.
    pub(super) fn of(surface: &Surface) -> Self {
        let (mut min, mut max) = ([f32::INFINITY; 2], [f32::NEG_INFINITY; 2]);
        for &v in surface.mesh.faces.as_flattened() {
            let point = surface.up.turned(surface.mesh.positions[v as usize]);
            for i in 0..2 {
                min[i] = min[i].min(point[i]);
                max[i] = max[i].max(point[i]);
            }
        }
        if surface.mesh.faces.is_empty() {
            (min, max) = ([0.0; 2], [0.0; 2]);
        }
        let extent = [0, 1].map(|i| f64::from(max[i]) - f64::from(min[i]));
        let longest = extent[0].max(extent[1]);
        let scale = if longest > 0.0 { MAP / longest } else { 0.0 };
        Self { corner: [min[0].into(), max[1].into()], extent, scale }
    }

    /// Where a point is on the map, in tenths of a pixel; its coordinates are those to the right, away and up.
    pub(super) fn place(&self, [right, away, _]: [f32; 3]) -> [i32; 2] {
        let offset = [f64::from(right) - self.corner[0], self.corner[1] - f64::from(away)];
        offset.map(|offset| (offset * self.scale * TENTHS).round() as i32)
    }

    /// Of the whole page.
    pub(super) fn size(&self) -> [f64; 2] {
        let [width, height] = self.map_size();
        [2.0 * MARGIN + width + LEGEND, HEAD + height.max(LEGEND_HEIGHT) + FOOT].map(f64::ceil)
    }

    /// Where the legend starts, and how high it may be.
    pub(super) fn legend(&self) -> ([f64; 2], f64) {
        let [width, height] = self.map_size();
        ([MARGIN + width + 26.0, HEAD], height.max(LEGEND_HEIGHT))
    }

    /// What is drawn in tenths of a pixel, at the place of the map.
    pub(super) fn map_group(&self) -> Group {
        Group::new().set("transform", format!("translate({MARGIN} {HEAD}) scale({})", 1.0 / TENTHS))
    }

    /// The paper.
    pub(super) fn ground(&self) -> Group {
        let [width, height] = self.size();
        let page = Rectangle::new().set("class", "around").set("fill", style::AROUND);
        let map = self.map_rectangle().set("class", "ground").set("fill", style::GROUND);
        Group::new().add(page.set("width", width).set("height", height)).add(map)
    }

    /// The line around the map.
    pub(super) fn frame(&self) -> Rectangle {
        self.map_rectangle().set("class", "rule").set("fill", "none").set("stroke", style::INK)
    }

    /// What the map is, in large and in small.
    pub(super) fn heading(&self, map: &Map<'_>) -> Group {
        let name = text(heading(map), [MARGIN, 30.0]).set("font-size", 18).set("font-weight", 600);
        Group::new().add(name).add(text(about(map), [MARGIN, 51.0]))
    }

    /// A bar of a round length, and which axes run where.
    pub(super) fn scale(&self, surface: &Surface) -> Group {
        let [width, height] = self.map_size();
        let y = HEAD + height + 20.0;
        let [right, away, up] = surface.up.names();
        let axes = format!("{right} to the right, {away} away, {up} up");
        let axes = text(axes, [MARGIN + width, y + 10.0]).set("text-anchor", "end");
        let length = round_up(self.extent[0] / 6.0);
        if length == 0.0 {
            return Group::new().add(axes);
        }
        let (x, pixels) = (MARGIN, length * self.scale);
        let bar = Path::new()
            .set("d", format!("M{x:.1} {y:.1}v8h{pixels:.1}v-8M{:.1} {:.1}v4", x + pixels / 2.0, y + 4.0))
            .set("class", "rule")
            .set("fill", "none")
            .set("stroke", style::INK)
            .set("stroke-width", 1.5);
        let label = number::text(length, length) + &surface.with_unit("");
        Group::new().add(axes).add(bar).add(text(label, [x + pixels + 8.0, y + 10.0]))
    }

    fn map_size(&self) -> [f64; 2] {
        self.extent.map(|extent| extent * self.scale)
    }

    fn map_rectangle(&self) -> Rectangle {
        let [width, height] = self.map_size().map(|size| format!("{size:.1}"));
        Rectangle::new().set("x", MARGIN).set("y", HEAD).set("width", width).set("height", height)
    }
}

/// Words in ink, that begin at this place.
pub(super) fn text(words: impl Into<String>, [x, y]: [f64; 2]) -> Text {
    let [x, y] = [x, y].map(|place| format!("{place:.1}"));
    Text::new(words).set("class", "ink").set("fill", style::INK).set("x", x).set("y", y)
}

/// The name of the mesh, without its folders.
pub(super) fn heading(map: &Map<'_>) -> String {
    let name = map.surface.name.as_str();
    onering_io::one_line(name.rsplit(['/', '\\']).next().unwrap_or(name))
}

fn about(map: &Map<'_>) -> String {
    let (field, unit) = (map.surface.field_name(), map.surface.with_unit(""));
    let every = match map.levels.step {
        _ if map.levels.all.is_empty() => return format!("no contours of {field}"),
        Some(step) => format!("Contours of {field} every {}{unit}", number::short(step)),
        None => format!("Contours of {field} at {} levels", map.levels.all.len()),
    };
    let has_index = map.levels.all.iter().any(|level| level.is_index);
    if has_index { every + ", each fifth thicker" } else { every }
}

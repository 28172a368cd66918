//! Points by two figures, of which less is better, with their names and the front of those that none beats in both.

use super::axis::Axis;
use super::figure::{Frame, INK, Tone, write};
use super::labels::{self, Box2};
use plotters::prelude::*;
use plotters::style::text_anchor::HPos;

#[derive(Clone, Copy, Debug)]
pub(super) struct Point<'a> {
    pub(super) name: &'a str,
    pub(super) x: f64,
    pub(super) y: f64,
    /// The least and the largest `y` that were measured.
    pub(super) spread: [f64; 2],
    /// Whether it can be on the front: what answers less is none of the rivals.
    pub(super) is_mesh: bool,
}

/// The places of those meshes that no other beats in one figure without being worse in the other, by rising `x`.
pub(super) fn front(points: &[Point<'_>]) -> Vec<usize> {
    let mut order: Vec<usize> = (0..points.len()).filter(|&i| points[i].is_mesh).collect();
    order.sort_by(|&a, &b| {
        let [a, b] = [points[a], points[b]];
        a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
    });
    let mut least = f64::INFINITY;
    order.retain(|&i| {
        let is_better = points[i].y < least;
        least = least.min(points[i].y);
        is_better
    });
    order
}

/// Names of axes, and the points.
pub(super) fn draw(id: &str, words: [&str; 4], points: &[Point<'_>]) -> String {
    let [title, description, x, y] = words;
    let front = front(points);
    let frame = Frame {
        id,
        title,
        description,
        x: (Axis::from_zero(points.iter().map(|point| point.x)), x),
        y: (Axis::around(points.iter().flat_map(|point| [point.y, point.spread[0]])), y),
        height: 470,
        top: 8,
        sides: [64, 16],
    };
    frame.draw(|chart, root| {
        let at = |point: &Point<'_>, y: f64| chart.backend_coord(&(point.x, y));
        let (across, up) = chart.plotting_area().get_pixel_range();
        let steps = front.windows(2).flat_map(|two| {
            let [a, b] = [points[two[0]], points[two[1]]];
            [at(&a, a.y), at(&b, a.y), at(&b, b.y)]
        });
        let steps: Vec<(i32, i32)> = steps.collect();
        let mut lines: Vec<Box2> = steps.windows(2).map(|two| along(two[0], two[1])).collect();
        root.draw(&PathElement::new(steps, Tone::of(0).rgb().stroke_width(2)))?;
        for point in points {
            let [low, high] = point.spread.map(|y| at(point, y).1.clamp(up.start, up.end));
            let place = at(point, point.y);
            lines.push(along((place.0, low), (place.0, high)));
            let faint = Tone::of(0).rgb().mix(0.35).stroke_width(3);
            root.draw(&PathElement::new([(place.0, low), (place.0, high)], faint))?;
        }
        for (i, point) in points.iter().enumerate() {
            let place = at(point, point.y);
            let style = Tone::of(0).rgb();
            let style = if front.contains(&i) { style.filled() } else { style.stroke_width(2) };
            if point.is_mesh {
                root.draw(&Circle::new(place, 5, style))?;
            } else {
                root.draw(&TriangleMarker::new(place, 7, style))?;
            }
        }
        let places: Vec<(f64, f64)> = points
            .iter()
            .map(|point| at(point, point.y))
            .map(|(x, y)| (f64::from(x), f64::from(y)))
            .collect();
        let names: Vec<&str> = points.iter().map(|point| point.name).collect();
        let bounds = [across.start, up.start, across.end, up.end].map(f64::from);
        for ((place, name), label) in
            places.iter().zip(&names).zip(labels::beside(&places, &names, bounds, lines))
        {
            let [left, top, right, bottom] = label;
            // What of the name is nearest, and a line to it where it is far.
            let end = (place.0.clamp(left, right), place.1.clamp(top, bottom));
            if (end.0 - place.0).hypot(end.1 - place.1) > 18.0 {
                let line = [*place, end].map(|(x, y)| (x.round() as i32, y.round() as i32));
                root.draw(&PathElement::new(line, INK.rgb().mix(0.45)))?;
            }
            // The name may be narrower than its box: it stands at the end that is nearer.
            let (x, anchor) = match place.0 {
                x if x <= left => (left, HPos::Left),
                x if x >= right => (right, HPos::Right),
                _ => ((left + right) / 2.0, HPos::Center),
            };
            let middle = (top + bottom) / 2.0;
            write(root, name, (x.round() as i32, middle.round() as i32), anchor)?;
        }
        Ok(())
    })
}

/// The box of an upright or level line.
fn along(a: (i32, i32), b: (i32, i32)) -> Box2 {
    let [left, right] = [a.0.min(b.0), a.0.max(b.0)].map(f64::from);
    let [top, bottom] = [a.1.min(b.1), a.1.max(b.1)].map(f64::from);
    [left - 2.0, top - 2.0, right + 2.0, bottom + 2.0]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_front_is_what_nothing_beats() {
        let point = |(x, y): (f64, f64)| Point { name: "", x, y, spread: [y, y], is_mesh: x != 1.0 };
        let points =
            [(26.0, 3.0), (12.0, 9.0), (62.0, 4.0), (26.0, 5.0), (32.0, 2.0), (14.0, 9.0), (1.0, 1.0)]
                .map(point);
        assert_eq!(front(&points), [1, 0, 4]);
        assert!(front(&[]).is_empty());
    }
}

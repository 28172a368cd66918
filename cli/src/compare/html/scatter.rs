//! Points by two figures, of which less is better, with their names and the front of those that none beats in both.

use super::axis::Axis;
use super::figure::{Area, Drawn, Frame, INK, Tone, write};
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
        let mut lines = front_line(root, &front, |i, j| at(&points[i], points[j].y))?;
        for point in points {
            let [low, high] = point.spread.map(|y| at(point, y)).map(|(x, y)| (x, y.clamp(up.start, up.end)));
            lines.push(along(low, high));
            root.draw(&PathElement::new([low, high], Tone::of(0).rgb().mix(0.35).stroke_width(3)))?;
        }
        for (i, point) in points.iter().enumerate() {
            mark(root, point.is_mesh, front.contains(&i), at(point, point.y))?;
        }
        let places = points.iter().map(|point| at(point, point.y));
        let places: Vec<(f64, f64)> = places.map(|(x, y)| (f64::from(x), f64::from(y))).collect();
        let names: Vec<&str> = points.iter().map(|point| point.name).collect();
        let bounds = [across.start, up.start, across.end, up.end].map(f64::from);
        let labels = labels::beside(&places, &names, bounds, lines);
        let mut named = places.iter().zip(names).zip(labels);
        named.try_for_each(|((&place, name), label)| write_beside(root, place, name, label))
    })
}

/// Steps from each point of the front to the next, and their boxes, which names keep clear of. `at` is the pixel at the
/// `x` of one point and the `y` of another.
fn front_line(
    root: &Area<'_>,
    front: &[usize],
    at: impl Fn(usize, usize) -> (i32, i32),
) -> Result<Vec<Box2>, Box<dyn std::error::Error>> {
    let steps = front.windows(2).flat_map(|two| [at(two[0], two[0]), at(two[1], two[0]), at(two[1], two[1])]);
    let steps: Vec<(i32, i32)> = steps.collect();
    let boxes = steps.windows(2).map(|two| along(two[0], two[1])).collect();
    root.draw(&PathElement::new(steps, Tone::of(0).rgb().stroke_width(2)))?;
    Ok(boxes)
}

/// A circle for a mesh, three corners for what is less; filled on the front.
fn mark(root: &Area<'_>, is_mesh: bool, is_on_front: bool, at: (i32, i32)) -> Drawn {
    let style = Tone::of(0).rgb();
    let style = if is_on_front { style.filled() } else { style.stroke_width(2) };
    if is_mesh {
        root.draw(&Circle::new(at, 5, style))?;
    } else {
        root.draw(&TriangleMarker::new(at, 7, style))?;
    }
    Ok(())
}

/// The name of the point at `place` in the box that was found for it.
fn write_beside(root: &Area<'_>, place: (f64, f64), name: &str, label: Box2) -> Drawn {
    let [left, top, right, bottom] = label;
    // What of the name is nearest, and a line to it where it is far.
    let end = (place.0.clamp(left, right), place.1.clamp(top, bottom));
    if (end.0 - place.0).hypot(end.1 - place.1) > 18.0 {
        let line = [place, end].map(|(x, y)| (x.round() as i32, y.round() as i32));
        root.draw(&PathElement::new(line, INK.rgb().mix(0.45)))?;
    }
    // The name may be narrower than its box: it stands at the end that is nearer.
    let (x, anchor) = match place.0 {
        x if x <= left => (left, HPos::Left),
        x if x >= right => (right, HPos::Right),
        _ => (f64::midpoint(left, right), HPos::Center),
    };
    write(root, name, (x.round() as i32, f64::midpoint(top, bottom).round() as i32), anchor)
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

//! Time against size, on logarithmic axes.

use super::axis::Axis;
use super::figure::grouped;
use super::mesh::each;
use super::table::{Cell, Table};
use super::{Plot, lines, place};
use crate::compare::record::{Growth, InOrder};
use crate::timing::Timing;

/// Of building, and of one-rings.
pub(super) fn plots(growth: &Growth) -> [Plot; 2] {
    let build = |point: &InOrder, size: usize| Some(point.build.scaled(1.0 / size as f64));
    let ring = |point: &InOrder, _| point.sweep.as_ref().map(each);
    [
        plot(growth, ["growth-build", "Build time by size", "build, ns a triangle"], build),
        plot(growth, ["growth-rings", "Ring time by size", "one-ring, ns a vertex"], ring),
    ]
}

fn plot(growth: &Growth, words: [&str; 3], time: impl Fn(&InOrder, usize) -> Option<Timing>) -> Plot {
    let [id, title, beside] = words;
    let points = |points: &[InOrder]| {
        let known = points.iter().zip(&growth.triangles);
        known.filter_map(|(point, &size)| Some((size as f64, time(point, size)?.median_ns))).collect()
    };
    let lines: Vec<lines::Line<'_>> = growth
        .backends
        .iter()
        .map(|grown| lines::Line {
            name: grown.name,
            place: place(grown.name),
            points: points(&grown.points),
        })
        .filter(|line| !line.points.is_empty())
        .collect();
    let note = format!("Low is better. On {}, cut finer and finer.", growth.mesh);
    let row = |name: &str, points: &[InOrder]| {
        let known = points.iter().zip(&growth.triangles);
        (name.to_owned(), known.map(|(point, &size)| Cell::Time(time(point, size), 1.0)).collect())
    };
    let sizes = growth.triangles.iter().map(|&size| format!("{} triangles", grouped(size)));
    Plot {
        title: title.into(),
        svg: lines::draw(
            id,
            [title, &note, "triangles", beside],
            Axis::around(growth.triangles.iter().map(|&size| size as f64)),
            &lines,
        ),
        note,
        table: Table {
            caption: format!("{title}, {beside}"),
            header: std::iter::once("structure".to_owned()).chain(sizes).collect(),
            rows: growth.backends.iter().map(|grown| row(grown.name, &grown.points)).collect(),
        },
    }
}

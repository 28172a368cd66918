//! `onering minima`: where a field has minima, maxima and saddles.

mod extrema;
mod report;

pub(crate) use extrema::{Extrema, Extremum};

use crate::contours::{Traced, check_size};
use crate::failure::Failure;
use crate::level::Levels;
use crate::output::{self, Status};
use crate::surface::{self, Surface};
use crate::svg_map::{self, Map};
use crate::{args, on_backend};
use onering::{Incidence, NotFinite, critical};
use report::Report;
use std::io;
use std::time::Instant;

/// Finds the minima of one mesh.
pub(crate) fn run(options: &args::Minima) -> io::Result<Status> {
    match minima(options) {
        Ok(text) => output::print(&text).map(|()| Status::Done),
        Err(failure) => failure.end(),
    }
}

/// What is to be printed. Files are written before: nothing is said of one that could not be.
fn minima(options: &args::Minima) -> Result<String, Failure> {
    let made = if options.stalactites { surface::ROOF } else { surface::TERRAIN };
    let surface = &Surface::with_field(&options.mesh, made, &options.heights)?;
    // Beside the points, a map has lines.
    let range = surface.range().filter(|_| options.svg.is_some());
    let levels = &range.map(Levels::usual).unwrap_or_default();
    check_size(surface, levels)?;
    let work = Work { options, surface, levels };
    let (extrema, traced, seconds) = on_backend::run(&options.mesh.backend, &surface.mesh, work)??;
    if let Some(path) = &options.points {
        let points = extrema.points(surface.field_name());
        points.and_then(|points| points.save(path)).map_err(|error| Failure::Output(error.to_string()))?;
    }
    if let Some(path) = &options.svg {
        svg_map::save(path, &Map { surface, levels, lines: &traced.lines, extrema: &extrema })?;
    }
    let report = Report::new(options, surface, &extrema, seconds);
    if options.json {
        return Ok(report.json());
    }
    output::tell(&format!("found in {:.3} ms on {}", 1e3 * seconds, options.mesh.backend));
    Ok(report.text())
}

struct Work<'a> {
    options: &'a args::Minima,
    surface: &'a Surface,
    /// Of the lines for the map.
    levels: &'a Levels,
}

impl on_backend::Work for Work<'_> {
    /// What was found, lines, and the seconds that it took to find the first.
    type Output = Result<(Extrema, Traced, f64), Failure>;

    fn on<M: Incidence>(self, mesh: &M) -> Self::Output {
        let Self { options, surface, levels } = self;
        let (field, turned) = (surface.field(), surface.turned());
        let start = Instant::now();
        let find = || {
            let minima = if options.stalactites {
                critical::stalactite_tips(mesh, &turned)?
            } else {
                critical::local_minima(mesh, &field)?
            };
            let maxima = options.maxima.then(|| critical::local_maxima(mesh, &field)).transpose()?;
            let saddles = options.saddles.then(|| critical::saddles(mesh, &field)).transpose()?;
            Ok((minima, maxima.unwrap_or_default(), saddles.unwrap_or_default()))
        };
        let found = find().map_err(|error: NotFinite| surface.failure(&error));
        let seconds = start.elapsed().as_secs_f64();
        let (minima, maxima, saddles) = found?;
        let extrema = Extrema {
            minima: extrema::extrema(surface, minima),
            maxima: extrema::extrema(surface, maxima),
            saddles: extrema::saddles(surface, saddles),
        };
        Ok((extrema, Traced::of(mesh, surface, levels)?, seconds))
    }
}

//! `onering contours`: lines of equal height, in figures, in a file and on a map.

mod report;
mod trace;

pub(crate) use trace::{Traced, check_size};

use crate::failure::Failure;
use crate::level::Levels;
use crate::minima::Extrema;
use crate::output::{self, Status};
use crate::surface::{self, Surface};
use crate::svg_map::{self, Map};
use crate::{args, on_backend};
use onering::Incidence;
use report::Report;
use std::io;

/// Traces the contours of one mesh.
pub(crate) fn run(options: &args::Contours) -> io::Result<Status> {
    match contours(options) {
        Ok(text) => output::print(&text).map(|()| Status::Done),
        Err(failure) => failure.end(),
    }
}

/// What is to be printed. Files are written before: nothing is said of one that could not be.
fn contours(options: &args::Contours) -> Result<String, Failure> {
    let surface = &Surface::with_field(&options.mesh, surface::TERRAIN, &options.heights)?;
    let levels = &Levels::of(options, surface.range()).map_err(Failure::Usage)?;
    check_size(surface, levels)?;
    let work = Work { surface, levels, minima: options.minima };
    let (traced, extrema) = on_backend::run(&options.mesh.backend, &surface.mesh, work)??;
    if let Some(path) = &options.lines {
        traced.lines.save(path).map_err(|error| Failure::Output(error.to_string()))?;
    }
    if let Some(path) = &options.svg {
        svg_map::save(path, &Map { surface, levels, lines: &traced.lines, extrema: &extrema })?;
    }
    let report = Report::new(&options.mesh.backend, surface, levels, &traced, &extrema);
    if options.json {
        return Ok(report.json());
    }
    output::tell(&format!("traced in {:.3} ms on {}", 1e3 * traced.seconds, options.mesh.backend));
    Ok(report.text(surface))
}

/// Contours, and minima where they are asked for.
struct Work<'a> {
    surface: &'a Surface,
    levels: &'a Levels,
    minima: bool,
}

impl on_backend::Work for Work<'_> {
    type Output = Result<(Traced, Extrema), Failure>;

    fn on<M: Incidence>(self, mesh: &M) -> Self::Output {
        let Self { surface, levels, minima } = self;
        let traced = Traced::of(mesh, surface, levels)?;
        let extrema = if minima { Extrema::minima(mesh, surface)? } else { Extrema::default() };
        Ok((traced, extrema))
    }
}

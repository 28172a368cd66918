//! `onering region`: the stalactite that a point is on.

mod report;

use crate::args::Seed;
use crate::failure::Failure;
use crate::output::{self, Status};
use crate::surface::{self, Surface};
use crate::{args, on_backend};
use onering::region::{Region, StalactiteOptions, stalactite};
use onering::{Handle, Incidence, Map, NotFinite, critical, vector};
use onering_io::{Triangles, save};
use report::Report;
use std::io;
use std::time::Instant;

/// Finds the region of one mesh.
pub(crate) fn run(options: &args::Region) -> io::Result<Status> {
    match region(options) {
        Ok(text) => output::print(&text).map(|()| Status::Done),
        Err(failure) => failure.end(),
    }
}

/// What is to be printed. A file is written before: nothing is said of one that could not be.
fn region(options: &args::Region) -> Result<String, Failure> {
    let surface = &Surface::read(&options.mesh, surface::ROOF, options.up, options.unit.as_deref())?;
    let seed = options.at.map(|at| seed(surface, at)).transpose()?;
    let work = Work { surface, seed, options: StalactiteOptions { steep: options.steep } };
    let found = on_backend::run(&options.mesh.backend, &surface.mesh, work)??;
    if let Some(path) = &options.output {
        save(path, &found.part).map_err(|error| Failure::Output(error.to_string()))?;
    }
    let report = Report::new(&options.mesh.backend, surface, &found);
    if options.json {
        return Ok(report.json());
    }
    output::tell(&format!("found in {:.3} ms on {}", 1e3 * found.seconds, options.mesh.backend));
    Ok(report.text())
}

/// The vertex that is meant.
fn seed(surface: &Surface, at: Seed) -> Result<usize, Failure> {
    let count = surface.mesh.positions.len();
    match at {
        Seed::Vertex(v) if v < count => Ok(v),
        Seed::Vertex(v) => {
            let problem = format!("there is no vertex {v}: there are {count}, counted from 0");
            Err(Failure::Usage(format!("{}: {problem}", surface.name)))
        }
        Seed::Point(point) => nearest(surface, point).ok_or_else(|| nothing(surface)),
    }
}

/// The vertex nearest to the point, of those that faces have: nobody means one that is on no surface. Linear.
fn nearest(surface: &Surface, point: [f32; 3]) -> Option<usize> {
    let distance = |&v: &u32| {
        let offset = vector::minus(vector::of(surface.mesh.positions[v as usize]), vector::of(point));
        vector::dot(offset, offset)
    };
    let corners = surface.mesh.faces.as_flattened().iter();
    corners.min_by(|a, b| distance(a).total_cmp(&distance(b))).map(|&v| v as usize)
}

fn nothing(surface: &Surface) -> Failure {
    Failure::Output(format!("{}: it has no faces, and so no region", surface.name))
}

/// What was found.
struct Found {
    /// Where it started.
    seed: usize,
    /// The faces alone, with the vertices that they have.
    part: Triangles,
    area: f64,
    /// Least and largest coordinates.
    bounds: [[f32; 3]; 2],
    seconds: f64,
}

struct Work<'a> {
    surface: &'a Surface,
    seed: Option<usize>,
    options: StalactiteOptions,
}

impl on_backend::Work for Work<'_> {
    type Output = Result<Found, Failure>;

    fn on<M: Incidence>(self, mesh: &M) -> Self::Output {
        let Self { surface, seed, options } = self;
        let (positions, turned) = (surface.positions(), surface.turned());
        let not_finite = |error: NotFinite| surface.failure(&error);
        let seed = match seed {
            Some(v) => M::Vertex::new(v),
            None => lowest(mesh, &turned).map_err(not_finite)?.ok_or_else(|| nothing(surface))?,
        };
        let start = Instant::now();
        let region = stalactite(mesh, &turned, seed, options).map_err(not_finite)?;
        let seconds = start.elapsed().as_secs_f64();
        if region.faces().is_empty() {
            return Err(Failure::Output(format!("{}: no face has vertex {}", surface.name, seed.index())));
        }
        Ok(Found {
            seed: seed.index(),
            part: part(mesh, &region, &positions),
            area: region.area(mesh, &positions),
            bounds: region.bounding_box(&positions),
            seconds,
        })
    }
}

/// The lowest tip of a stalactite, or else the lowest vertex that has a face; `None` without faces.
fn lowest<M: Incidence>(mesh: &M, turned: &Map<M::Vertex, [f32; 3]>) -> Result<Option<M::Vertex>, NotFinite> {
    let lower = |a: &M::Vertex, b: &M::Vertex| turned[*a][2].total_cmp(&turned[*b][2]);
    let tip = critical::stalactite_tips(mesh, turned)?.into_iter().min_by(lower);
    Ok(tip.or_else(|| mesh.vertices().filter(|&v| mesh.outgoing(v).is_some()).min_by(lower)))
}

/// The faces of the region as a mesh of their own.
fn part<M: Incidence>(
    mesh: &M,
    region: &Region<M::Face, M::Vertex>,
    positions: &Map<M::Vertex, [f32; 3]>,
) -> Triangles {
    let number = |v| region.vertices().partition_point(|&other| other < v) as u32;
    let faces = region.faces().iter().map(|&f| mesh.face_vertices(f).map(number)).collect();
    Triangles::new(region.vertices().iter().map(|&v| positions[v]).collect(), faces)
}

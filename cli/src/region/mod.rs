//! `onering region`: the stalactite that a point is on.

mod report;

use crate::convert::Target;
use crate::failure::Failure;
use crate::made;
use crate::output::{self, Status};
use crate::surface::Surface;
use crate::{args, input, on_backend};
use onering::region::{StalactiteOptions, stalactite};
use onering::{Handle, Incidence, Map, NotFinite, critical, submesh};
use onering_io::{MeshRef, Triangles};
use report::Report;
use std::io;
use std::time::Instant;

/// Finds the region of one mesh.
pub(crate) fn run(options: &args::Region) -> io::Result<Status> {
    match region(options) {
        // Where the mesh went to standard output, no words go there.
        Ok(text) if options.output.as_deref().is_some_and(input::is_standard) => {
            output::tell(&text);
            Ok(Status::Done)
        }
        Ok(text) => output::print(&text).map(|()| Status::Done),
        Err(failure) => failure.end(),
    }
}

/// What is to be printed. A file is written before: nothing is said of one that could not be.
fn region(options: &args::Region) -> Result<String, Failure> {
    let in_ring = on_backend::in_ring(&options.structure.backend);
    let target = options.output.as_deref().map(|output| Target::new(output, options.to, in_ring, false));
    let target = target.transpose()?;
    let surface = &Surface::read(&options.mesh, made::ROOF, options.up, options.unit.as_deref())?;
    if surface.mesh.faces.is_empty() {
        return Err(nothing(surface));
    }
    let seed = options.at.map(|at| at.vertex(&surface.name, &surface.mesh)).transpose()?;
    let work = Work { surface, seed, options: StalactiteOptions { steep: options.steep } };
    let found = on_backend::run(&options.structure.backend, &surface.mesh, work)??;
    if let Some(target) = &target {
        target.write(MeshRef::from(&found.part))?;
    }
    let report = Report::new(&options.structure.backend, surface, &found);
    if options.json {
        return Ok(report.json());
    }
    output::tell(&format!("found in {:.3} ms on {}", 1e3 * found.seconds, options.structure.backend));
    Ok(report.text())
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
        let region = stalactite(mesh, &turned, seed, &options).map_err(not_finite)?;
        let seconds = start.elapsed().as_secs_f64();
        if region.faces().is_empty() {
            return Err(Failure::Output(format!("{}: no face has vertex {}", surface.name, seed.index())));
        }
        let part = submesh::submesh(mesh, region.faces().iter().copied());
        Ok(Found {
            seed: seed.index(),
            part: Triangles::new(part.carry_vertices(&surface.mesh.positions), part.faces),
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

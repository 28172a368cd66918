//! Table 7 of Figueiredo et al. (2014) for any structure: the time to load, to build, and of random queries.

mod measure;
mod report;
mod sample;

use super::graph;
use crate::args::{self, GRAPH};
use crate::failure::Failure;
use crate::input;
use crate::machine::Machine;
use crate::made;
use crate::on_backend::{self, Work};
use crate::timing::{Clock, Timing};
use measure::{AskedAll, Plan};
use onering::{Incidence, degrees};
use onering_io::Triangles;
use report::{Column, Report};
use sample::Sample;
use std::time::Duration;

/// Measures, and gives what to print.
pub(crate) fn text(options: &args::Query, mesh: &Triangles) -> Result<String, Failure> {
    if mesh.faces.is_empty() {
        return Err(Failure::Output("the mesh has no faces to ask about".into()));
    }
    let clock = Clock { budget: Duration::from_millis(options.budget), gives_up: false };
    let sample = Sample::of(&mesh.faces, options.random as usize, options.seed);
    let mut report = Report {
        version: env!("CARGO_PKG_VERSION"),
        machine: Machine::this(),
        mesh: options.file.as_deref().map_or("terrain (made here)".into(), input::name_of),
        vertices: mesh.positions.len(),
        triangles: mesh.faces.len(),
        queries: options.random,
        seed: options.seed,
        load: load(options, clock),
        degrees: degrees::degrees(&graph(mesh)?),
        columns: Vec::new(),
        refusals: Vec::new(),
    };
    let (names, may_refuse) = options.chosen();
    for name in names {
        match column(name, mesh, &sample, clock) {
            Ok(column) => report.columns.push(column),
            Err(Failure::Output(refusal)) if may_refuse => report.refusals.push(refusal),
            Err(failure) => return Err(failure),
        }
    }
    if options.json { report.json() } else { Ok(report.to_string()) }
}

/// The time to read the file, once more or several times; none where there is no file that can be read again.
fn load(options: &args::Query, clock: Clock) -> Option<Timing> {
    options.file.as_deref().filter(|file| !input::is_standard(file))?;
    let file = options.mesh_file();
    Some(clock.of_quadratic().time(|| on_backend::read(&file, made::terrain::mesh)))
}

/// Builds, and nothing else.
struct Build;

impl Work for Build {
    type Output = ();

    fn on<M: Incidence>(self, _: &M) {}
}

fn column(name: &str, mesh: &Triangles, sample: &Sample, clock: Clock) -> Result<Column, Failure> {
    let searches = name != GRAPH && on_backend::searches(name);
    let step = if searches { measure::SEARCHED } else { 1 };
    let plan = Plan { sample, clock: if searches { clock.of_quadratic() } else { clock }, step };
    let (asked, build) = if name == GRAPH {
        (plan.on_graph(&graph(mesh)?, &mesh.faces), clock.time(|| graph(mesh)))
    } else {
        (on_backend::run(name, mesh, plan)?, clock.time(|| on_backend::run(name, mesh, Build)))
    };
    Ok(Column { name: name.into(), build, asked, searches })
}

//! `onering compare --deform`: an organ is pressed in every structure, at five sizes.
//!
//! Two times are taken, the lines of Figs. 18 to 21 of Biscaro et al. (2016): of asking for the first ring of every
//! vertex, and of the whole deformation until the linear system has converged.

mod measure;
mod plot;
mod record;
mod table;

use super::open::{finish, open};
use super::subject::BASELINE;
use crate::failure::Failure;
use crate::machine::Machine;
use crate::on_backend::{self, SEARCHED};
use crate::output::{self, Status};
use crate::progress::Progress;
use crate::timing::Clock;
use crate::{args, made};
use measure::{Compared, Experiment};
use onering::registry::BACKENDS;
use onering_io::Triangles;
use record::{Line, Run, Size};
use std::io;
use std::time::Duration;

/// Vertices of the organ, about.
const SIZES: [usize; 5] = [200, 1_000, 5_000, 10_000, 20_000];

/// Measures, prints the table, and writes the JSON and the plot.
pub(crate) fn run(options: &args::Compare) -> io::Result<Status> {
    match compare(options) {
        Ok(status) => Ok(status),
        Err(failure) => failure.end(),
    }
}

fn compare(options: &args::Compare) -> Result<Status, Failure> {
    let [json, plot] = [open(options.json.as_deref())?, open(options.plot.as_deref())?];
    let run = measured(options)?;
    output::print(&table::of(&run)).map_err(Failure::Standard)?;
    run.mismatches.iter().for_each(|mismatch| output::complain(mismatch));
    let text = serde_json::to_string_pretty(&run).map_err(io::Error::from).map_err(Failure::Standard)?;
    finish(json, &(text + "\n"))?;
    finish(plot, &plot::of(&run))?;
    Ok(if run.mismatches.is_empty() { Status::Done } else { Status::Partly })
}

fn measured(options: &args::Compare) -> Result<Run, Failure> {
    let names = names(options);
    let progress = Progress::start(SIZES.len() * names.len());
    let mut run = Run {
        version: env!("CARGO_PKG_VERSION"),
        machine: Machine::this(),
        budget_ms: options.budget,
        quadratic_up_to_triangles: options.quadratic_up_to(),
        notes: table::NOTES,
        sizes: Vec::new(),
        lines: names.iter().map(|&name| Line { name: shown(name), points: Vec::new() }).collect(),
        mismatches: Vec::new(),
    };
    for vertices in SIZES {
        let mesh = made::organ::of_size(vertices);
        run.sizes.push(Size { vertices: mesh.positions.len(), triangles: mesh.faces.len() });
        let mut first = None;
        for (&name, line) in names.iter().zip(&mut run.lines) {
            let compared = progress.step(name, || one(name, &mesh, options))?;
            if let Some(compared) = &compared {
                let first: &Compared = first.get_or_insert_with(|| compared.clone());
                run.mismatches.extend(compared.mismatch(first, shown(name), mesh.positions.len()));
            }
            line.points.push(compared.map(|compared| compared.point));
        }
    }
    Ok(run)
}

/// One structure at one size; `None` where it would take too long.
fn one(name: &str, mesh: &Triangles, options: &args::Compare) -> Result<Option<Compared>, Failure> {
    if name == SEARCHED && mesh.faces.len() > options.quadratic_up_to() {
        return Ok(None);
    }
    let clock = Clock { budget: Duration::from_millis(options.budget), gives_up: name == SEARCHED };
    let compared = on_backend::run(name, mesh, Experiment { mesh, clock })?;
    compared.map(Some).map_err(|error| Failure::Output(format!("{name}: {error}")))
}

/// The structures that can start from a vertex, and none at all where all are asked for.
fn names(options: &args::Compare) -> Vec<&'static str> {
    let chosen = options.chosen().into_iter().filter_map(|i| BACKENDS.get(i));
    let with_rings = chosen.filter(|backend| backend.traits.contains(&"incidence"));
    let baseline = options.backends.is_empty().then_some(SEARCHED);
    baseline.into_iter().chain(with_rings.map(|backend| backend.name)).collect()
}

fn shown(name: &'static str) -> &'static str {
    if name == SEARCHED { BASELINE.name } else { name }
}

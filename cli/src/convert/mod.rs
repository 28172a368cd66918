//! `onering convert`: reads a mesh, mends it, writes it, and says what became of it.

mod attribute;
mod change;
mod fill_holes;
mod holds;
mod reorder;
pub(crate) mod ring;
mod summary;
mod target;

pub(crate) use attribute::Attribute;
pub(crate) use change::Change;
pub(crate) use holds::Holds;
pub(crate) use reorder::Method;
pub(crate) use target::Target;

use crate::failure::Failure;
use crate::output::{self, Status};
use crate::progress::Progress;
use crate::{args, input};
use attribute::Computed;
use onering_io::{Format, MeshRef, Options, Triangles};
use std::io;
use summary::Summary;

/// Reading, changing, attributes, writing.
const STEPS: usize = 4;

/// Converts one file.
pub(crate) fn run(options: &args::Convert) -> io::Result<Status> {
    match convert(options) {
        Ok(summary) => {
            if !options.quiet {
                output::tell(&summary.to_string());
            }
            Ok(Status::Done)
        }
        Err(failure) => failure.end(),
    }
}

/// All that can be known to fail before the work fails before the work.
fn convert(options: &args::Convert) -> Result<Summary, Failure> {
    let target = Target::of(options)?;
    let holds = Holds::of(target.format());
    attribute::check(&options.attributes, target.format(), &holds)?;
    let progress = Progress::start(STEPS);
    let (mut mesh, format) = progress.step("reading", || read(options))?;
    let mut summary = Summary::of(options, &mesh, format, &target);
    let change = progress.step("mending", || {
        let name = input::name_of(&options.input);
        let change = Change::apply(options.weld, options.repair, &name, &mut mesh)?;
        change.filled_and_reordered(options.fill_holes, options.reorder, &name, &mut mesh)
    })?;
    let computed = progress.step("computing attributes", || attribute::compute(options, &mesh))?;
    progress.step("writing", || write(&mesh, &computed, &target))?;
    summary.add_result(&mesh, &change, &holds);
    Ok(summary)
}

fn read(options: &args::Convert) -> Result<(Triangles, Format), Failure> {
    let path = &options.input;
    let mut how = Options::default();
    how.weld_stl = !options.keep_corners;
    input::mesh_of(path, options.input_format(), how).map_err(Failure::Input)
}

fn write(mesh: &Triangles, computed: &[Computed], target: &Target) -> Result<(), Failure> {
    let attributes: Vec<_> = computed.iter().map(Computed::as_attribute).collect();
    let mesh = MeshRef::from(mesh).with_vertex_attributes(&attributes);
    target.write(mesh)
}

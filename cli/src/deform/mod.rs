//! `onering deform`: presses a mesh of springs, and tells how long that takes.

mod fix;
mod place;
mod press;
mod report;
mod show;

pub(crate) use fix::farthest;
pub(crate) use press::{Load, sweep};

use crate::convert::{Holds, Target};
use crate::failure::Failure;
use crate::output::{self, Status};
use crate::progress::Progress;
use crate::{args, input, made, on_backend};
use onering_io::{Attribute, MeshRef, Replacement, Triangles, Values};
use press::{Press, Pressed};
use report::Report;
use std::io;

/// Reading, pressing, writing, drawing.
const STEPS: usize = 4;

/// Deforms one mesh.
pub(crate) fn run(options: &args::Deform) -> io::Result<Status> {
    match deform(options) {
        // Where the mesh went to standard output, no words go there.
        Ok(text) if options.output.as_deref().is_some_and(input::is_standard) => {
            output::tell(&text);
            Ok(Status::Done)
        }
        Ok(text) => output::print(&text).map(|()| Status::Done),
        Err(failure) => failure.end(),
    }
}

/// All that can be known to fail before the work fails before the work.
fn deform(options: &args::Deform) -> Result<String, Failure> {
    let target =
        options.output.as_deref().map(|output| Target::new(output, options.to, ring(options), false));
    let target = target.transpose()?;
    let png = options.png.as_deref().map(|path| {
        let name = path.display().to_string();
        let opened = Replacement::create(path);
        opened.map(|file| (file, name.clone())).map_err(|error| Failure::Output(format!("{name}: {error}")))
    });
    let png = png.transpose()?;
    let progress = Progress::start(STEPS);
    let mesh = progress.step("reading", || on_backend::read(&options.mesh, made::organ::mesh))?;
    let name = options.mesh.file.as_deref().map_or("an organ (made here)".into(), input::name_of);
    place::check(&name, &mesh)?;
    let at = place::of(options.at, &mesh)?;
    let normal = place::normal(&mesh, at);
    let axes = png.is_some().then(|| show::axes(options, normal)).transpose()?;
    let press = Press::of(options, &mesh, at, normal);
    let pressed = progress.step("pressing", || {
        let pressed = on_backend::run(&options.mesh.backend, &mesh, press)?;
        pressed.map_err(|error| failed(&name, &error))
    })?;
    let mut report = Report::of(options, name, &mesh, at, &pressed);
    if let Some(target) = &target {
        progress.step("writing", || write(&mesh, &pressed, target))?;
        report.wrote(target.name(), Holds::of(target.format()).attributes);
    }
    if let (Some((file, name)), Some(axes)) = (png, axes) {
        progress.step("drawing", || show::draw(options, &mesh, &pressed, &axes, file, &name))?;
        report.drew(name);
    }
    Ok(if options.json { report.json() } else { report.to_string() })
}

/// Whose arrays go into a `.ring` file: no structure at all has none.
fn ring(options: &args::Deform) -> &str {
    match options.mesh.backend.as_str() {
        on_backend::SEARCHED => on_backend::DEFAULT,
        name => name,
    }
}

fn failed(name: &str, error: &press::Error) -> Failure {
    match error {
        press::Error::Fix(problem) => Failure::Usage(problem.clone()),
        _ => Failure::Output(format!("{name}: {error}")),
    }
}

fn write(mesh: &Triangles, pressed: &Pressed, target: &Target) -> Result<(), Failure> {
    let lengths = pressed.lengths();
    let attributes = [Attribute { name: "displacement", values: Values::Scalars(&lengths) }];
    let mut moved = MeshRef::from(mesh).with_vertex_attributes(&attributes);
    moved.positions = &pressed.positions;
    target.write(moved)
}

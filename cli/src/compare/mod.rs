//! `onering compare`: every backend on every mesh.

pub(crate) mod case;
mod deform;
mod fill;
mod growth;
mod html;
mod kernels;
pub(crate) mod measure;
mod open;
mod orders;
pub(crate) mod question;
mod record;
mod reference;
mod renumbered;
mod report;
mod rings;
mod row;
pub(crate) mod sample;
pub(crate) mod subject;

use crate::args;
use crate::default_mesh;
use crate::machine::Machine;
use crate::output::{self, Status};
use case::{Case, Wanted};
use indicatif::{ProgressBar, ProgressStyle};
use onering_io::one_line;
use open::{Open, finish, open};
use record::{Mesh, Run, Settings, Unread};
use row::Rows;
use std::io;
use std::path::Path;

/// Measures, prints a report for each mesh as soon as it is done, and writes the JSON at the end.
pub(crate) fn run(options: &args::Compare) -> io::Result<Status> {
    if options.deform {
        return deform::run(options);
    }
    let (json, html) = match (open(options.json.as_deref()), open(options.html.as_deref())) {
        (Ok(json), Ok(html)) => (json, html),
        (Err(failure), _) | (_, Err(failure)) => return failure.end(),
    };
    let mut run = Comparison::new(options);
    output::print(&report::head(&run.run))?;
    if options.files.is_empty() {
        for (name, made) in default_mesh::all() {
            run.compare(name.to_owned(), &made.positions, made.faces)?;
        }
    }
    for file in &options.files {
        run.compare_file(file)?;
    }
    if html.is_some() {
        run.grow();
    }
    run.finish(json, html)
}

struct Comparison<'a> {
    options: &'a args::Compare,
    chosen: Vec<usize>,
    bar: ProgressBar,
    run: Run,
}

impl<'a> Comparison<'a> {
    fn new(options: &'a args::Compare) -> Self {
        let chosen = options.chosen();
        let settings = Settings {
            seed: options.seed,
            budget_ms: options.budget,
            quadratic_up_to_triangles: options.quadratic_up_to(),
            ring_starts: sample::STARTS,
            random_queries: sample::QUERIES,
        };
        let meshes = if options.files.is_empty() { default_mesh::all().len() } else { options.files.len() };
        let run = Run {
            version: env!("CARGO_PKG_VERSION"),
            command: command(),
            date: jiff::Timestamp::now().strftime("%Y-%m-%d %H:%M UTC").to_string(),
            machine: Machine::this(),
            settings,
            notes: report::NOTES,
            meshes: Vec::new(),
            growth: None,
            unread: Vec::new(),
        };
        Self { options, bar: progress(meshes * chosen.len()), chosen, run }
    }

    fn compare_file(&mut self, file: &Path) -> io::Result<()> {
        match onering_io::load(file) {
            Ok(mesh) => self.compare(file.display().to_string(), &mesh.positions, mesh.faces),
            Err(error) => {
                self.give_up(file.display().to_string(), error.to_string());
                Ok(())
            }
        }
    }

    fn compare(&mut self, name: String, positions: &[[f32; 3]], faces: Vec<[u32; 3]>) -> io::Result<()> {
        if faces.is_empty() {
            return self.show(fill::without_faces(name, positions.len()));
        }
        let wanted = Wanted { seed: self.options.seed, comparison: true };
        match Case::of(name.clone(), positions, faces, wanted) {
            Err(error) => {
                self.give_up(name.clone(), format!("{name}: {error}"));
                Ok(())
            }
            Ok(case) => self.show(self.measure(&case)),
        }
    }

    fn show(&mut self, mesh: Mesh) -> io::Result<()> {
        let text = report::mesh(&mesh, self.options);
        self.bar.suspend(|| output::print(&text))?;
        for mismatch in &mesh.mismatches {
            output::complain(&format!("{}: {mismatch}", mesh.name));
        }
        self.run.meshes.push(mesh);
        Ok(())
    }

    fn measure(&self, case: &Case) -> Mesh {
        let mut rows = Rows::new(case, self.options);
        let name = one_line(&case.name);
        for &i in &self.chosen {
            self.bar.set_message(format!("{} on {name}", subject::SUBJECTS[i].name));
            rows.measure(i);
            self.bar.inc(1);
        }
        if self.options.backends.is_empty() {
            rows.measure_baseline();
        }
        rows.into_mesh()
    }

    fn give_up(&mut self, file: String, error: String) {
        self.bar.inc(self.chosen.len() as u64);
        self.bar.suspend(|| output::complain(&error));
        self.run.unread.push(Unread { file, error });
    }

    fn grow(&mut self) {
        self.bar.set_message("spheres of growing size");
        self.run.growth = Some(growth::measured(self.options, &self.chosen));
    }

    fn finish(self, json: Open<'_>, html: Open<'_>) -> io::Result<Status> {
        self.bar.finish_and_clear();
        let Run { meshes, unread, .. } = &self.run;
        let mut status = Status::of(meshes.len(), unread.len());
        if meshes.iter().any(|mesh| !mesh.mismatches.is_empty()) {
            status = Status::Partly;
        }
        let page = if html.is_some() { html::page(&self.run) } else { String::new() };
        let text = serde_json::to_string_pretty(&self.run)? + "\n";
        for written in [finish(json, &text), finish(html, &page)] {
            if let Err(failure) = written {
                status = failure.end()?;
            }
        }
        Ok(status)
    }
}

/// As it could be said again.
fn command() -> String {
    let words = std::env::args_os().skip(1).map(|word| one_line(&word.to_string_lossy()));
    std::iter::once("onering".to_owned()).chain(words).collect::<Vec<_>>().join(" ")
}

/// On standard error, and only where that is a terminal.
pub(crate) fn progress(steps: usize) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:30} {pos}/{len} {msg}");
    let bar = ProgressBar::new(steps as u64);
    if let Ok(style) = style { bar.with_style(style) } else { bar }
}

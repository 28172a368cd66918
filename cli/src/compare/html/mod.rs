//! `onering compare --html`: everything that was measured on one page, which needs nothing but itself.

mod axis;
mod dots;
mod figure;
mod growth;
mod labels;
mod lines;
mod mesh;
mod scatter;
mod table;

use super::record::{Mesh, Named, Run};
use super::subject::SUBJECTS;
use figure::grouped;
use maud::{DOCTYPE, Markup, PreEscaped, html};
use onering_io::one_line;
use table::Table;

/// A picture, what it says, and the figures that it is made of.
struct Plot {
    title: String,
    svg: String,
    note: String,
    table: Table,
}

/// The page, in HTML.
pub(super) fn page(run: &Run) -> String {
    let title = "onering compare: which structure for which mesh";
    let style = format!("{}{}", include_str!("style.css"), figure::classes());
    let page = html! {
        (DOCTYPE)
        html lang="en" {
            head {
                meta charset="utf-8";
                meta name="viewport" content="width=device-width, initial-scale=1";
                meta name="color-scheme" content="light dark";
                title { (title) }
                style { (PreEscaped(style)) }
            }
            body { main { (head(run)) (contents(run)) (sections(run)) (notes(run)) } }
        }
    };
    page.into_string() + "\n"
}

/// The place of a structure among all, for it to look the same in every plot.
fn place(name: &str) -> usize {
    SUBJECTS.iter().position(|subject| subject.name == name).unwrap_or(SUBJECTS.len())
}

fn head(run: &Run) -> Markup {
    let settings = &run.settings;
    html! {
        h1 { "Which structure for which mesh" }
        dl {
            dt { "made by" } dd { code { (run.command) } }
            dt { "version" } dd { "onering " (run.version) }
            dt { "machine" } dd { (run.machine) }
            dt { "date" } dd { (run.date) }
            dt { "settings" }
            dd { "seed " (settings.seed) ", " (settings.budget_ms) " ms for each figure, quadratic up to "
                 (grouped(settings.quadratic_up_to_triangles)) " triangles" }
        }
        @for unread in &run.unread { p.differ { (one_line(&unread.error)) } }
    }
}

fn contents(run: &Run) -> Markup {
    html! {
        nav aria-label="Contents" {
            ul {
                @for (i, mesh) in run.meshes.iter().enumerate() { li { a href=(format!("#mesh-{i}")) { (one_line(&mesh.name)) } } }
                @if run.growth.is_some() { li { a href="#growth" { "Time against size" } } }
                li { a href="#notes" { "How to read the figures" } }
            }
        }
    }
}

fn sections(run: &Run) -> Markup {
    html! {
        @for (i, mesh) in run.meshes.iter().enumerate() { (section(&format!("mesh-{i}"), mesh)) }
        @if let Some(growth) = &run.growth {
            section #growth {
                h2 { "Time against size" }
                @for plot in growth::plots(growth) { (plot.markup()) }
            }
        }
    }
}

/// What the figures are.
fn notes(run: &Run) -> Markup {
    html! {
        section #notes {
            h2 { "How to read the figures" }
            p {
                "In the tables each time is a median; after it are the shortest run, and what three of four runs stayed \
                 within. Lines across the marks of plots are from the one to the other."
            }
            @for note in run.notes { p { (prose(note)) } }
        }
    }
}

/// What is between backquotes is code.
fn prose(words: &str) -> Markup {
    html! {
        @for (i, part) in words.split('`').enumerate() { @if i % 2 == 1 { code { (part) } } @else { (part) } }
    }
}

fn section(id: &str, mesh: &Mesh) -> Markup {
    let name = |plot: &str| format!("{id}-{plot}");
    html! {
        section id=(id) {
            h2 { (one_line(&mesh.name)) }
            p {
                (grouped(mesh.vertices)) " vertices, " (grouped(mesh.edges)) " edges, " (grouped(mesh.triangles))
                " triangles; " (mesh.defects) "."
                @if let Some(repair) = &mesh.repair {
                    " Repaired for structures that cannot hold this: " (repair.steps) "; then "
                    (grouped(repair.vertices)) " vertices and " (grouped(repair.triangles)) " triangles."
                }
            }
            @if !mesh.backends.is_empty() {
                p { "Half-edges are paired by " (choices(&mesh.auto_pairing)) ", where nobody chooses." }
                (mesh::memory(&name("memory"), mesh).markup())
                (mesh::build(&name("build"), mesh).markup())
                (mesh::rings(&name("rings"), mesh).markup())
                (mesh::orders(&name("orders"), mesh).markup())
                h3 { "Random queries" }
                (mesh::queries(mesh).markup())
                (answers(mesh))
            }
        }
    }
}

fn choices(choices: &Named<String>) -> String {
    let each = choices.0.iter().map(|(order, strategy)| format!("{strategy} ({order})"));
    each.collect::<Vec<_>>().join(", ")
}

/// Whether the structures agree, and why some were given the repaired mesh.
fn answers(mesh: &Mesh) -> Markup {
    html! {
        @if mesh.mismatches.is_empty() { p { "All answers agree." } }
        @for mismatch in &mesh.mismatches { p.differ { (mismatch) } }
        @for row in &mesh.backends {
            @if let Some(refusal) = &row.refusal { p.note { (row.name) ", " (row.mesh) ": " (refusal) } }
        }
    }
}

impl Plot {
    fn markup(&self) -> Markup {
        html! {
            h3 { (self.title) }
            figure {
                div.scroll tabindex="0" role="region" aria-label=(self.title) { (PreEscaped(&self.svg)) }
                figcaption { (self.note) }
            }
            (self.table.markup())
        }
    }
}

//! `onering query`: what is around an element, and how long it takes to ask.

mod answer;
mod element;
mod print;
mod random;
mod relation;

pub(crate) use element::Id;
pub(crate) use relation::Relation;

use crate::args::{self, GRAPH};
use crate::failure::Failure;
use crate::made;
use crate::on_backend;
use crate::output::{self, Status};
use answer::Ask;
use element::{EdgeNumbers, Element};
use onering::{FromFaces, VertexGraph};
use onering_io::Triangles;
use std::io;

/// Answers, or measures.
pub(crate) fn run(options: &args::Query) -> io::Result<Status> {
    match text(options) {
        Ok(text) => output::print(&text).map(|()| Status::Done),
        Err(failure) => failure.end(),
    }
}

fn text(options: &args::Query) -> Result<String, Failure> {
    let mesh = on_backend::read(&options.mesh_file(), made::terrain::mesh)?;
    match options.relation {
        Some(relation) => answers(options, relation, &mesh),
        None => random::text(options, &mesh),
    }
}

fn answers(options: &args::Query, relation: Relation, mesh: &Triangles) -> Result<String, Failure> {
    let by_number =
        relation.of() == relation::Kind::Edge && options.ids.iter().any(|id| matches!(id, Id::Number(_)));
    let needs_numbers = by_number || options.json && relation.is_about_edges();
    let edges = needs_numbers.then(|| EdgeNumbers::of(&mesh.faces));
    let find = |&id| Element::find(relation.of(), id, mesh, edges.as_ref()).map_err(Failure::Usage);
    let of = options.ids.iter().map(find).collect::<Result<Vec<_>, _>>()?;
    let (names, _) = options.chosen();
    let name = names[0];
    let results = ask(name, mesh, Ask { relation, of: &of })?;
    let line = |(&of, results): (&Element, &Vec<Element>)| match options.json {
        false => Ok(print::line(relation, of, results)),
        true => print::json(name, relation, (of, results), mesh, edges.as_ref()),
    };
    let lines = of.iter().zip(&results).map(line).collect::<Result<String, _>>();
    lines.map_err(|error| Failure::Output(error.to_string()))
}

fn ask(name: &str, mesh: &Triangles, ask: Ask<'_>) -> Result<Vec<Vec<Element>>, Failure> {
    if name != GRAPH {
        return on_backend::run(name, mesh, ask);
    }
    if ask.relation.in_toptri().is_none() {
        let relation = ask.relation.name();
        return Err(Failure::Usage(format!("{GRAPH} has the six queries of TopTri, and not {relation}")));
    }
    Ok(ask.on_graph(&graph(mesh)?, &mesh.faces))
}

/// The bare graph of a mesh.
fn graph(mesh: &Triangles) -> Result<VertexGraph, Failure> {
    let refused = |error| Failure::Output(format!("{GRAPH} cannot hold the mesh: {error}"));
    VertexGraph::from_faces(mesh.positions.len(), &mesh.faces).map_err(refused)
}

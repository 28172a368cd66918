//! The report for people to read: four tables for each mesh.

use super::orders::{GIVEN, REORDERED, SHUFFLED};
use super::record::{Backend, InOrder, Mesh, Named, Run};
use super::rings::LEVELS;
use super::row::{AS_IT_IS, REPAIRED};
use super::sample::{QUERIES, STARTS};
use super::subject::BASELINE;
use crate::args;
use crate::tables::{cell, scaled, table, wrapped};
use comfy_table::Table;
use onering::Pairing;
use onering_io::one_line;
use std::fmt::Write;

/// How to read the figures.
pub(crate) const NOTES: &[&str] = &[
    "Bytes are of topology alone: no positions. Formula: V vertices, E edges, T triangles, B boundary curves. \
     Counted: what the heap holds more once it is built. Peak: the most that it held more meanwhile. The list of \
     triangles it is built from is borrowed and in neither.",
    "Times are medians of at least three runs, after one to warm up. `*` is a single run, the first: of what is \
     quadratic and takes over eight budgets (--budget), or of everything where the budget is 0. Build: from a list of triangles in memory, by how \
     half-edges are paired; without hash is the quadratic search, paper hash is Eq. (7), both of Biscaro et al. \
     (2016), Tables 3 and 4; auto is what the library takes.",
    "Rings: all vertices within so many edges of one vertex, from random vertices, with scratch that is kept \
     (Fig. 16, Table 5). Sweep: the one-ring of every vertex. Vertex queries: the one-rings of random vertices. \
     Face queries: the three faces across the edges of random faces. A bare graph gives all neighbours as the \
     one-ring.",
    "Orders: building as the library does it of its own accord, and the sweep, with vertices and faces as they come, \
     shuffled, and that reordered along a Morton curve by position. Shuffled meshes may take very long, so that they \
     count as quadratic does. `sot` and `compact-stars` number vertices and faces anew: they are asked about the same elements by \
     their maps.",
    "All answers are compared by checksums, between backends and with the list of triangles. `-` is what a backend \
     cannot answer, or what was left out, as said under the table.",
];

/// Says what runs where, before it runs.
pub(crate) fn head(run: &Run) -> String {
    let mut text = format!("onering {} on {}\n", run.version, run.machine);
    let _ = writeln!(
        text,
        "seed {}: {STARTS} random vertices for rings, {QUERIES} random queries of each kind",
        run.settings.seed
    );
    NOTES.iter().for_each(|note| text += &format!("{}\n", wrapped(note)));
    text
}

/// Everything about one mesh.
pub(crate) fn mesh(mesh: &Mesh, options: &args::Compare) -> String {
    let Mesh { vertices, triangles, edges, defects, repair, .. } = mesh;
    let name = one_line(&mesh.name);
    let mut text =
        format!("\n{name}: {vertices} vertices, {edges} edges, {triangles} triangles; {defects}\n");
    if let Some(repair) = repair {
        let _ = writeln!(
            text,
            "repaired for backends that cannot hold this: {}; then {} vertices, {} edges, {} triangles",
            repair.steps, repair.vertices, repair.edges, repair.triangles
        );
    }
    if mesh.backends.is_empty() {
        return text;
    }
    text += &choices(&mesh.auto_pairing, AS_IT_IS);
    text += &repair.as_ref().map_or_else(String::new, |repair| choices(&repair.auto_pairing, REPAIRED));
    for table in [memory(mesh), builds(mesh), queries(mesh), orders(mesh)] {
        // The rule below one table is the rule above the next.
        text += table.to_string().rsplit_once('\n').map_or("", |(lines, _)| lines);
        text.push('\n');
    }
    text + &announcements(mesh, options)
}

fn memory(mesh: &Mesh) -> Table {
    let header = ["Bytes a triangle", "mesh", "formula", "=", "counted", "peak"];
    let mut table = table(&header, 3);
    for row in &mesh.backends {
        if let Some(memory) = &row.memory {
            let bytes = [
                memory.formula_bytes_per_triangle,
                Some(memory.counted_bytes_per_triangle),
                Some(memory.peak_bytes_per_triangle),
            ];
            let bytes = bytes.map(|bytes| bytes.map_or("-".into(), |bytes| format!("{bytes:.2}")));
            let words = [row.name, row.mesh, &memory.formula].map(str::to_owned);
            table.add_row(words.into_iter().chain(bytes));
        }
    }
    table
}

/// Which strategy `auto` is.
fn choices(choices: &Named<String>, state: &str) -> String {
    let each: Vec<String> =
        choices.0.iter().map(|(order, strategy)| format!("{strategy} where {order}")).collect();
    format!("auto on the mesh {state}: {}\n", each.join(", "))
}

fn builds(mesh: &Mesh) -> Table {
    let strategies = std::iter::once(Pairing::Auto).chain(Pairing::ALL).map(in_words);
    let header: Vec<String> = ["Build, ms", "mesh"].map(String::from).into_iter().chain(strategies).collect();
    let mut table = table(&header.iter().map(String::as_str).collect::<Vec<_>>(), 2);
    for row in mesh.backends.iter().filter(|row| !row.build.0.is_empty()) {
        let times = row.build.0.iter().map(|&(_, timing)| scaled(timing, 1e6));
        table.add_row([row.name, row.mesh].map(str::to_owned).into_iter().chain(times));
    }
    table
}

/// A strategy as the paper calls it, where it is of the paper.
pub(crate) fn in_words(pairing: Pairing) -> String {
    match pairing {
        Pairing::Quadratic => "without hash".into(),
        other => other.to_string().replace('-', " "),
    }
}

fn orders(mesh: &Mesh) -> Table {
    let header: Vec<String> = ["build, ms", "sweep, ns/vertex"]
        .iter()
        .flat_map(|what| [GIVEN, SHUFFLED, REORDERED].map(|order| format!("{what}\n{order}")))
        .collect();
    let header: Vec<&str> = ["Orders", "mesh"].into_iter().chain(header.iter().map(String::as_str)).collect();
    let mut table = table(&header, 2);
    for row in mesh.backends.iter().filter(|row| row.memory.is_some()) {
        let orders = in_orders(row);
        let builds = orders.map(|order| scaled(order.map(|order| order.build), 1e6));
        let sweeps = orders.map(|order| {
            let sweep = order.and_then(|order| order.sweep);
            sweep.map_or("-".into(), |sweep| cell(sweep.ns_per_vertex, sweep.timing))
        });
        table.add_row([row.name, row.mesh].map(str::to_owned).into_iter().chain(builds).chain(sweeps));
    }
    table
}

/// What was found in the order that was given, shuffled and reordered.
pub(crate) fn in_orders(row: &Backend) -> [Option<InOrder>; 3] {
    let build = row.build.0.first().and_then(|&(_, auto)| auto);
    let other = |name| row.orders.0.iter().find(|(order, _)| order == name).and_then(|&(_, found)| found);
    [build.map(|build| InOrder { build, sweep: row.sweep }), other(SHUFFLED), other(REORDERED)]
}

fn queries(mesh: &Mesh) -> Table {
    let rings: [String; LEVELS] = std::array::from_fn(|k| format!("{}-ring,\nus", k + 1));
    let mut header = vec!["Queries", "mesh"];
    header.extend(rings.iter().map(String::as_str));
    header.extend(["sweep,\nns/vertex", "vertex\nqueries, ms", "face\nqueries, ms"]);
    let mut table = table(&header, 2);
    for state in [AS_IT_IS, REPAIRED] {
        table.add_rows(vertices_in_rings(mesh, state));
    }
    for row in &mesh.backends {
        let mut cells = vec![row.name.to_owned(), row.mesh.to_owned()];
        cells.extend((0..LEVELS).map(|k| scaled(row.rings.get(k).map(|ring| ring.timing), 1e3)));
        let sweep = row.sweep.as_ref();
        cells.push(sweep.map_or("-".into(), |sweep| cell(sweep.ns_per_vertex, sweep.timing)));
        cells.extend([row.random_vertex_queries, row.random_face_queries].map(|timing| scaled(timing, 1e6)));
        table.add_row(cells);
    }
    table
}

/// How many vertices the rings have, on average, in a state of the mesh that some backend was measured in.
fn vertices_in_rings(mesh: &Mesh, state: &str) -> Option<Vec<String>> {
    let row = mesh.backends.iter().find(|row| row.mesh == state && !row.rings.is_empty())?;
    let counts = row.rings.iter().map(|ring| format!("({:.0})", ring.vertices));
    let words = ["(vertices)", state].map(str::to_owned);
    Some(words.into_iter().chain(counts).chain([(); 3].map(|()| String::new())).collect())
}

fn announcements(mesh: &Mesh, options: &args::Compare) -> String {
    let mut text = String::new();
    let left_out = left_out(mesh, options);
    if !left_out.is_empty() {
        let limit = options.quadratic_up_to();
        let _ = writeln!(
            text,
            "left out above {limit} triangles (--quadratic-up-to): {}",
            left_out.join(", and ")
        );
    }
    if mesh.backends.iter().any(|row| row.name == BASELINE.name) {
        text += "`no data structure` searches all faces; of its random queries one in 100 is timed\n";
    } else if options.backends.is_empty() && left_out.is_empty() {
        text += "left out for vertices of very many faces: `no data structure`\n";
    }
    for row in mesh.backends.iter().filter(leaves_out) {
        let what = if row.sweep.is_none() { "all questions to" } else { "what lies across edges in" };
        let _ = writeln!(text, "left out for vertices of very many faces: {what} {}", row.name);
    }
    for row in &mesh.backends {
        if let Some(refusal) = &row.refusal {
            let _ = writeln!(text, "{} {}: {refusal}", row.name, row.mesh);
        }
    }
    match mesh.mismatches.len() {
        0 => text += "checksums: all answers agree\n",
        n => {
            let _ = writeln!(text, "checksums: {n} answers DIFFER");
            mesh.mismatches.iter().for_each(|mismatch| text += &format!("  {mismatch}\n"));
        }
    }
    text
}

/// Whether it was built, and could tell what lies across an edge, but not in a time that anyone waits for.
fn leaves_out(row: &&Backend) -> bool {
    row.memory.is_some() && row.traits.contains(&"adjacency") && row.random_face_queries.is_none()
}

/// What was asked for and is quadratic, where the mesh is too large for that.
fn left_out(mesh: &Mesh, options: &args::Compare) -> Vec<&'static str> {
    if mesh.triangles <= options.quadratic_up_to() {
        return Vec::new();
    }
    // `auto` and at least one strategy.
    let pairs = |row: &Backend| row.build.0.iter().filter(|(_, timing)| timing.is_some()).count() > 1;
    let building = mesh.backends.iter().any(pairs).then_some("building without hash");
    building.into_iter().chain(options.backends.is_empty().then_some("`no data structure`")).collect()
}

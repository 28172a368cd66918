//! The plots of one mesh, each with its table.

use super::axis::Axis;
use super::figure;
use super::table::{Cell, Table};
use super::{Plot, dots, lines, place, scatter};
use crate::compare::orders::{GIVEN, REORDERED, SHUFFLED};
use crate::compare::record::{Backend, Mesh, Sweep};
use crate::compare::report::{in_orders, in_words};
use crate::compare::rings::LEVELS;
use crate::compare::subject::all_known;
use crate::timing::Timing;
use onering::Pairing;

/// Nanoseconds.
const MICROSECOND: f64 = 1e3;
const MILLISECOND: f64 = 1e6;

/// The time for one vertex, with its spread.
pub(super) fn each(sweep: &Sweep) -> Timing {
    sweep.timing.scaled(sweep.ns_per_vertex / sweep.timing.median_ns.max(1e-9))
}

fn words(words: &[&str]) -> Vec<String> {
    words.iter().map(|&word| word.to_owned()).collect()
}

/// What to pick, in one picture.
pub(super) fn memory(id: &str, mesh: &Mesh) -> Plot {
    let points: Vec<scatter::Point<'_>> = mesh.backends.iter().filter_map(point).collect();
    let description = description(&points);
    let title = "Memory against ring time";
    let words = [title, &description, "bytes a triangle", "one-ring, ns a vertex"];
    let svg = scatter::draw(id, words, &points);
    let without = mesh.backends.iter().filter(|row| row.memory.is_some() && row.sweep.is_none());
    let without: Vec<&str> = without.map(|row| row.name).collect();
    let note = if without.is_empty() {
        description
    } else {
        format!("{description} Not in the plot, for they cannot start from a vertex: {}.", without.join(", "))
    };
    Plot { title: title.into(), svg, note, table: bytes(mesh) }
}

/// Where a structure is in the plot; `None` where it cannot start from a vertex.
fn point(row: &Backend) -> Option<scatter::Point<'_>> {
    let (memory, time) = (row.memory.as_ref()?, each(row.sweep.as_ref()?));
    Some(scatter::Point {
        name: row.name,
        x: memory.counted_bytes_per_triangle,
        y: time.median_ns,
        spread: [time.min_ns, time.quartile_ns],
        is_mesh: row.traits.contains(&"topology"),
    })
}

fn description(points: &[scatter::Point<'_>]) -> String {
    let front: Vec<&str> = scatter::front(points).into_iter().map(|i| points[i].name).collect();
    let renumbering: Vec<&str> =
        all_known().filter(|known| known.renumbers).map(|known| known.name).collect();
    format!(
        "Left and low is better. On the line, filled: {}. No structure with faces beats these in both memory and time. The \
         mark with three corners is a bare graph, which knows neighbours and no faces. {} give vertices and faces other \
         numbers. What lies across an edge is another question, of which the random queries below tell.",
        front.join(", "),
        renumbering.join(" and ")
    )
}

/// The figures of the plot, and what they are made of.
fn bytes(mesh: &Mesh) -> Table {
    let row = |row: &Backend| {
        let memory = row.memory.as_ref()?;
        let bytes = [
            Some(memory.counted_bytes_per_triangle),
            Some(memory.peak_bytes_per_triangle),
            memory.formula_bytes_per_triangle,
        ];
        let time = Cell::Time(row.sweep.as_ref().map(each), 1.0);
        // Figures first, for narrow screens.
        let figures = [time].into_iter().chain(bytes.map(Cell::Number));
        let words = [memory.formula.clone(), row.traits.join(", "), row.mesh.to_owned()].map(Cell::Words);
        Some((row.name.to_owned(), figures.chain(words).collect()))
    };
    let header = ["structure", "one-ring", "counted", "peak", "by formula", "formula", "traits", "mesh"];
    Table {
        caption:
            "One-rings in ns a vertex; bytes a triangle, as counted, at the peak of building and by formula"
                .into(),
        header: words(&header),
        rows: mesh.backends.iter().filter_map(row).collect(),
    }
}

/// By how half-edges are paired.
pub(super) fn build(id: &str, mesh: &Mesh) -> Plot {
    let strategies: Vec<String> = std::iter::once(Pairing::Auto).chain(Pairing::ALL).map(in_words).collect();
    let rows = || mesh.backends.iter().filter(|row| !row.build.0.is_empty());
    let marks: Vec<dots::Row<'_>> = rows()
        .map(|row| dots::Row { name: row.name, values: row.build.0.iter().map(|&(_, t)| t).collect() })
        .collect();
    let note = "Left is better. A ring is what the library takes of its own accord. Structures without opposites pair \
                nothing, and are built in one way only.";
    let row = |row: &Backend| {
        let times = row.build.0.iter().map(|&(_, timing)| Cell::Time(timing, MILLISECOND));
        (row.name.to_owned(), std::iter::once(Cell::Words(row.mesh.into())).chain(times).collect())
    };
    Plot {
        title: "Build time by pairing strategy".into(),
        svg: dots::draw(
            id,
            ["Build time by pairing strategy", note, "build, ms"],
            MILLISECOND,
            &strategies,
            &marks,
        ),
        note: note.into(),
        table: Table {
            caption: "Build, ms".into(),
            header: words(&["structure", "mesh"]).into_iter().chain(strategies).collect(),
            rows: rows().map(row).collect(),
        },
    }
}

/// Fig. 16 of Biscaro et al. (2016).
pub(super) fn rings(id: &str, mesh: &Mesh) -> Plot {
    let rows = || mesh.backends.iter().filter(|row| !row.rings.is_empty());
    let line = |row: &'_ Backend| {
        row.rings.iter().map(|ring| (ring.level as f64, ring.timing.median_ns / MICROSECOND)).collect()
    };
    // Searching all faces takes so long that all the others would be one line.
    let drawn = rows().filter(|row| row.memory.is_some());
    let all: Vec<lines::Line<'_>> =
        drawn.map(|row| lines::Line { name: row.name, place: place(row.name), points: line(row) }).collect();
    let vertices: Vec<String> = rows()
        .next()
        .map(|row| row.rings.iter().map(|ring| format!("{:.0}", ring.vertices)).collect())
        .unwrap_or_default();
    let note = format!(
        "Low is better. All vertices within so many edges of a random vertex; on average there are {}.",
        vertices.join(", ")
    );
    let row = |row: &Backend| {
        let times = row.rings.iter().map(|ring| Cell::Time(Some(ring.timing), MICROSECOND));
        (row.name.to_owned(), std::iter::once(Cell::Words(row.mesh.into())).chain(times).collect())
    };
    let levels = (1..=LEVELS).map(|level| format!("{level}-ring"));
    Plot {
        title: "Ring time by level".into(),
        svg: lines::draw(
            id,
            ["Ring time by level", &note, "rings", "rings of one vertex, µs"],
            Axis::Linear(0.8, LEVELS as f64 + 0.2),
            &all,
        ),
        note,
        table: Table {
            caption: "Rings of one vertex, µs".into(),
            header: words(&["structure", "mesh"]).into_iter().chain(levels).collect(),
            rows: rows().map(row).collect(),
        },
    }
}

/// As it came, shuffled, and in order again.
pub(super) fn orders(id: &str, mesh: &Mesh) -> Plot {
    let names = [GIVEN, SHUFFLED, REORDERED];
    let rows = || mesh.backends.iter().filter(|row| row.memory.is_some());
    let sweeps = |row: &Backend| in_orders(row).map(|order| order?.sweep.as_ref().map(each));
    let marks: Vec<dots::Row<'_>> = rows()
        .filter(|row| row.sweep.is_some())
        .map(|row| dots::Row { name: row.name, values: sweeps(row).into() })
        .collect();
    let note = "Left is better. The same mesh as its file has it, with vertices and faces shuffled, and that put in \
                order again along a Morton curve.";
    let row = |row: &Backend| {
        let builds = in_orders(row).map(|order| Cell::Time(order.map(|order| order.build), MILLISECOND));
        let sweeps = sweeps(row).map(|sweep| Cell::Time(sweep, 1.0));
        (row.name.to_owned(), builds.into_iter().chain(sweeps).collect())
    };
    let header =
        ["build", "one-ring"].into_iter().flat_map(|what| names.map(|order| format!("{what}, {order}")));
    Plot {
        title: "Ring time by order".into(),
        svg: dots::draw(
            id,
            ["Ring time by order of vertices and faces", note, "one-ring, ns a vertex"],
            1.0,
            &names.map(String::from),
            &marks,
        ),
        note: note.into(),
        table: Table {
            caption: "By order of vertices and faces: build in ms, one-rings in ns a vertex".into(),
            header: words(&["structure"]).into_iter().chain(header).collect(),
            rows: rows().map(row).collect(),
        },
    }
}

/// What has no plot.
pub(super) fn queries(mesh: &Mesh) -> Table {
    let row = |row: &Backend| {
        let times = [row.random_vertex_queries, row.random_face_queries];
        (row.name.to_owned(), times.map(|timing| Cell::Time(timing, MILLISECOND)).into())
    };
    let queries = figure::grouped(crate::compare::sample::QUERIES);
    Table {
        caption: format!("Random queries, ms for {queries}"),
        header: words(&["structure", "one-rings of vertices", "faces across three edges"]),
        rows: mesh.backends.iter().map(row).collect(),
    }
}

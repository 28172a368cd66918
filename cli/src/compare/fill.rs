//! What was measured, in the shape of a row of the report.

use super::case::Ready;
use super::measure::Measured;
use super::orders::{REORDERED, SHUFFLED};
use super::record::{Backend, Mesh, Named, Ring, Sweep};
use super::sample::Soup;
use crate::timing::Timing;
use onering::Pairing;

/// A mesh that there is nothing to measure on.
pub(super) fn without_faces(name: String, vertices: usize) -> Mesh {
    Mesh {
        name,
        vertices,
        triangles: 0,
        edges: 0,
        random_vertices: Vec::new(),
        defects: "nothing to measure on".into(),
        auto_pairing: Named(Vec::new()),
        repair: None,
        backends: Vec::new(),
        mismatches: Vec::new(),
    }
}

/// A row with a place for every strategy, also those that are not timed.
pub(super) fn empty_row(name: &'static str, mesh: &'static str) -> Backend {
    let strategies = std::iter::once(Pairing::Auto).chain(Pairing::ALL);
    Backend {
        name,
        traits: &[],
        holds: &[],
        mesh,
        refusal: None,
        memory: None,
        build: Named(strategies.map(|pairing| (pairing.to_string(), None)).collect()),
        rings: Vec::new(),
        sweep: None,
        random_vertex_queries: None,
        random_face_queries: None,
        orders: Named([SHUFFLED, REORDERED].map(|order| (order.to_owned(), None)).into()),
        checksums: Named(Vec::new()),
    }
}

pub(super) fn fill(row: &mut Backend, measured: &Measured, ready: &Ready) {
    for &(pairing, timing) in &measured.build {
        row.build.set(&pairing.to_string(), timing);
    }
    if let Some(rings) = &measured.rings {
        let starts = rings.counts.len() as f64;
        let levels = rings.timings.iter().zip(rings.means()).enumerate();
        row.rings = levels
            .map(|(k, (timing, vertices))| {
                let timing = timing.scaled(1.0 / starts);
                Ring { level: k + 1, vertices, timing }
            })
            .collect();
    }
    row.sweep = measured.sweep.map(|timing| per_vertex(timing, &ready.soup));
    row.random_vertex_queries = measured.vertex_queries;
    row.random_face_queries = measured.face_queries;
    let sums = measured.answers.iter().map(|&(name, sum)| (name.to_owned(), format!("{sum:016x}")));
    row.checksums = Named(sums.collect());
}

pub(super) fn per_vertex(timing: Timing, soup: &Soup) -> Sweep {
    Sweep { ns_per_vertex: timing.median_ns / soup.vertex_count as f64, timing }
}

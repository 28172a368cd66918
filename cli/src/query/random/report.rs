//! What was measured, as a table and as JSON.

use super::super::relation::Relation;
use super::AskedAll;
use super::measure::SEARCHED;
use crate::failure::Failure;
use crate::machine::Machine;
use crate::tables::{scaled, table, wrapped};
use crate::timing::Timing;
use onering::degrees::Degrees;
use serde_json::{Value, json};
use std::fmt;

/// A whole run.
#[derive(Debug)]
pub(crate) struct Report {
    pub(crate) version: &'static str,
    pub(crate) machine: Machine,
    pub(crate) mesh: String,
    pub(crate) vertices: usize,
    pub(crate) triangles: usize,
    pub(crate) queries: u32,
    pub(crate) seed: u64,
    pub(crate) load: Option<Timing>,
    pub(crate) degrees: Degrees,
    pub(crate) columns: Vec<Column>,
    /// Who cannot hold the mesh, and why.
    pub(crate) refusals: Vec<String>,
}

/// One structure.
#[derive(Debug)]
pub(crate) struct Column {
    pub(crate) name: String,
    pub(crate) build: Timing,
    pub(crate) asked: AskedAll,
    pub(crate) searches: bool,
}

/// How to read the figures.
const NOTES: &str = "Times are medians of at least three runs, after one to warm up; `*` is a single run. Load: from \
    the file to a list of triangles. Build: from this list, and freed again. Queries: all together, of random corners, \
    sides and faces; `-` is what a structure cannot answer. vertex-graph has cycles of three edges for faces.";

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { version, machine, mesh, vertices, triangles, queries, seed, .. } = self;
        writeln!(f, "onering {version} on {machine}")?;
        writeln!(f, "{}\n", wrapped(NOTES))?;
        writeln!(f, "{mesh}: {vertices} vertices, {triangles} triangles; seed {seed}")?;
        let first = format!("ms, {queries} queries");
        let names = self.columns.iter().map(|column| column.name.replace('-', "-\n"));
        let header: Vec<String> = [first].into_iter().chain(names).collect();
        let mut table = table(&header.iter().map(String::as_str).collect::<Vec<_>>(), 1);
        let mut row = |name: &str, times: &mut dyn Iterator<Item = Option<Timing>>| {
            table.add_row([name.to_owned()].into_iter().chain(times.map(|time| scaled(time, 1e6))));
        };
        row("load", &mut self.columns.iter().map(|_| self.load));
        row("build", &mut self.columns.iter().map(|column| Some(column.build)));
        for (i, relation) in Relation::all().iter().enumerate() {
            let name = relation.in_toptri().unwrap_or(relation.name());
            row(name, &mut self.columns.iter().map(|column| column.asked[i].map(|asked| asked.timing)));
        }
        writeln!(f, "{table}")?;
        if self.columns.iter().any(|column| column.searches) {
            writeln!(f, "who searches all faces is timed for one query in {SEARCHED}, and a multiple told")?;
        }
        self.refusals.iter().try_for_each(|refusal| writeln!(f, "{refusal}"))?;
        let share = Degrees::BUCKETS.iter().zip(self.degrees.percentages());
        let shares: Vec<String> = share.map(|(degree, share)| format!("{degree}: {share:.2} %")).collect();
        writeln!(f, "degrees, of vertices that are in a face (Table 6): {}", shares.join(", "))
    }
}

impl Report {
    pub(crate) fn json(&self) -> Result<String, Failure> {
        let Self { version, machine, mesh, vertices, triangles, queries, seed, load, refusals, .. } = self;
        let value = json!({
            "version": version, "machine": machine, "mesh": mesh, "vertices": vertices, "triangles": triangles,
            "queries": queries, "seed": seed, "load": load,
            "degrees": self.degrees.iter().collect::<Vec<_>>(),
            "backends": self.columns.iter().map(Column::json).collect::<Vec<_>>(),
            "refusals": refusals,
        });
        let text = serde_json::to_string_pretty(&value);
        text.map(|text| text + "\n").map_err(|error| Failure::Output(error.to_string()))
    }
}

impl Column {
    fn json(&self) -> Value {
        let of = |(relation, asked): (&Relation, &Option<super::measure::Asked>)| {
            json!({
                "relation": relation.name(),
                "toptri": relation.in_toptri(),
                "timing": asked.map(|asked| asked.timing),
                "results_per_query": asked.map(|asked| asked.results),
            })
        };
        let queries: Vec<Value> = Relation::all().iter().zip(&self.asked).map(of).collect();
        json!({ "name": self.name, "build": self.build, "searches": self.searches, "queries": queries })
    }
}

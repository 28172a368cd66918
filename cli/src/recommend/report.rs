//! The pick, and the table of all candidates.

use super::Size;
use super::candidate::{Candidate, Verdict, within};
use super::choice::within_noise;
use crate::args;
use crate::compare::case::Case;
use crate::compare::sample::Soup;
use crate::failure::Failure;
use crate::machine::Machine;
use crate::tables::{scaled, table, wrapped};
use onering_io::one_line;
use serde_json::{Map, Value, json};
use std::fmt;

pub(super) struct Report<'a> {
    pub(super) options: &'a args::Recommend,
    pub(super) machine: Machine,
    pub(super) case: &'a Case,
    /// What was measured on.
    pub(super) soup: &'a Soup,
    /// What was done to the mesh before.
    pub(super) repair: Option<&'a str>,
    pub(super) candidates: &'a [Candidate],
    pub(super) pick: Option<usize>,
}

const NOTE: &str = "Times are medians of at least three runs, after one to warm up, of the best of three rounds in which all have their \
    turn; `*` is a single run. The least times decide. Keeps: the \
    structure and positions of 12 bytes a vertex. Needs: the most while it is built, with these positions and the list of \
    faces; `≥` where it was not built: it takes that in any case. `-` was not measured. Why: the first that applies of \
    traits, numbers, memory, defects, time.";

impl fmt::Display for Report<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(pick) = self.pick.map(|place| &self.candidates[place]) {
            writeln!(f, "{}", wrapped(&format!("{}: {}", pick.known.name, self.reason(pick))))?;
            writeln!(f, "\nin Cargo.toml:  {}", pick.cargo())?;
            let what = match pick.feature() {
                Some(_) => ", which is onering::Mesh with that feature alone",
                None if pick.known.renumbers => ", which gives it and the maps from and to its numbers",
                None => "",
            };
            writeln!(f, "in the program: {}{what}", pick.path())?;
        }
        let Self { machine, case, soup, .. } = self;
        let counts = format!("{} vertices, {} triangles", soup.vertex_count, soup.faces.len());
        writeln!(f, "\n{}: {counts}; {}", one_line(&case.name), case.defects)?;
        if let Some(steps) = self.repair {
            writeln!(f, "no structure that answers this holds it as it is; measured after repair: {steps}")?;
        }
        writeln!(f, "onering {} on {machine}; seed {}", env!("CARGO_PKG_VERSION"), self.options.seed)?;
        writeln!(f, "{}\n{}", wrapped(NOTE), self.table())
    }
}

impl Report<'_> {
    /// Why this one.
    fn reason(&self, pick: &Candidate) -> String {
        let rivals = self.candidates.iter().filter(|candidate| candidate.is_eligible()).count();
        let queries: Vec<String> = pick
            .times
            .iter()
            .map(|&(question, timing)| {
                let (by, unit) = question.unit(self.soup);
                format!("{} {} {unit}", question.name(), scaled(Some(timing), by))
            })
            .collect();
        let is_same = self.candidates.iter().any(|candidate| candidate.verdict == Verdict::Larger);
        let rank = if is_same {
            format!("the smallest {} of the fastest", within_noise())
        } else {
            "the fastest".into()
        };
        let faces = if pick.has_faces() {
            String::new()
        } else {
            // Measured as well, so that a program that is not content with neighbours knows what to take.
            let other = self.ordered().into_iter().find(|other| other.is_eligible() && other.has_faces());
            let other = other.map(|other| format!(", which {} has as the next best", other.known.name));
            format!("; it knows neighbours and no faces{}", other.unwrap_or_default())
        };
        let after = if self.repair.is_some() { "after repair (--repair), " } else { "" };
        let bytes = |bytes: Option<u64>| Size(bytes.unwrap_or_default());
        format!(
            "{after}{rank} of {rivals} that answer and fit{} ({}); keeps {}, needs {} while it is built{faces}",
            within(self.options.memory),
            queries.join(", "),
            bytes(pick.kept),
            bytes(pick.needs)
        )
    }

    /// The pick first, then those that come into question by their times, then the others.
    fn ordered(&self) -> Vec<&Candidate> {
        let mut all: Vec<(usize, &Candidate)> = self.candidates.iter().enumerate().collect();
        let rank = |&(i, candidate): &(usize, &Candidate)| match candidate.verdict {
            _ if Some(i) == self.pick => 0.0,
            Verdict::Larger => 1.0,
            Verdict::Slower(factor) => factor.max(1.0),
            _ => f64::INFINITY,
        };
        all.sort_by(|a, b| rank(a).total_cmp(&rank(b)));
        all.into_iter().map(|(_, candidate)| candidate).collect()
    }

    fn table(&self) -> String {
        let queries = self.options.queries.iter();
        let titles: Vec<String> =
            queries.map(|query| format!("{},\n{}", query.name(), query.unit(self.soup).1)).collect();
        let mut header = vec!["structure", "why"];
        header.extend(["keeps", "needs"].into_iter().chain(titles.iter().map(String::as_str)));
        let mut table = table(&header, 2);
        let size = |bytes: Option<u64>| bytes.map_or("-".into(), |bytes| Size(bytes).to_string());
        for candidate in self.ordered() {
            let mut row = vec![candidate.known.name.to_owned(), candidate.verdict.to_string()];
            let least = if candidate.kept.is_none() && candidate.needs.is_some() { "≥ " } else { "" };
            row.extend([size(candidate.kept), format!("{least}{}", size(candidate.needs))]);
            row.extend(self.options.queries.iter().map(|query| {
                let found = candidate.times.iter().find(|(asked, _)| asked == query);
                scaled(found.map(|&(_, timing)| timing), query.unit(self.soup).0)
            }));
            table.add_row(row);
        }
        table.to_string()
    }

    pub(super) fn json(&self) -> Result<String, Failure> {
        let Self { options, machine, case, soup, repair, .. } = self;
        let pick = self.pick.map(|place| &self.candidates[place]);
        let value = json!({
            "version": env!("CARGO_PKG_VERSION"), "machine": machine, "mesh": case.name,
            "vertices": soup.vertex_count, "triangles": soup.faces.len(), "defects": case.defects, "repair": repair,
            "memory_bytes": options.memory.map(|limit| limit.0),
            "queries": options.queries.iter().map(|query| query.name()).collect::<Vec<_>>(),
            "renumber": options.renumber, "seed": options.seed, "budget_ms": options.budget,
            "pick": pick.map(|pick| pick.known.name),
            "cargo": pick.map(Candidate::cargo),
            "type": pick.map(|pick| format!("onering::{}", pick.type_name)),
            "reason": pick.map(|pick| self.reason(pick)),
            "candidates": self.ordered().into_iter().map(Candidate::json).collect::<Vec<_>>(),
        });
        let text = serde_json::to_string_pretty(&value);
        text.map(|text| text + "\n").map_err(|error| Failure::Output(error.to_string()))
    }
}

impl Candidate {
    fn json(&self) -> Value {
        let times: Map<String, Value> =
            self.times.iter().map(|(question, timing)| (question.name(), json!(timing))).collect();
        json!({
            "name": self.known.name, "verdict": self.verdict.word(), "reason": self.verdict.to_string(),
            "traits": self.known.traits, "holds": self.known.holds, "feature": self.feature(),
            "keeps_bytes": self.kept, "needs_bytes": self.needs, "times": times,
        })
    }
}

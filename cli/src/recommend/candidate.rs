//! One structure that may be taken: whether it can be, and what it takes.

use super::choice::within_noise;
use super::{ROUNDS, Size};
use crate::args;
use crate::compare::case::Ready;
use crate::compare::measure::{Depth, Measured, Plan, is_too_large};
use crate::compare::question::Question;
use crate::compare::subject::{Formula, Known, Subject};
use crate::tables::digits;
use crate::timing::{Clock, Timing};
use onering::BuildError;
use std::fmt;
use std::time::Duration;

/// Why it is taken, or not.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Verdict {
    Picked,
    /// So many times the time of the pick.
    Slower(f64),
    /// As fast but for noise, and no smaller.
    Larger,
    DoesNotFit,
    /// What it cannot answer, for it has not one of the traits.
    Lacks(Question),
    /// What it says of the mesh.
    NeedsRepair(String),
    Renumbers,
    /// It looks around each vertex for an answer, and one has very many faces.
    TooSlow,
}

#[derive(Debug)]
pub(super) struct Candidate {
    pub(super) known: Known,
    pub(super) type_name: &'static str,
    pub(super) verdict: Verdict,
    /// Bytes once it is built, positions included.
    pub(super) kept: Option<u64>,
    /// The most bytes until then, the list of faces and positions included; the least that it can be where it was not built.
    pub(super) needs: Option<u64>,
    pub(super) times: Vec<(Question, Timing)>,
}

impl Candidate {
    /// Measures it where it comes into question: then the verdict is [`Verdict::Picked`] for the time being.
    pub(super) fn of(subject: &Subject, known: Known, ready: &Ready, options: &args::Recommend) -> Self {
        let type_name = subject.type_name.rsplit("::").next().unwrap_or_default().trim();
        let verdict = Verdict::Picked;
        let mut candidate = Self { known, type_name, verdict, kept: None, needs: None, times: Vec::new() };
        candidate.verdict = candidate.judged(subject, ready, options);
        candidate
    }

    fn judged(&mut self, subject: &Subject, ready: &Ready, options: &args::Recommend) -> Verdict {
        let has = |question: &&Question| {
            let any = question.traits();
            any.is_empty() || any.iter().any(|name| self.known.traits.contains(name))
        };
        if let Some(&question) = options.queries.iter().find(|question| !has(question)) {
            return Verdict::Lacks(question);
        }
        if self.known.renumbers && !options.renumber {
            return Verdict::Renumbers;
        }
        let fits = |bytes: u64| options.memory.is_none_or(|limit| bytes <= limit.0);
        let [vertices, faces] = [ready.soup.vertex_count, ready.soup.faces.len()].map(|count| count as u64);
        let (positions, list) = (12 * vertices, 12 * faces);
        let (Formula::Counts(least) | Formula::Words(_, least)) = self.known.memory;
        let least = least.of(&ready.counts) as u64 + positions + list;
        self.needs = Some(least);
        // So that what does not fit is not even tried.
        if !fits(least) {
            return Verdict::DoesNotFit;
        }
        match measured(subject, ready, options) {
            // It may take more while it is built than what it takes in any case.
            Err(refusal) if is_too_large(&refusal) => Verdict::DoesNotFit,
            Err(refusal) => {
                self.needs = None;
                Verdict::NeedsRepair(refusal.to_string())
            }
            Ok(measured) => {
                self.kept = Some(measured.counted as u64 + positions);
                self.needs = Some(measured.peak.max(measured.counted) as u64 + positions + list);
                self.times = times(&measured, &options.queries);
                match self.needs.is_some_and(fits) {
                    false => Verdict::DoesNotFit,
                    true if self.times.len() < options.queries.len() => Verdict::TooSlow,
                    true => Verdict::Picked,
                }
            }
        }
    }

    /// Measures it another time where it comes into question. Of each figure the round of the least time is kept: what
    /// else the machine did only ever made it slower.
    pub(super) fn measure_again(&mut self, subject: &Subject, ready: &Ready, options: &args::Recommend) {
        if !self.is_eligible() {
            return;
        }
        // What was built once is built again, unless another program took the memory meanwhile.
        let Ok(measured) = measured(subject, ready, options) else { return };
        for ((_, best), (_, timing)) in self.times.iter_mut().zip(times(&measured, &options.queries)) {
            if timing.min_ns < best.min_ns {
                *best = timing;
            }
        }
    }

    /// Whether it can be taken, fast or slow.
    pub(super) fn is_eligible(&self) -> bool {
        matches!(self.verdict, Verdict::Picked | Verdict::Slower(_) | Verdict::Larger)
    }

    /// The cargo feature that makes it `onering::Mesh`, where there is one.
    pub(super) fn feature(&self) -> Option<&'static str> {
        (self.has_faces() && !self.known.renumbers).then_some(self.known.name)
    }

    pub(super) fn has_faces(&self) -> bool {
        self.known.traits.contains(&"topology")
    }

    /// What to write in a program.
    pub(super) fn path(&self) -> String {
        let encode = if self.known.renumbers { "::encode" } else { "" };
        format!("onering::{}{encode}", self.type_name)
    }

    /// What goes into Cargo.toml.
    pub(super) fn cargo(&self) -> String {
        let version = concat!(env!("CARGO_PKG_VERSION_MAJOR"), ".", env!("CARGO_PKG_VERSION_MINOR"));
        match self.feature() {
            Some(name) => format!("onering = {{ version = \"{version}\", features = [\"{name}\"] }}"),
            None => format!("onering = \"{version}\""),
        }
    }
}

/// What it takes and how fast it is, in one of the rounds that share the budget.
fn measured(subject: &Subject, ready: &Ready, options: &args::Recommend) -> Result<Measured, BuildError> {
    let clock = Clock { budget: Duration::from_millis(options.budget) / ROUNDS, gives_up: false };
    let depth = Depth::Only(&options.queries);
    (subject.measure)(&Plan { soup: &ready.soup, sample: &ready.sample, clock, depth })
}

fn times(measured: &Measured, questions: &[Question]) -> Vec<(Question, Timing)> {
    let time = |&question: &Question| match question {
        Question::Build => Some((question, measured.build.first()?.1)),
        _ => measured.asked.iter().find(|(asked, _)| *asked == question).copied(),
    };
    questions.iter().filter_map(time).collect()
}

impl Verdict {
    /// One word for programs.
    pub(super) fn word(&self) -> &'static str {
        match self {
            Self::Picked => "picked",
            Self::Slower(_) => "slower",
            Self::Larger => "larger",
            Self::DoesNotFit => "does-not-fit",
            Self::Lacks(_) => "lacks-trait",
            Self::NeedsRepair(_) => "needs-repair",
            Self::Renumbers => "renumbers",
            Self::TooSlow => "too-slow",
        }
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Picked => write!(f, "the pick"),
            Self::Slower(times) => write!(f, "slower: {} times the time", digits(*times)),
            Self::Larger => write!(f, "as fast {}, and no smaller", within_noise()),
            Self::DoesNotFit => write!(f, "does not fit"),
            Self::Lacks(question) => {
                write!(f, "no answer to {}: lacks {}", question.name(), question.traits().join(" or "))
            }
            Self::NeedsRepair(refusal) => write!(f, "needs repair: {refusal}"),
            Self::TooSlow => {
                write!(f, "left out: looks through all faces of a vertex, and one has very many")
            }
            Self::Renumbers => {
                write!(f, "only with --renumber: gives vertices and faces other numbers")
            }
        }
    }
}

/// In words, where there may be no limit.
pub(super) fn within(limit: Option<Size>) -> String {
    limit.map_or_else(String::new, |limit| format!(" in {limit}"))
}

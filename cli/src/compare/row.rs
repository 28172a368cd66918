//! Measures one mesh, backend after backend, and compares their answers.

use super::case::{Case, Ready};
use super::fill::{empty_row, fill, per_vertex};
use super::measure::{Depth, Measured, Plan, is_too_large};
use super::record::{Backend, InOrder, Memory, Mesh};
use super::subject::{BASELINE, Formula, Known, SUBJECTS, Subject, all_known};
use crate::args;
use crate::timing::Clock;
use onering::BuildError;
use onering::footprint::Counts;
use std::time::Duration;

/// The rows of one mesh so far.
pub(crate) struct Rows<'a> {
    case: &'a Case,
    clock: Clock,
    /// Up to how many triangles what is quadratic is done.
    limit: usize,
    rows: Vec<Backend>,
    /// The first answer to each question in each state of the mesh, and who gave it.
    first: Vec<(String, &'static str, &'static str, u64)>,
    mismatches: Vec<String>,
}

pub(crate) const AS_IT_IS: &str = "as it is";
pub(crate) const REPAIRED: &str = "repaired";
const NOT_BUILT: &str = "not built";
const THE_LIST: &str = "the list of faces";

impl<'a> Rows<'a> {
    pub(crate) fn new(case: &'a Case, options: &args::Compare) -> Self {
        let states = [(AS_IT_IS, Some(&case.as_it_is)), (REPAIRED, case.repaired.as_ref().map(|(r, _)| r))];
        let answers = |(state, ready): (&'static str, Option<&'a Ready>)| {
            let answers = ready.into_iter().flat_map(|ready| &ready.answers);
            answers.map(move |&(name, answer)| (state.to_owned(), name, THE_LIST, answer))
        };
        Self {
            case,
            clock: Clock { budget: Duration::from_millis(options.budget), gives_up: false },
            limit: options.quadratic_up_to(),
            rows: Vec::new(),
            first: states.into_iter().flat_map(answers).collect(),
            mismatches: Vec::new(),
        }
    }

    /// Measures a structure by its place in [`SUBJECTS`]: on the mesh as it is, else on the repaired one.
    pub(crate) fn measure(&mut self, place: usize) {
        let subject = &SUBJECTS[place];
        let known = all_known().nth(place).expect("there is one for each of the subjects");
        let case = self.case;
        let (state, refusal, outcome) = match self.ask(subject, &case.as_it_is) {
            Ok(measured) => (AS_IT_IS, None, Some((measured, &case.as_it_is))),
            Err(refusal) => match &case.repaired {
                None => (NOT_BUILT, Some(refusal), None),
                Some((ready, _)) => match self.ask(subject, ready) {
                    Ok(measured) => (REPAIRED, Some(refusal), Some((measured, ready))),
                    Err(refusal) => (NOT_BUILT, Some(refusal), None),
                },
            },
        };
        let mut row = empty_row(known.name, state);
        (row.traits, row.holds) = (known.traits, known.holds);
        let is_wrong = refusal.as_ref().is_some_and(|refusal| !is_too_large(refusal));
        row.refusal = refusal.map(|refusal| refusal.to_string());
        if let Some((measured, ready)) = outcome {
            self.compare(subject.name, state, &measured);
            row.memory = Some(self.memory(known, state, &measured, ready));
            fill(&mut row, &measured, ready);
            self.measure_orders(subject, state, ready, &mut row);
        } else if is_wrong && (case.as_it_is.soup.is_clean || case.repaired.is_some()) {
            self.mismatches.push(format!("{} refuses a mesh that every backend should hold", subject.name));
        }
        self.rows.push(row);
    }

    /// The search over all faces, where that does not take too long.
    pub(crate) fn measure_baseline(&mut self) {
        let ready = &self.case.as_it_is;
        if !ready.soup.is_quick_to_search(self.limit).is_ok_and(|is_quick| is_quick) {
            return;
        }
        if let Ok(measured) = self.ask(&BASELINE, ready) {
            self.compare(BASELINE.name, AS_IT_IS, &measured);
            let mut row = empty_row(BASELINE.name, AS_IT_IS);
            fill(&mut row, &measured, ready);
            row.build.0.clear();
            self.rows.push(row);
        }
    }

    fn ask(&self, subject: &Subject, ready: &Ready) -> Result<Measured, BuildError> {
        let with_quadratic = self.case.as_it_is.soup.faces.len() <= self.limit;
        let depth = Depth::All { with_quadratic };
        (subject.measure)(&Plan { soup: &ready.soup, sample: &ready.sample, clock: self.clock, depth })
    }

    /// Builds and sweeps the same triangles in other orders. What is out of order may take very long.
    fn measure_orders(&mut self, subject: &Subject, state: &str, ready: &Ready, row: &mut Backend) {
        for other in &ready.others {
            let (soup, clock) = (&other.soup, self.clock.of_quadratic());
            match (subject.measure)(&Plan { soup, sample: &ready.sample, clock, depth: Depth::Sweep }) {
                Ok(measured) => {
                    self.compare(subject.name, &format!("{state}, {}", other.name), &measured);
                    let sweep = measured.sweep.map(|timing| per_vertex(timing, &other.soup));
                    let found = InOrder { build: measured.build[0].1, sweep };
                    row.orders.set(other.name, found);
                }
                Err(error) if is_too_large(&error) => {}
                Err(error) => {
                    let (name, order) = (subject.name, other.name);
                    self.mismatches.push(format!("{name} refuses the mesh {state} when {order}: {error}"));
                }
            }
        }
    }

    fn compare(&mut self, who: &'static str, state: &str, measured: &Measured) {
        let own = format!("{state}, in the numbers of {who}");
        for &(name, answer) in measured.expected.iter().flatten() {
            self.first.push((own.clone(), name, THE_LIST, answer));
        }
        for &(name, answer) in &measured.answers {
            // Sizes of rings are the same in whatever numbers.
            let state = if measured.expected.is_some() && name != "rings" { &own } else { state };
            match self.first.iter().find(|(s, n, ..)| (s.as_str(), *n) == (state, name)) {
                None => self.first.push((state.to_owned(), name, who, answer)),
                Some(&(_, _, other, first)) if first != answer => {
                    self.mismatches.push(format!("{who} and {other} differ in `{name}` on the mesh {state}"));
                }
                Some(_) => {}
            }
        }
    }

    /// Bytes as the structure tells are those of the formula, or where the order decides, those that were counted.
    fn memory(&mut self, known: Known, state: &str, measured: &Measured, ready: &Ready) -> Memory {
        let &Measured { vertex_record_words, unmatched, .. } = measured;
        let counts = Counts { vertex_record_words, unmatched, ..ready.counts };
        let (words, formula) = match known.memory {
            Formula::Counts(bytes) => (bytes.to_string(), Some(bytes.of(&counts))),
            Formula::Words(words, _) => (words.to_owned(), None),
        };
        let expected = formula.unwrap_or(measured.counted);
        if let Some(told) = measured.told.filter(|&told| told != expected) {
            let name = known.name;
            self.mismatches
                .push(format!("{name} tells of {told} bytes, not {expected}, on the mesh {state}"));
        }
        let each = |bytes: usize| bytes as f64 / ready.soup.faces.len() as f64;
        Memory {
            formula: words,
            formula_bytes: formula,
            counted_bytes: measured.counted,
            peak_bytes: measured.peak,
            formula_bytes_per_triangle: formula.map(each),
            counted_bytes_per_triangle: each(measured.counted),
            peak_bytes_per_triangle: each(measured.peak),
        }
    }

    pub(crate) fn into_mesh(self) -> Mesh {
        let Self { case, rows, mismatches, .. } = self;
        let Ready { soup, sample, counts, .. } = &case.as_it_is;
        Mesh {
            name: case.name.clone(),
            vertices: soup.vertex_count,
            triangles: soup.faces.len(),
            edges: counts.edges,
            random_vertices: sample.starts.clone(),
            defects: case.defects.clone(),
            auto_pairing: case.as_it_is.choices(),
            repair: case.repaired.as_ref().map(|(_, repair)| repair.clone()),
            backends: rows,
            mismatches,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::case::Wanted;
    use super::*;

    #[test]
    fn a_wrong_answer_is_told_with_who_gave_it() {
        let wanted = Wanted { seed: 1, comparison: true };
        let case = Case::of("square".into(), &[[0.0; 3]; 4], vec![[0, 1, 2], [0, 2, 3]], wanted).unwrap();
        let mut rows = Rows::new(&case, &args::Compare::default());
        let answers =
            |answers: &[(&'static str, u64)]| Measured { answers: answers.into(), ..Measured::default() };
        rows.compare("one", AS_IT_IS, &answers(&case.as_it_is.answers));
        rows.compare("one", AS_IT_IS, &answers(&[("sweep", 7)]));
        rows.compare("two", REPAIRED, &answers(&[("sweep", 8)]));
        assert!(rows.mismatches.is_empty());
        rows.compare("two", AS_IT_IS, &answers(&[("sweep", 8), ("star", 0)]));
        let expected = [
            "two and one differ in `sweep` on the mesh as it is",
            "two and the list of faces differ in `star` on the mesh as it is",
        ];
        assert_eq!(rows.mismatches, expected);
    }
}

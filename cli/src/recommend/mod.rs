//! `onering recommend`: which structure to take for a mesh, and why not the others.

mod candidate;
mod choice;
mod report;
mod size;

pub(crate) use choice::within_noise;
pub(crate) use size::Size;

use crate::args;
use crate::compare;
use crate::compare::case::{Case, Ready, Wanted};
use crate::compare::subject::{Known, SUBJECTS, Subject, all_known};
use crate::failure::Failure;
use crate::input::Input;
use crate::machine::Machine;
use crate::made;
use crate::output::{self, Status};
use candidate::{Candidate, Verdict, within};
use report::Report;
use std::io;

/// Rounds in which every candidate has its turn: one after the other, what slows the machine down for a while would
/// slow down one candidate alone.
const ROUNDS: u32 = 3;

/// Measures, and prints what to take.
pub(crate) fn run(options: &args::Recommend) -> io::Result<Status> {
    match recommend(options) {
        Ok(()) => Ok(Status::Done),
        Err(failure) => failure.end(),
    }
}

fn recommend(options: &args::Recommend) -> Result<(), Failure> {
    let Input { name, mesh, .. } = Input::read(&options.mesh, made::TERRAIN)?;
    if mesh.faces.is_empty() {
        return Err(Failure::Output(format!("{name}: it has no faces to measure on")));
    }
    let wanted = Wanted { seed: options.seed, comparison: false };
    let case = Case::of(name.clone(), &mesh.positions, mesh.faces, wanted)
        .map_err(|error| Failure::Output(format!("{name}: {error}")))?;
    // Nothing is asked about places.
    drop(mesh.positions);
    let mut candidates = measured(&case.as_it_is, options);
    let mut pick = choice::pick(&mut candidates);
    let mut state = &case.as_it_is;
    let mut repair = None;
    // Only where nothing holds it as it is.
    if let (None, Some((repaired, steps))) = (pick, &case.repaired)
        && candidates.iter().any(|candidate| matches!(candidate.verdict, Verdict::NeedsRepair(_)))
    {
        candidates = measured(repaired, options);
        pick = choice::pick(&mut candidates);
        (state, repair) = (repaired, Some(steps.steps.as_str()));
    }
    let machine = Machine::this();
    let report =
        Report { options, machine, case: &case, soup: &state.soup, repair, candidates: &candidates, pick };
    let text = if options.json { report.json()? } else { report.to_string() };
    output::print(&text).map_err(Failure::Standard)?;
    if pick.is_some() { Ok(()) } else { Err(nothing(options, &candidates)) }
}

fn measured(ready: &Ready, options: &args::Recommend) -> Vec<Candidate> {
    // Without a thread that ticks: it would allocate while bytes are counted.
    let rounds = if options.budget == 0 { 1 } else { ROUNDS as usize };
    let bar = compare::progress(rounds * SUBJECTS.len());
    let candidate = |(subject, known): (&Subject, Known)| {
        bar.set_message(known.name);
        let candidate = Candidate::of(subject, known, ready, options);
        bar.inc(1);
        candidate
    };
    let mut candidates: Vec<Candidate> = SUBJECTS.iter().zip(all_known()).map(candidate).collect();
    for _ in 1..rounds {
        for (candidate, subject) in candidates.iter_mut().zip(SUBJECTS) {
            bar.set_message(candidate.known.name);
            candidate.measure_again(subject, ready, options);
            bar.inc(1);
        }
    }
    bar.finish_and_clear();
    candidates
}

/// No structure can be taken.
fn nothing(options: &args::Recommend, candidates: &[Candidate]) -> Failure {
    let too_large = candidates.iter().filter(|candidate| candidate.verdict == Verdict::DoesNotFit);
    let least = too_large.filter_map(|candidate| Some((candidate.needs?, candidate.known.name))).min();
    Failure::Output(match least {
        Some((bytes, name)) => {
            format!(
                "nothing fits{}: the least is {name}, which needs at least {}",
                within(options.memory),
                Size(bytes)
            )
        }
        None => "no structure answers all of that on this mesh".into(),
    })
}

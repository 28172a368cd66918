//! Which of the candidates it is.

use super::candidate::{Candidate, Verdict};

/// Times within this factor are the same: runs differ by so much (`docs/performance.md`).
const SAME: f64 = 1.25;

/// In words: how much more than the least time is no more than noise.
pub(crate) fn within_noise() -> String {
    format!("within {:.0} %", 100.0 * (SAME - 1.0))
}

/// Picks the fastest, or of those that are as fast the smallest, and says of the others how much slower they are. The
/// place of the pick; `None` where none comes into question.
pub(super) fn pick(candidates: &mut [Candidate]) -> Option<usize> {
    let scores = scores(candidates);
    let eligible = || scores.iter().enumerate().filter_map(|(i, score)| Some((i, (*score)?)));
    let best = eligible().map(|(_, score)| score).min_by(f64::total_cmp)?;
    let fast = eligible().filter(|&(_, score)| score <= SAME * best);
    let (pick, score) = fast.min_by(|a, b| {
        let bytes = |i: usize| candidates[i].kept;
        bytes(a.0).cmp(&bytes(b.0)).then(a.1.total_cmp(&b.1))
    })?;
    for (i, other) in eligible().filter(|&(i, _)| i != pick).collect::<Vec<_>>() {
        let is_same = other <= SAME * best;
        candidates[i].verdict = if is_same { Verdict::Larger } else { Verdict::Slower(other / score) };
    }
    Some(pick)
}

/// For each candidate that comes into question the geometric mean of its least times, which vary less from run to run
/// than medians do.
fn scores(candidates: &[Candidate]) -> Vec<Option<f64>> {
    let times = |candidate: &Candidate| -> Vec<f64> {
        candidate.times.iter().map(|(_, timing)| timing.min_ns.max(1.0)).collect()
    };
    let mean = |times: Vec<f64>| {
        let logs: f64 = times.iter().map(|time| time.ln()).sum();
        (logs / times.len().max(1) as f64).exp()
    };
    candidates.iter().map(|candidate| candidate.is_eligible().then(|| mean(times(candidate)))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::question::Question;
    use crate::compare::subject::all_known;
    use crate::timing::Timing;

    fn candidate(place: usize, kept: u64, times: &[f64], verdict: Verdict) -> Candidate {
        let timing = |&min_ns: &f64| Timing { median_ns: 1e9, min_ns, quartile_ns: 1e9, runs: 3 };
        let times = times.iter().map(|time| (Question::Rings, timing(time))).collect();
        let (known, needs) = (all_known().nth(place).unwrap(), Some(kept));
        Candidate { known, type_name: "", verdict, kept: Some(kept), needs, times }
    }

    #[test]
    fn the_smallest_of_the_fastest_is_picked() {
        let mut all = [
            candidate(0, 10, &[1.0, 1.0], Verdict::DoesNotFit),
            candidate(1, 60, &[100.0, 400.0], Verdict::Picked),
            candidate(2, 40, &[480.0, 120.0], Verdict::Picked),
            candidate(3, 20, &[480.0, 480.0], Verdict::Picked),
        ];
        assert_eq!(pick(&mut all), Some(2));
        let verdicts = all.each_ref().map(|candidate| candidate.verdict.word());
        assert_eq!(verdicts, ["does-not-fit", "larger", "picked", "slower"]);
        let Verdict::Slower(factor) = all[3].verdict else { panic!() };
        assert!((1.99..2.01).contains(&factor), "{factor}");
        assert_eq!(pick(&mut all[..1]), None);
    }
}

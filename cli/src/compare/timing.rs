//! Medians of repeated runs.

use serde::Serialize;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Time of one run of a kernel.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct Timing {
    /// The middle one of the runs.
    pub(crate) median_ns: f64,
    /// The shortest.
    pub(crate) min_ns: f64,
    /// How many were timed.
    pub(crate) runs: usize,
}

/// Runs kernels until a budget of time is spent.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clock {
    /// Time to spend on one kernel.
    pub(crate) budget: Duration,
}

/// What is shorter is run several times between two looks at the clock.
const SHORTEST: Duration = Duration::from_micros(50);
const FEWEST: usize = 3;
const MOST: usize = 201;
/// What takes so many budgets is run once: its time is no matter of warm caches.
const LONG: u32 = 8;

impl Timing {
    /// As for so many times the work.
    pub(crate) fn scaled(self, factor: f64) -> Self {
        Self { median_ns: self.median_ns * factor, min_ns: self.min_ns * factor, ..self }
    }
}

impl Clock {
    /// Times `run`, after one run to warm caches and branch prediction. The drop of its result is not timed
    /// where one run is long enough to be timed alone.
    pub(crate) fn time<T>(&self, mut run: impl FnMut() -> T) -> Timing {
        let begin = Instant::now();
        let warm = elapsed(&mut run);
        if warm > LONG * self.budget {
            let once = warm.as_nanos() as f64;
            return Timing { median_ns: once, min_ns: once, runs: 1 };
        }
        let batch = (SHORTEST.as_nanos() / warm.as_nanos().max(1)).clamp(1, 10_000) as u32;
        let mut times = Vec::new();
        while times.len() < FEWEST || (times.len() < MOST && begin.elapsed() < self.budget) {
            let time = if batch == 1 { elapsed(&mut run) } else { elapsed_batch(&mut run, batch) };
            times.push(time.as_nanos() as f64 / f64::from(batch));
        }
        times.sort_unstable_by(f64::total_cmp);
        Timing { median_ns: times[times.len() / 2], min_ns: times[0], runs: times.len() }
    }
}

fn elapsed<T>(run: &mut impl FnMut() -> T) -> Duration {
    let start = Instant::now();
    let result = black_box(run());
    let time = start.elapsed();
    drop(result);
    time
}

fn elapsed_batch<T>(run: &mut impl FnMut() -> T, batch: u32) -> Duration {
    let start = Instant::now();
    for _ in 0..batch {
        black_box(run());
    }
    start.elapsed()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn short_work_is_repeated_and_long_work_is_not() {
        let clock = Clock { budget: Duration::from_millis(2) };
        let mut calls = 0_u64;
        let short = clock.time(|| calls += 1);
        assert!(short.runs >= FEWEST && calls > short.runs as u64 && short.min_ns <= short.median_ns);
        let mut calls = 0;
        let long = clock.time(|| {
            calls += 1;
            std::thread::sleep(Duration::from_millis(20));
        });
        assert_eq!((long.runs, calls), (1, 1));
        assert!(long.median_ns >= 2e7 && long.scaled(2.0).median_ns >= 4e7);
    }
}

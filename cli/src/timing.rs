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
    /// What three of four runs stayed within. The longest says more of what else the machine did.
    pub(crate) quartile_ns: f64,
    /// How many were timed.
    pub(crate) runs: usize,
}

/// Runs kernels until a budget of time is spent.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Clock {
    /// Time to spend on one kernel; all are run once where it is zero.
    pub(crate) budget: Duration,
    /// Whether what takes very long is run once.
    pub(crate) gives_up: bool,
}

/// What is shorter is run several times between two looks at the clock.
const SHORTEST: Duration = Duration::from_micros(50);
const FEWEST: usize = 3;
const MOST: usize = 201;
/// What is quadratic and takes so many budgets is run once: its time is no matter of warm caches.
const LONG: u32 = 8;

impl Timing {
    /// As for so many times the work.
    pub(crate) fn scaled(self, factor: f64) -> Self {
        let all = [self.median_ns, self.min_ns, self.quartile_ns];
        let [median_ns, min_ns, quartile_ns] = all.map(|ns| ns * factor);
        Self { median_ns, min_ns, quartile_ns, ..self }
    }
}

impl Clock {
    /// For what takes quadratic time.
    pub(crate) fn of_quadratic(self) -> Self {
        Self { gives_up: true, ..self }
    }

    /// Times `run`, after one run to warm caches and branch prediction. The drop of its result is not timed
    /// where one run is long enough to be timed alone.
    pub(crate) fn time<T>(&self, mut run: impl FnMut() -> T) -> Timing {
        let begin = Instant::now();
        let warm = elapsed(&mut run);
        if self.budget.is_zero() || self.gives_up && warm > LONG * self.budget {
            let once = warm.as_nanos() as f64;
            return Timing { median_ns: once, min_ns: once, quartile_ns: once, runs: 1 };
        }
        let batch = (SHORTEST.as_nanos() / warm.as_nanos().max(1)).clamp(1, 10_000) as u32;
        let mut times = Vec::new();
        while times.len() < FEWEST || (times.len() < MOST && begin.elapsed() < self.budget) {
            let time = if batch == 1 { elapsed(&mut run) } else { elapsed_batch(&mut run, batch) };
            times.push(time.as_nanos() as f64 / f64::from(batch));
        }
        times.sort_unstable_by(f64::total_cmp);
        let runs = times.len();
        Timing { median_ns: times[runs / 2], min_ns: times[0], quartile_ns: times[3 * runs / 4], runs }
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
    fn work_is_repeated_unless_it_is_quadratic_and_long() {
        let clock = Clock { budget: Duration::from_millis(2), gives_up: false };
        let mut calls = 0_u64;
        let short = clock.time(|| calls += 1);
        assert!(
            short.runs >= FEWEST
                && calls > short.runs as u64
                && short.min_ns <= short.median_ns
                && short.median_ns <= short.quartile_ns
        );
        let long = |clock: Clock| {
            let mut calls = 0;
            let timing = clock.time(|| {
                calls += 1;
                std::thread::sleep(Duration::from_millis(20));
            });
            assert!(timing.median_ns >= 2e7 && timing.scaled(2.0).median_ns >= 4e7);
            (timing.runs, calls)
        };
        assert_eq!(long(clock), (FEWEST, 1 + FEWEST));
        assert_eq!(long(clock.of_quadratic()), (1, 1));
        assert_eq!(long(Clock { budget: Duration::ZERO, ..clock }), (1, 1));
    }
}

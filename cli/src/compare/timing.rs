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

impl Clock {
    /// Times `run`, after one run to warm caches and branch prediction. The drop of its result is not timed
    /// where one run is long enough to be timed alone.
    pub(crate) fn time<T>(&self, mut run: impl FnMut() -> T) -> Timing {
        let begin = Instant::now();
        let warm = elapsed(&mut run);
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

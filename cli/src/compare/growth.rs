//! Time against size: the same sphere, cut finer and finer.

use super::fill::per_vertex;
use super::measure::{Depth, Plan};
use super::record::{Grown, Growth, InOrder};
use super::sample::{Sample, Soup};
use super::subject::SUBJECTS;
use crate::args;
use crate::default_mesh;
use crate::timing::Clock;
use std::time::{Duration, Instant};

/// From 320 triangles to 5,242,880, four times as many each time.
const LEVELS: std::ops::RangeInclusive<usize> = 2..=9;
/// So many budgets may be spent on all sizes together; two sizes are measured in any case.
const BUDGETS: u32 = 300;

/// Measures these places of [`SUBJECTS`] until the next size would take too long.
pub(super) fn measured(options: &args::Compare, chosen: &[usize]) -> Growth {
    let clock = Clock { budget: Duration::from_millis(options.budget), gives_up: false }.of_quadratic();
    let line = |&place: &usize| Grown { name: SUBJECTS[place].name, points: Vec::new() };
    let mut growth = Growth {
        mesh: "a sphere (made here)",
        triangles: Vec::new(),
        backends: chosen.iter().map(line).collect(),
    };
    let start = Instant::now();
    for level in LEVELS {
        let begin = Instant::now();
        let made = default_mesh::sphere(level);
        let soup = Soup { vertex_count: made.positions.len(), faces: made.faces, is_clean: true };
        let sample = Sample::of(&soup, options.seed);
        let plan = Plan { soup: &soup, sample: &sample, clock, depth: Depth::Sweep };
        for (line, &place) in growth.backends.iter_mut().zip(chosen) {
            line.points.extend((SUBJECTS[place].measure)(&plan).ok().map(|measured| {
                let sweep = measured.sweep.map(|timing| per_vertex(timing, &soup));
                InOrder { build: measured.build[0].1, sweep }
            }));
        }
        growth.triangles.push(soup.faces.len());
        // Four times the triangles take four times as long, or more out of cache.
        if growth.triangles.len() > 1 && start.elapsed() + 5 * begin.elapsed() > BUDGETS * clock.budget {
            break;
        }
    }
    growth
}

//! The lines, and what can be counted of them.

use crate::failure::Failure;
use crate::level::Levels;
use crate::surface::Surface;
use onering::{Adjacency, contours, vector};
use onering_io::Lines;
use std::time::Instant;

/// More pieces of line are refused: they take some 50 bytes each, and nobody could look at them.
const MOST_PIECES: usize = 100_000_000;

/// Lines at some levels.
#[derive(Debug)]
pub(crate) struct Traced {
    /// In the coordinates of the file.
    pub(crate) lines: Lines,
    /// For each level.
    pub(crate) figures: Vec<Figures>,
    /// How long it took to trace them, on the structure as it is built.
    pub(crate) seconds: f64,
}

/// What is counted at a level.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Figures {
    pub(crate) closed: usize,
    pub(crate) open: usize,
    pub(crate) length: f64,
}

impl Traced {
    pub(crate) fn of<M: Adjacency>(mesh: &M, surface: &Surface, levels: &Levels) -> Result<Self, Failure> {
        let (field, positions) = (surface.field(), surface.positions());
        let heights = levels.heights();
        let start = Instant::now();
        let contours = contours::contours(mesh, &field, &heights).map_err(|error| surface.failure(&error))?;
        let seconds = start.elapsed().as_secs_f64();
        let (mut lines, mut figures) = (Lines::new("level"), vec![Figures::default(); heights.len()]);
        for line in contours.lines() {
            let figures = &mut figures[heights.partition_point(|height| *height < line.level)];
            *if line.is_closed { &mut figures.closed } else { &mut figures.open } += 1;
            figures.length += line.length(mesh, &positions);
            let point = |crossing: &contours::Crossing<_>| vector::rounded(crossing.point(mesh, &positions));
            lines
                .push(line.crossings.iter().map(point), line.is_closed, line.level)
                .map_err(|error| surface.failure(&error))?;
        }
        Ok(Self { lines, figures, seconds })
    }
}

/// Refuses levels that would cross so many faces that memory might end. Linear in the faces, but for a logarithm.
///
/// # Errors
/// A line that says how many pieces there would be.
pub(crate) fn check_size(surface: &Surface, levels: &Levels) -> Result<(), Failure> {
    let heights = levels.heights();
    let rank = |v: u32| {
        let value = surface.value(surface.mesh.positions[v as usize]);
        heights.partition_point(|height| *height <= value)
    };
    let crossed = |face: &[u32; 3]| {
        let [a, b, c] = face.map(rank);
        a.max(b).max(c) - a.min(b).min(c)
    };
    match surface.mesh.faces.iter().map(crossed).sum() {
        0..=MOST_PIECES => Ok(()),
        pieces => Err(Failure::Usage(format!(
            "{}: {} levels cross its faces {pieces} times, of which at most {MOST_PIECES} are drawn; ask for fewer levels",
            surface.name,
            heights.len(),
        ))),
    }
}

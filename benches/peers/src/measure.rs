//! One mesh, all structures: in each round every one after the other, so that what else runs on the machine meets all.

use crate::mesh::Rings;
use crate::peer::Run;
use crate::process::Program;
use serde::Serialize;
use std::path::Path;
use std::time::Duration;

/// One structure on one mesh.
#[derive(Debug, Serialize)]
pub(crate) struct Row {
    pub(crate) peer: String,
    /// Medians; or why there are none.
    #[serde(flatten)]
    pub(crate) outcome: Outcome,
}

/// What came of it.
#[derive(Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Outcome {
    Medians(Medians),
    Refused(String),
}

/// The medians of all rounds.
#[derive(Debug, Serialize)]
pub(crate) struct Medians {
    pub(crate) build_seconds: f64,
    pub(crate) sweep_seconds: Option<f64>,
    pub(crate) live_bytes: usize,
    pub(crate) peak_bytes: usize,
    /// The answers that they are made of.
    pub(crate) rounds: Vec<Run>,
}

impl Row {
    pub(crate) fn medians(&self) -> Option<&Medians> {
        match &self.outcome {
            Outcome::Medians(medians) => Some(medians),
            Outcome::Refused(_) => None,
        }
    }
}

/// Every structure on the mesh in the file `mesh`, whose rings are `expected`. One that fails is not asked again.
pub(crate) fn mesh(
    programs: &[Program],
    mesh: &Path,
    expected: &Rings,
    rounds: usize,
    limit: Duration,
) -> Vec<Row> {
    let mut answers: Vec<Result<Vec<Run>, String>> = programs.iter().map(|_| Ok(Vec::new())).collect();
    for _ in 0..rounds {
        for (program, answer) in programs.iter().zip(&mut answers) {
            let Ok(runs) = answer else { continue };
            match program.run(mesh, limit).and_then(|run| checked(run, expected)) {
                Ok(run) => runs.push(run),
                Err(reason) => *answer = Err(reason),
            }
        }
    }
    let row = |(program, answer): (&Program, Result<Vec<Run>, String>)| Row {
        peer: program.name.clone(),
        outcome: match answer.map(Medians::of) {
            Ok(Some(medians)) => Outcome::Medians(medians),
            Ok(None) => Outcome::Refused("not asked".into()),
            Err(reason) => Outcome::Refused(reason),
        },
    };
    programs.iter().zip(answers).map(row).collect()
}

fn checked(run: Run, expected: &Rings) -> Result<Run, String> {
    match run.checksum {
        Some(checksum) if checksum != expected.checksum => Err("its rings are not those of the faces".into()),
        _ => Ok(run),
    }
}

impl Medians {
    fn of(rounds: Vec<Run>) -> Option<Self> {
        let last = *rounds.last()?;
        let sweeps: Option<Vec<f64>> = rounds.iter().map(|run| run.sweep_seconds).collect();
        Some(Self {
            build_seconds: median(rounds.iter().map(|run| run.build_seconds).collect()),
            sweep_seconds: sweeps.map(median),
            live_bytes: last.live_bytes,
            peak_bytes: last.peak_bytes,
            rounds,
        })
    }
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

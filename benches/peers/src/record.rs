//! What was measured, as the file of JSON has it. The file is written after every round and read at the start, so that a
//! long run may be stopped, or made mesh by mesh.

use serde::{Deserialize, Serialize};
use std::error::Error;
use std::fmt::{Display, Formatter};
use std::fs;
use std::path::Path;

/// The tasks of a structure; the programs in C++ name them alike.
pub(crate) const BUILD: &str = "build";
pub(crate) const RING: &str = "ring";
pub(crate) const FOUR_RING: &str = "four_ring";
/// The phases of a build.
pub(crate) const COPY: &str = "copy";
pub(crate) const CHECK: &str = "check";
pub(crate) const PAIR: &str = "pair";
pub(crate) const LINKS: &str = "links";

/// All that was measured on one machine.
#[derive(Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Record {
    /// The processor, the compilers, and what they compiled for.
    pub(crate) machine: String,
    pub(crate) meshes: Vec<Table>,
}

/// All structures on one mesh.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Table {
    pub(crate) mesh: String,
    pub(crate) triangles: usize,
    pub(crate) vertices: usize,
    /// How many 4-rings the task of that name searches.
    pub(crate) four_rings: usize,
    pub(crate) rows: Vec<Row>,
}

/// One structure on one mesh.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Row {
    pub(crate) peer: String,
    pub(crate) runs: Vec<Run>,
    /// Why there are no more.
    pub(crate) left_out: Option<LeftOut>,
}

/// Why a structure is not measured on a mesh.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum LeftOut {
    /// It did not end within so many seconds, here or on a smaller mesh.
    OverSeconds(u64),
    /// The library refuses, fails, or is wrong.
    Failed(String),
}

impl Display for LeftOut {
    fn fmt(&self, f: &mut Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::OverSeconds(seconds) => write!(f, "left out: over {seconds} s"),
            Self::Failed(reason) => write!(f, "left out: {reason}"),
        }
    }
}

/// What one process tells of one structure.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Run {
    pub(crate) tasks: Vec<Task>,
    pub(crate) live_bytes: usize,
    pub(crate) peak_bytes: usize,
    /// Of the whole process by the clock, with what is not timed.
    #[serde(default)]
    pub(crate) elapsed: f64,
}

/// One thing that it did, and what came out, where that can be compared.
#[derive(Clone, Debug, Deserialize, PartialEq, Serialize)]
pub(crate) struct Task {
    pub(crate) task: String,
    pub(crate) seconds: f64,
    pub(crate) answer: Option<u64>,
}

impl Run {
    pub(crate) fn seconds(&self, task: &str) -> Option<f64> {
        self.tasks.iter().find(|other| other.task == task).map(|task| task.seconds)
    }
}

impl Row {
    /// The median of all runs.
    pub(crate) fn median(&self, task: &str) -> Option<f64> {
        let mut seconds: Vec<f64> = self.runs.iter().filter_map(|run| run.seconds(task)).collect();
        seconds.sort_by(f64::total_cmp);
        seconds.get(seconds.len() / 2).copied()
    }

    /// Seconds that all runs took, with what is not timed.
    pub(crate) fn spent(&self) -> f64 {
        self.runs.iter().map(|run| run.elapsed).sum()
    }

    /// One of ours, as a user has it.
    pub(crate) fn is_ours(&self) -> bool {
        self.peer.starts_with("onering ")
    }
}

impl Table {
    /// The structure that gave another answer to the same task: one of the two is wrong.
    pub(crate) fn contradicts(&self, run: &Run) -> Option<&str> {
        let differs = |task: &Task, other: &Task| {
            task.task == other.task && task.answer.zip(other.answer).is_some_and(|(a, b)| a != b)
        };
        let differs_from = |row: &&Row| {
            let mut others = row.runs.iter().flat_map(|run| &run.tasks);
            others.any(|other| run.tasks.iter().any(|task| differs(task, other)))
        };
        self.rows.iter().find(differs_from).map(|row| &*row.peer)
    }

    pub(crate) fn row(&self, peer: &str) -> Option<&Row> {
        self.rows.iter().find(|row| row.peer == peer)
    }
}

impl Record {
    /// What the file has from before; nothing where there is no file.
    pub(crate) fn read(path: &Path, machine: &str) -> Result<Self, Box<dyn Error>> {
        if !path.exists() {
            return Ok(Self { machine: machine.into(), meshes: Vec::new() });
        }
        let named = |error: String| format!("{}: {error}", path.display());
        let text = fs::read_to_string(path).map_err(|error| named(error.to_string()))?;
        let record: Self = serde_json::from_str(&text).map_err(|error| named(error.to_string()))?;
        if record.machine != machine {
            return Err(named(format!("measured on {}, and this is {machine}", record.machine)).into());
        }
        Ok(record)
    }

    /// Under a name of its own first: whoever stops the run keeps the file as it was.
    pub(crate) fn write(&self, path: &Path) -> std::io::Result<()> {
        let unfinished = path.with_extension("unfinished");
        fs::write(&unfinished, serde_json::to_string_pretty(self)?)?;
        fs::rename(&unfinished, path)
    }

    pub(crate) fn table(&self, mesh: &str) -> Option<&Table> {
        self.meshes.iter().find(|table| table.mesh == mesh)
    }

    /// Why a structure need not be tried: it took too long on a mesh of fewer triangles.
    pub(crate) fn hopeless(&self, peer: &str, triangles: usize) -> Option<LeftOut> {
        let smaller = self.meshes.iter().filter(|table| table.triangles < triangles);
        let mut reasons = smaller.filter_map(|table| table.row(peer)?.left_out.clone());
        reasons.find(|reason| matches!(reason, LeftOut::OverSeconds(_)))
    }

    /// The table of a mesh in place of the one that there was.
    pub(crate) fn put(&mut self, table: &Table) {
        match self.meshes.iter_mut().find(|other| other.mesh == table.mesh) {
            Some(other) => other.clone_from(table),
            None => self.meshes.push(table.clone()),
        }
    }
}

//! One mesh, all structures: in each round every one after the other, so that what else runs on the machine meets all.

use crate::expected::Expected;
use crate::process::Program;
use crate::record::{LeftOut, Row, Run, Table};
use std::path::Path;
use std::time::Duration;

/// How long a structure is measured on one mesh.
#[derive(Clone, Copy)]
pub(crate) struct Effort {
    pub(crate) rounds: usize,
    /// For one process; one that takes longer is left out.
    pub(crate) limit: Duration,
    /// For all rounds: whoever has taken so long is not asked again.
    pub(crate) budget: Duration,
}

impl Effort {
    /// Whether who was left out before stays so: there may be more time now.
    pub(crate) fn is_final(self, reason: &LeftOut) -> bool {
        match reason {
            LeftOut::OverSeconds(seconds) => *seconds >= self.limit.as_secs(),
            LeftOut::Failed(_) => true,
        }
    }

    /// Whether this row has all that it gets.
    pub(crate) fn is_done(self, row: &Row) -> bool {
        let is_left_out = row.left_out.as_ref().is_some_and(|reason| self.is_final(reason));
        is_left_out || row.runs.len() >= self.rounds || row.spent() >= self.budget.as_secs_f64()
    }
}

/// Adds to the table what it lacks, from the mesh in `file`; `save` comes after every round. A structure that fails is
/// not asked again.
pub(crate) fn mesh(
    programs: &[Program],
    file: &Path,
    expected: &Expected,
    effort: Effort,
    table: &mut Table,
    mut save: impl FnMut(&Table) -> std::io::Result<()>,
) -> std::io::Result<()> {
    for round in 0..effort.rounds {
        for program in programs {
            let before = row(table, &program.name);
            if effort.is_done(before) || before.runs.len() > round {
                continue;
            }
            let outcome = program.run(file, effort.limit).and_then(|run| checked(run, expected, table));
            let row = row(table, &program.name);
            match outcome {
                Ok(run) => {
                    row.runs.push(run);
                    row.left_out = None;
                }
                Err(reason) => {
                    eprintln!("{}: {reason}", program.name);
                    row.left_out = Some(reason);
                }
            }
        }
        save(table)?;
    }
    Ok(())
}

/// The row of a structure, at the end where there is none yet.
pub(crate) fn row<'a>(table: &'a mut Table, peer: &str) -> &'a mut Row {
    let at = table.rows.iter().position(|row| row.peer == peer).unwrap_or_else(|| {
        table.rows.push(Row { peer: peer.into(), runs: Vec::new(), left_out: None });
        table.rows.len() - 1
    });
    &mut table.rows[at]
}

fn checked(run: Run, expected: &Expected, table: &Table) -> Result<Run, LeftOut> {
    let run = expected.check(run).map_err(LeftOut::Failed)?;
    match table.contradicts(&run) {
        Some(peer) => Err(LeftOut::Failed(format!("it contradicts {peer}"))),
        None => Ok(run),
    }
}

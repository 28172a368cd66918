//! One structure in a process of its own: it starts with a fresh heap, and may abort or hang without taking the others
//! along. This program runs itself for the Rust libraries, and the programs of `cpp/` for the others.

use crate::record::{LeftOut, Run};
use std::io::Read;
use std::path::Path;
use std::process::{Command, ExitStatus, Stdio};
use std::thread;
use std::time::{Duration, Instant};

/// What runs a structure.
pub(crate) struct Program {
    pub(crate) name: String,
    pub(crate) command: fn(&str, &Path) -> Command,
}

impl Program {
    /// Measures on the mesh in the file `mesh`; why not, where the library refuses, fails or takes too long.
    pub(crate) fn run(&self, mesh: &Path, limit: Duration) -> Result<Run, LeftOut> {
        let mut command = (self.command)(&self.name, mesh);
        let start = Instant::now();
        let output = output(&mut command, limit)?;
        let run: Run = serde_json::from_str(output.trim())
            .map_err(|error| LeftOut::Failed(format!("unclear answer: {error}")))?;
        Ok(Run { elapsed: start.elapsed().as_secs_f64(), ..run })
    }
}

/// What the command prints, which is short enough for the pipes to hold it.
fn output(command: &mut Command, limit: Duration) -> Result<String, LeftOut> {
    let start = Instant::now();
    let mut child = command
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|error| LeftOut::Failed(format!("not started: {error}")))?;
    let status = loop {
        match child.try_wait().map_err(|error| LeftOut::Failed(error.to_string()))? {
            Some(status) => break status,
            None if start.elapsed() < limit => thread::sleep(Duration::from_millis(2)),
            None => {
                let _ = child.kill();
                let _ = child.wait();
                return Err(LeftOut::OverSeconds(limit.as_secs()));
            }
        }
    };
    if status.success() {
        text(child.stdout.take())
    } else {
        Err(LeftOut::Failed(reason(status, &text(child.stderr.take())?)))
    }
}

fn text(stream: Option<impl Read>) -> Result<String, LeftOut> {
    let mut bytes = Vec::new();
    if let Some(mut stream) = stream {
        stream.read_to_end(&mut bytes).map_err(|error| LeftOut::Failed(error.to_string()))?;
    }
    Ok(String::from_utf8_lossy(&bytes).into_owned())
}

/// The last line that says something; else how the process ended.
fn reason(status: ExitStatus, errors: &str) -> String {
    let mut lines =
        errors.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with("note:"));
    lines.next_back().map_or_else(|| status.to_string(), str::to_owned)
}

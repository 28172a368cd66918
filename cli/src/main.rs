//! onering at the shell: `inspect` tells what is in a mesh file, `convert` makes another one of it, `compare` measures
//! the data structures on it.
//! Thin over the library: what it prints, the crates `onering` and `onering-io` can be asked for.

mod args;
mod compare;
mod convert;
mod default_mesh;
mod heap;
mod input;
mod inspect;
mod output;
mod progress;
mod shell;

use args::Command;
use output::Status;
use std::io::{self, ErrorKind};
use std::process::ExitCode;

#[global_allocator]
static HEAP: heap::Counting = heap::Counting;

fn main() -> ExitCode {
    finish(args::read().and_then(|command| match command {
        None => Ok(Status::Done),
        Some(Command::Inspect(options)) => inspect::run(&options),
        Some(Command::Convert(options)) => convert::run(&options),
        Some(Command::Compare(options)) => compare::run(&options),
        Some(Command::Completions(options)) => shell::completions(&options),
        Some(Command::Man(options)) => shell::man(&options),
    }))
}

/// Whoever reads our output may stop early, as `head` does: that is no error.
fn finish(end: io::Result<Status>) -> ExitCode {
    match end {
        Ok(status) => status.into(),
        Err(error) if error.kind() == ErrorKind::BrokenPipe => ExitCode::SUCCESS,
        Err(error) => {
            output::complain(&format!("standard output: {error}"));
            Status::Partly.into()
        }
    }
}

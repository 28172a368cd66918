//! onering at the shell: `inspect` tells what is in a mesh file, `convert` makes another one of it, `compare` measures
//! the data structures on it, `recommend` says which to take, `query` asks one what is around an element, `contours`,
//! `minima` and `region` look for what its heights have, `deform` presses it.
//! Thin over the library: what it prints, the crates `onering` and `onering-io` can be asked for.

mod args;
mod at;
mod compare;
mod contours;
mod convert;
mod default_mesh;
mod deform;
mod failure;
mod heap;
mod input;
mod inspect;
mod level;
mod line_file;
mod machine;
mod made;
mod minima;
mod on_backend;
mod output;
mod picture;
mod progress;
mod query;
mod random;
mod recommend;
mod region;
mod shell;
mod surface;
mod svg_map;
mod tables;
mod timing;
mod up;

use args::Command;
use output::Status;
use std::io::{self, ErrorKind};
use std::process::ExitCode;

#[global_allocator]
static HEAP: heap::Counting = heap::Counting;

fn main() -> ExitCode {
    outlive_full_files();
    finish(args::read().and_then(|command| match command {
        None => Ok(Status::Done),
        Some(Command::Inspect(options)) => inspect::run(&options),
        Some(Command::Convert(options)) => convert::run(&options),
        Some(Command::Compare(options)) => compare::run(&options),
        Some(Command::Recommend(options)) => recommend::run(&options),
        Some(Command::Query(options)) => query::run(&options),
        Some(Command::Contours(options)) => contours::run(&options),
        Some(Command::Minima(options)) => minima::run(&options),
        Some(Command::Region(options)) => region::run(&options),
        Some(Command::Deform(options)) => deform::run(&options),
        Some(Command::Completions(options)) => shell::completions(&options),
        Some(Command::Man(options)) => shell::man(&options),
    }))
}

/// A file that grows beyond what the system allows is an error to be told of, as a full disk is. Without a handler the
/// signal ends the process, and leaves behind what was written so far.
fn outlive_full_files() {
    #[cfg(unix)]
    {
        use signal_hook::{consts::SIGXFSZ, flag};
        use std::sync::{Arc, atomic::AtomicBool};
        // Where it cannot be had, all is as without it.
        let _ = flag::register(SIGXFSZ, Arc::new(AtomicBool::new(false)));
    }
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

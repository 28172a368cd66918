//! What can be said on the command line.

mod compare;
mod contours;
mod convert;
mod deform;
mod formats;
mod heights;
mod inspect;
mod mesh_file;
mod minima;
mod query;
mod recommend;
mod region;

pub(crate) use compare::Compare;
pub(crate) use contours::Contours;
pub(crate) use convert::Convert;
pub(crate) use deform::{Deform, Fix};
pub(crate) use formats::{is_written, written};
pub(crate) use heights::Heights;
pub(crate) use inspect::Inspect;
pub(crate) use mesh_file::{MeshFile, Structure};
pub(crate) use minima::Minima;
pub(crate) use query::{GRAPH, Query};
pub(crate) use recommend::Recommend;
pub(crate) use region::Region;

use crate::output::{self, Status};
use clap::{CommandFactory, Parser, Subcommand};
use clap_complete::Shell;
use std::io::{self, Write};
use std::path::PathBuf;
use std::process;

/// One Topology trait, every triangle-mesh data structure.
///
/// Without a command: the same as `onering compare`.
#[derive(Debug, Parser)]
#[command(name = "onering", version, after_help = EXIT_CODES)]
struct Args {
    #[command(subcommand)]
    command: Option<Command>,
}

const EXIT_CODES: &str = "\
Exit codes:
  0  all was done
  1  some files could not be read, backends gave different answers, a mesh could not be made, or output could not
     be written (a reader of a pipe that stops early is no failure: 0)
  2  wrong usage, or no file could be read";

#[derive(Debug, Subcommand)]
pub(crate) enum Command {
    Inspect(Inspect),
    Convert(Convert),
    Compare(Compare),
    Recommend(Recommend),
    Query(Query),
    Minima(Minima),
    Region(Region),
    Contours(Contours),
    Deform(Deform),
    Completions(Completions),
    Man(Man),
}

/// Print what has a shell complete the words of `onering`
///
/// For bash: `onering completions bash > ~/.local/share/bash-completion/completions/onering`.
#[derive(Debug, clap::Args)]
pub(crate) struct Completions {
    /// The shell
    #[arg(value_name = "SHELL")]
    pub(crate) shell: Shell,
}

/// Print the manual pages, of `onering` and of each command, one after the other
///
/// To read them: `onering man | man -l -`.
#[derive(Debug, clap::Args)]
pub(crate) struct Man {
    /// Write them to this folder instead, a file each; it is made where there is none
    #[arg(long, value_name = "FOLDER")]
    pub(crate) out: Option<PathBuf>,
}

/// Reads the command line; `None` where help or the version was asked for, and is printed. Where the line is wrong,
/// says so and ends the process with 2.
pub(crate) fn read() -> io::Result<Option<Command>> {
    let args = match Args::try_parse() {
        Err(error) if error.use_stderr() => error.exit(),
        // `Args::parse` would not tell whether it could be written.
        Err(text) => return text.print().and_then(|()| io::stdout().flush()).map(|()| None),
        Ok(args) => args,
    };
    let mut command = args.command.unwrap_or_else(|| Command::Compare(Compare::default()));
    match &mut command {
        Command::Inspect(inspect) => inspect.check(),
        Command::Convert(convert) => convert.check(),
        Command::Compare(compare) => compare.check(),
        Command::Query(query) => query.check(),
        Command::Region(region) => region.check(),
        Command::Deform(deform) => deform.check(),
        Command::Contours(of) => of.mesh.spare(&[("--lines", &of.lines), ("--svg", &of.svg)]),
        Command::Minima(of) => of.mesh.spare(&[("--points", &of.points), ("--svg", &of.svg)]),
        Command::Recommend(recommend) => recommend.check(),
        Command::Completions(_) | Command::Man(_) => {}
    }
    Ok(Some(command))
}

/// The whole command line, to be described.
pub(crate) fn command() -> clap::Command {
    Args::command()
}

/// Says in a line what is wrong with the command line, and ends the process with 2.
fn fail(message: &str) -> ! {
    output::complain(message);
    process::exit(Status::Nothing as i32)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_well_formed() {
        command().debug_assert();
    }
}

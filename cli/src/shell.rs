//! What a shell and its user want to know of this program: completions, and pages of the manual.

use crate::args;
use crate::output::{self, Status};
use clap_mangen::Man;
use onering_io::Replacement;
use std::fs;
use std::io::{self, Write};
use std::path::Path;

/// `onering completions`.
pub(crate) fn completions(options: &args::Completions) -> io::Result<Status> {
    // `generate` panics where it cannot write, so that it writes to memory.
    let mut script = Vec::new();
    clap_complete::generate(options.shell, &mut args::command(), "onering", &mut script);
    print(&script)
}

/// `onering man`.
pub(crate) fn man(options: &args::Man) -> io::Result<Status> {
    let pages = pages()?;
    let Some(folder) = &options.out else {
        let all: Vec<u8> = pages.into_iter().flat_map(|(_, roff)| roff).collect();
        return print(&all);
    };
    match write(folder, &pages) {
        Ok(()) => Ok(Status::Done),
        Err(error) => {
            output::complain(&format!("{}: {error}", folder.display()));
            Ok(Status::Partly)
        }
    }
}

/// Every page with the name of its file: that of the program, then that of each command.
fn pages() -> io::Result<Vec<(String, Vec<u8>)>> {
    let mut program = args::command().disable_help_subcommand(true);
    program.build();
    let commands = program.get_subcommands().cloned().collect::<Vec<_>>();
    std::iter::once(program).chain(commands).map(page).collect()
}

fn page(command: clap::Command) -> io::Result<(String, Vec<u8>)> {
    let man = Man::new(command);
    let mut roff = Vec::new();
    man.render(&mut roff)?;
    Ok((man.get_filename(), roff))
}

fn write(folder: &Path, pages: &[(String, Vec<u8>)]) -> io::Result<()> {
    fs::create_dir_all(folder)?;
    for (name, roff) in pages {
        let mut file = Replacement::create(&folder.join(name))?;
        file.write_all(roff)?;
        file.finish()?;
    }
    Ok(())
}

fn print(bytes: &[u8]) -> io::Result<Status> {
    let mut out = io::stdout().lock();
    out.write_all(bytes)?;
    out.flush()?;
    Ok(Status::Done)
}

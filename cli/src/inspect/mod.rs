//! `onering inspect`: everything that can be said of a mesh file.

mod digest;
mod figures;
mod geometry;
mod text;
mod verdict;

use crate::args;
use crate::output::{self, Status};
use figures::Inspection;
use std::io;

/// Inspects every file that can be read, and complains of the others.
pub(crate) fn run(options: &args::Inspect) -> io::Result<Status> {
    let (mut read, mut unread) = (0, 0);
    for file in &options.files {
        match Inspection::of(file, options.format) {
            Ok(inspection) => {
                show(&inspection, options.json)?;
                read += 1;
            }
            Err(error) => {
                output::complain(&error);
                unread += 1;
            }
        }
    }
    Ok(Status::of(read, unread))
}

fn show(inspection: &Inspection, json: bool) -> io::Result<()> {
    let text = if json { serde_json::to_string(inspection)? + "\n" } else { text::lines(inspection) };
    output::print(&text)
}

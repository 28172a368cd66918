//! Looks for a list of faces on which a build takes more than n log n instructions. `benches/instructions/growth` runs
//! this under callgrind, which writes a file each time that `collected` returns, to be read here at once: so what is
//! tried next can go by what was found.
//!
//! A list is made at n faces, and at 4n. From one size to the next another strategy may be taken, once, and so a list of
//! which the count grows by too much is made at 16n, and again four times larger, as long as it does.
#[path = "../../meshes/mod.rs"]
mod meshes;
mod pieces;
mod recipe;
mod search;
mod subjects;

use std::env;
use std::fs;
use std::path::PathBuf;
use std::process::ExitCode;

/// Callgrind collects in this function alone, by its name, and writes what it collected whenever it returns.
#[inline(never)]
fn collected(run: &dyn Fn()) {
    run();
}

/// What callgrind counted, by its files.
struct Counter {
    folder: PathBuf,
    part: usize,
}

impl Counter {
    /// The instructions of a run, those of libc among them, which grow with the list as well.
    fn count(&mut self, run: &dyn Fn()) -> u64 {
        collected(run);
        self.part += 1;
        let file = self.folder.join(format!("part.{}", self.part));
        let text = fs::read_to_string(&file).expect("a file of callgrind, under which this runs");
        fs::remove_file(&file).expect("a file of ours");
        let totals = text.lines().find_map(|line| line.strip_prefix("totals: "));
        totals.and_then(|count| count.trim().parse().ok()).expect("a sum of what was collected")
    }
}

/// `LISTS SEED FACES FOLDER`; without them, as where it is run like any benchmark, some small lists, uncounted.
fn main() -> ExitCode {
    let words: Vec<String> = env::args().skip(1).collect();
    let [lists, seed, faces, folder] = &words[..] else {
        search::try_out(300);
        return ExitCode::SUCCESS;
    };
    let [lists, seed, faces] = [lists, seed, faces].map(|word| word.parse().expect("a number"));
    search::search(lists, seed, faces as usize, &mut Counter { folder: folder.into(), part: 0 })
}

//! `onering contours`: what can be said of it.

use super::{EXIT_CODES, Heights, MeshFile};
use clap::ArgGroup;
use std::path::PathBuf;

/// The most levels that can be asked for.
const MOST_LEVELS: u32 = 100_000;

/// Draw the lines of equal height on a mesh
///
/// Prints each level with its lines and their length. Without levels, a round step is taken that makes 15 to 38.
#[derive(Debug, clap::Args)]
#[command(after_help = EXIT_CODES, group = ArgGroup::new("which levels"))]
pub(crate) struct Contours {
    #[command(flatten)]
    pub(crate) mesh: MeshFile,
    #[command(flatten)]
    pub(crate) heights: Heights,
    /// So many levels, which divide the range into equal parts
    #[arg(long, value_name = "NUMBER", group = "which levels",
          value_parser = clap::value_parser!(u32).range(1..=i64::from(MOST_LEVELS)))]
    pub(crate) levels: Option<u32>,
    /// The multiples of this height
    #[arg(long, value_name = "HEIGHT", group = "which levels", value_parser = step)]
    pub(crate) step: Option<f64>,
    /// These levels, with commas between them
    #[arg(long, value_name = "HEIGHT", group = "which levels", value_delimiter = ',',
          allow_hyphen_values = true, value_parser = level)]
    pub(crate) at: Vec<f32>,
    /// Find the local minima as well, for the map
    #[arg(long)]
    pub(crate) minima: bool,
    /// Print one JSON object
    #[arg(long)]
    pub(crate) json: bool,
    /// Write the lines to this file: .obj, or .ply with levels and colours
    #[arg(long, value_name = "FILE")]
    pub(crate) lines: Option<PathBuf>,
    /// Draw a map, seen from above, to this file
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
}

fn level(word: &str) -> Result<f32, &'static str> {
    word.parse().ok().filter(|value: &f32| value.is_finite()).ok_or("not a height")
}

fn step(word: &str) -> Result<f64, &'static str> {
    word.parse().ok().filter(|step: &f64| *step > 0.0 && step.is_finite()).ok_or("not a height above 0")
}

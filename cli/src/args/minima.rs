//! `onering minima`: what can be said of it.

use super::{EXIT_CODES, Heights, MeshFile};
use std::path::PathBuf;

/// Find the local minima of a mesh, such as hollows and the tips of stalactites
///
/// A plateau is one minimum. Prints each with its vertex, counted from 0, its position and its height.
#[derive(Debug, clap::Args)]
#[command(after_help = EXIT_CODES)]
pub(crate) struct Minima {
    #[command(flatten)]
    pub(crate) mesh: MeshFile,
    #[command(flatten)]
    pub(crate) heights: Heights,
    /// Find local maxima as well
    #[arg(long)]
    pub(crate) maxima: bool,
    /// Find saddles as well
    #[arg(long)]
    pub(crate) saddles: bool,
    /// Only minima where the surface faces down: the tips of stalactites, on a cave whose faces are seen from inside
    #[arg(long, conflicts_with = "field")]
    pub(crate) stalactites: bool,
    /// Print one JSON object
    #[arg(long)]
    pub(crate) json: bool,
    /// Write what was found to this file, as points: .obj, or .ply with heights and colours
    #[arg(long, value_name = "FILE")]
    pub(crate) points: Option<PathBuf>,
    /// Draw a map, seen from above, to this file
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
}

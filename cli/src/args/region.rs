//! `onering region`: what can be said of it.

use super::{EXIT_CODES, MeshFile, Structure, formats};
use crate::at::At;
use crate::up::Up;
use onering_io::Format;
use std::path::PathBuf;

/// Cut the stalactite out of a cave that a point is on
///
/// From the point down to a tip, and from there up over what is steep: prints area, box, vertices and triangles.
#[derive(Debug, clap::Args)]
#[command(after_help = EXIT_CODES)]
pub(crate) struct Region {
    #[command(flatten)]
    pub(crate) mesh: MeshFile,
    #[command(flatten)]
    pub(crate) structure: Structure,
    /// A vertex, counted from 0, or a point: that means the vertex nearest to it [default: the lowest tip that there is,
    /// else the lowest vertex]
    #[arg(long, value_name = "VERTEX|X,Y,Z", allow_hyphen_values = true)]
    pub(crate) at: Option<At>,
    /// The angle with the horizontal from which on a face is steep, and so may be part of a stalactite
    #[arg(long, value_name = "DEGREES", default_value_t = 45.0, value_parser = angle)]
    pub(crate) steep: f64,
    /// The axis that points up: x, y, z, -x, -y or -z [default: as the format has it: y in glTF, X3D and VRML, else z]
    #[arg(long, value_name = "AXIS", allow_hyphen_values = true)]
    pub(crate) up: Option<Up>,
    /// The unit of the coordinates, to be said beside figures [default: m in glTF, X3D and VRML]
    #[arg(long, value_name = "NAME")]
    pub(crate) unit: Option<String>,
    /// Print one JSON object
    #[arg(long)]
    pub(crate) json: bool,
    #[arg(long, short, value_name = "OUT", help = out_help())]
    pub(crate) output: Option<PathBuf>,
    /// The format of OUT, whatever its name
    #[arg(long, value_name = "FORMAT", ignore_case = true, value_parser = formats::parse_written(), requires = "output")]
    pub(crate) to: Option<Format>,
}

impl Region {
    pub(super) fn check(&self) {
        formats::check_output(self.output.as_deref(), self.to);
    }
}

fn out_help() -> String {
    format!("Write the region as a mesh of its own: {}; `-` is standard output", formats::written())
}

fn angle(word: &str) -> Result<f64, &'static str> {
    word.parse().ok().filter(|angle| (0.0..=90.0).contains(angle)).ok_or("not an angle from 0 to 90")
}

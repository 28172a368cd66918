//! `onering region`: what can be said of it.

use super::{EXIT_CODES, MeshFile};
use crate::up::Up;
use std::path::PathBuf;
use std::str::FromStr;

/// Cut the stalactite out of a cave that a point is on
///
/// From the point down to a tip, and from there up over what is steep: prints area, box, vertices and triangles.
#[derive(Debug, clap::Args)]
#[command(after_help = EXIT_CODES)]
pub(crate) struct Region {
    #[command(flatten)]
    pub(crate) mesh: MeshFile,
    /// A vertex, counted from 0, or a point: that means the vertex nearest to it [default: the lowest tip that there is,
    /// else the lowest vertex]
    #[arg(long, value_name = "VERTEX|X,Y,Z", allow_hyphen_values = true)]
    pub(crate) at: Option<Seed>,
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
    /// Write the region to this file, as a mesh of its own, in the format that its name tells
    #[arg(long, short, value_name = "FILE")]
    pub(crate) output: Option<PathBuf>,
}

/// Where a region starts.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Seed {
    Vertex(usize),
    Point([f32; 3]),
}

impl FromStr for Seed {
    type Err = &'static str;

    fn from_str(words: &str) -> Result<Self, Self::Err> {
        let coordinate = |word: &str| word.trim().parse().ok().filter(|value: &f32| value.is_finite());
        let point = || words.split(',').map(coordinate).collect::<Option<Vec<f32>>>()?.try_into().ok();
        let vertex = words.parse().map(Self::Vertex).ok();
        vertex.or_else(|| point().map(Self::Point)).ok_or("neither the number of a vertex nor a point x,y,z")
    }
}

fn angle(word: &str) -> Result<f64, &'static str> {
    word.parse().ok().filter(|angle| (0.0..=90.0).contains(angle)).ok_or("not an angle from 0 to 90")
}

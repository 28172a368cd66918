//! `onering deform`: what can be said of it.

use super::{EXIT_CODES, MeshFile, Structure, fail, formats};
use crate::at::{At, parse_number, parse_vector};
use onering::vector::{self, Vector};
use onering_io::Format;
use std::path::PathBuf;
use std::str::FromStr;

/// Press a mesh of springs, and tell how long that takes
///
/// Along every edge is a spring (Biscaro et al. 2016, Eqs. 8 and 9). A force acts on a vertex and the rings around it,
/// other vertices are held, and the mesh comes to rest. Two times are told, those of the paper's Figs. 18 to 21: of
/// asking for the first ring of every vertex, and of the whole deformation, which asks once for every ring and then
/// solves the linear system.
#[derive(Debug, clap::Args)]
#[command(after_help = EXIT_CODES)]
pub(crate) struct Deform {
    #[command(flatten)]
    pub(crate) mesh: MeshFile,
    #[command(flatten)]
    pub(crate) structure: Structure,
    /// Where to press: a vertex by its number from 0 (once welded and repaired), or a point, whose nearest vertex is
    /// taken [default: the vertex farthest to the left, top and front]
    #[arg(long, value_name = "VERTEX|X,Y,Z", allow_hyphen_values = true)]
    pub(crate) at: Option<At>,
    /// The force [default: inwards, such that the mesh gives way by an eighth of its size]
    #[arg(long, value_name = "X,Y,Z", value_parser = parse_vector, allow_hyphen_values = true)]
    pub(crate) force: Option<Vector>,
    /// The force is spread over so many rings around the vertex, less on each than on the one before
    #[arg(long, value_name = "NUMBER", default_value_t = 3)]
    pub(crate) rings: usize,
    #[arg(long, value_name = "WHICH", default_value = "farthest:75", help = FIX_HELP, long_help = FIX_HELP)]
    pub(crate) fix: Fix,
    /// Force over displacement of each spring
    #[arg(long, allow_negative_numbers = true, value_name = "NUMBER", default_value_t = 1.0)]
    pub(crate) stiffness: f64,
    /// Stop where the forces left over are this share of those applied
    #[arg(long, allow_negative_numbers = true, value_name = "NUMBER", default_value_t = 1e-8)]
    pub(crate) tolerance: f64,
    /// Stop after so many iterations, which is an error where the mesh is not at rest by then
    #[arg(long, value_name = "NUMBER", default_value_t = 100_000)]
    pub(crate) max_iterations: usize,
    /// Move the mesh in time by so many steps, from rest, and not to where it comes to rest
    #[arg(long, value_name = "NUMBER", conflicts_with_all = ["tolerance", "max_iterations"])]
    pub(crate) steps: Option<usize>,
    /// Force of the medium over velocity, for --steps; each vertex has the mass 1
    #[arg(
        long,
        allow_negative_numbers = true,
        value_name = "NUMBER",
        default_value_t = 0.1,
        requires = "steps"
    )]
    pub(crate) damping: f64,
    #[arg(long, short, value_name = "OUT", help = out_help())]
    pub(crate) output: Option<PathBuf>,
    /// The format of OUT, whatever its name
    #[arg(long, value_name = "FORMAT", ignore_case = true, value_parser = formats::parse_written(), requires = "output")]
    pub(crate) to: Option<Format>,
    /// Draw the mesh before and after beside each other, tinted where it moved, into this PNG file
    #[arg(long, value_name = "FILE")]
    pub(crate) png: Option<PathBuf>,
    /// From where the picture looks at the mesh, as a direction [default: from over and beside where it is pressed]
    #[arg(long, value_name = "X,Y,Z", value_parser = parse_vector, requires = "png", allow_hyphen_values = true)]
    pub(crate) view: Option<Vector>,
    /// What is upwards in the picture
    #[arg(long, value_name = "X,Y,Z", value_parser = parse_vector, requires = "png", allow_hyphen_values = true, default_value = "0,1,0")]
    pub(crate) up: Vector,
    /// Pixels from the left of the picture to its right, 200 to 2400
    #[arg(long, value_name = "PIXELS", default_value_t = 1200, requires = "png",
          value_parser = clap::value_parser!(u16).range(200..=2400))]
    pub(crate) width: u16,
    /// Print one JSON object
    #[arg(long)]
    pub(crate) json: bool,
}

impl Deform {
    pub(super) fn check(&self) {
        self.mesh.spare(&[("--png", &self.png)]);
        let numbers = [
            ("stiffness", self.stiffness, true),
            ("tolerance", self.tolerance, true),
            ("damping", self.damping, false),
        ];
        for (name, value, is_positive) in numbers {
            if !value.is_finite() || value < 0.0 || is_positive && value == 0.0 {
                let least = if is_positive { "more than" } else { "at least" };
                fail(&format!("--{name} {value}: this has to be a number of {least} 0"));
            }
        }
        for (name, direction) in [("view", self.view), ("up", Some(self.up)), ("force", self.force)] {
            if direction.is_some_and(|direction| vector::direction(direction).is_none()) {
                fail(&format!(
                    "--{name} needs a direction: its length is zero, or too large to calculate with"
                ));
            }
        }
        formats::check_output(self.output.as_deref(), self.to);
    }
}

/// Which vertices stay where they are.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Fix {
    Boundary,
    /// So many in a hundred, those farthest from where it is pressed.
    Farthest(f64),
    /// All that are more than so many rings away.
    Beyond(usize),
    /// All whose coordinate (0 for x) is less.
    Below(usize, f64),
    Vertices(Vec<usize>),
}

const FIX_HELP: &str = "Which vertices are held: `farthest:PERCENT` in space, `beyond:RINGS`, `below:x=VALUE` (or y, z), \
    `boundary`, or a list of numbers as 3,14,15";

impl FromStr for Fix {
    type Err = String;

    fn from_str(word: &str) -> Result<Self, String> {
        let (kind, value) = word.split_once(':').unwrap_or((word, ""));
        match kind {
            "boundary" if value.is_empty() => Ok(Self::Boundary),
            "farthest" => match parse_number(value)? {
                percent if percent > 0.0 && percent < 100.0 => Ok(Self::Farthest(percent)),
                _ => Err("farthest:PERCENT is more than 0 and less than 100".into()),
            },
            "beyond" => {
                value.parse().map(Self::Beyond).map_err(|_| "beyond:RINGS needs a whole number".into())
            }
            "below" => {
                let (axis, value) = value.split_once('=').ok_or("as in below:z=0.5")?;
                let axis = ["x", "y", "z"].iter().position(|name| *name == axis);
                Ok(Self::Below(axis.ok_or("the axes are x, y and z")?, parse_number(value)?))
            }
            _ => {
                let numbers: Result<_, _> = word.split(',').map(str::parse).collect();
                numbers.map(Self::Vertices).map_err(|_| {
                    "this is boundary, farthest:PERCENT, beyond:RINGS, below:AXIS=VALUE, or numbers of vertices".into()
                })
            }
        }
    }
}

fn out_help() -> String {
    format!(
        "Write the deformed mesh, where OUT can hold it with the length of each vertex's displacement: {}; `-` is \
         standard output",
        formats::written()
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_held_is_understood_or_refused() {
        let fix = |word: &str| word.parse::<Fix>();
        assert_eq!(fix("boundary"), Ok(Fix::Boundary));
        assert_eq!(fix("farthest:25"), Ok(Fix::Farthest(25.0)));
        assert_eq!(fix("beyond:7"), Ok(Fix::Beyond(7)));
        assert_eq!(fix("below:z=-0.5"), Ok(Fix::Below(2, -0.5)));
        assert_eq!(fix("3,14"), Ok(Fix::Vertices(vec![3, 14])));
        for word in [
            "",
            "farthest",
            "farthest:0",
            "farthest:100",
            "farthest:nan",
            "beyond:-1",
            "below:w=1",
            "below:z",
            "1,x",
        ] {
            assert!(fix(word).is_err(), "{word}");
        }
    }
}

//! Places on a mesh, as words on the command line.

use onering::vector::Vector;
use std::str::FromStr;

/// A place on a mesh.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum At {
    Vertex(usize),
    /// The vertex nearest to it.
    Point(Vector),
}

impl FromStr for At {
    type Err = String;

    fn from_str(word: &str) -> Result<Self, String> {
        if word.contains(',') {
            return parse_vector(word).map(Self::Point);
        }
        word.parse()
            .map(Self::Vertex)
            .map_err(|_| "neither the number of a vertex nor three coordinates".into())
    }
}

/// Three finite numbers with commas between.
pub(super) fn parse_vector(word: &str) -> Result<Vector, String> {
    let numbers: Vec<f64> = word.split(',').map(number).collect::<Result<_, _>>()?;
    numbers.try_into().map_err(|_| "three numbers are needed, as in 0,0,-1".into())
}

pub(super) fn number(word: &str) -> Result<f64, String> {
    let number = word.trim().parse::<f64>().ok().filter(|number| number.is_finite());
    number.ok_or_else(|| format!("'{word}' is no finite number"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_place_is_a_vertex_or_a_point() {
        let at = |word: &str| word.parse::<At>();
        assert_eq!((at("12"), at("1,-2.5,3e2")), (Ok(At::Vertex(12)), Ok(At::Point([1.0, -2.5, 300.0]))));
        assert!(["-1", "1,2", "1,2,nan", "1,2,inf", "x"].iter().all(|word| at(word).is_err()));
    }
}

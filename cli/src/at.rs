//! A place on a mesh, as the command line names it.

use crate::failure::Failure;
use onering::vector::Vector;
use onering::{Handle, Map, VertexId, nearest};
use onering_io::Triangles;
use std::str::FromStr;

/// Where to begin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum At {
    Vertex(usize),
    /// The vertex nearest to it.
    Point(Vector),
}

impl At {
    /// The vertex that is meant. Nobody means one that is on no surface, so of those near a point only vertices of
    /// faces count. Linear.
    ///
    /// # Errors
    /// Wrong usage, where there is none.
    pub(crate) fn vertex(self, name: &str, mesh: &Triangles) -> Result<usize, Failure> {
        let count = mesh.positions.len();
        let found = match self {
            Self::Vertex(v) if v < count => Ok(v),
            Self::Vertex(v) => Err(format!("there is no vertex {v}: there are {count}, counted from 0")),
            Self::Point(point) => {
                nearest(mesh, point).ok_or("no vertex is near this point, which is too far away".into())
            }
        };
        found.map_err(|problem| Failure::Usage(format!("{name}: --at: {problem}")))
    }
}

fn nearest(mesh: &Triangles, point: Vector) -> Option<usize> {
    // A vertex that is nowhere is passed over.
    let mut positions: Map<VertexId, _> = Map::filled(mesh.positions.len(), [f32::NAN; 3]);
    for v in mesh.faces.as_flattened().iter().map(|&v| v as usize) {
        positions[VertexId::new(v)] = mesh.positions[v];
    }
    nearest::nearest_vertex(&positions, point).map(Handle::index)
}

impl FromStr for At {
    type Err = String;

    fn from_str(word: &str) -> Result<Self, String> {
        if word.contains(',') {
            return parse_vector(word).map(Self::Point);
        }
        let vertex = word.parse().map(Self::Vertex);
        vertex.map_err(|_| "neither the number of a vertex nor three coordinates".into())
    }
}

/// Three finite numbers with commas between.
pub(crate) fn parse_vector(word: &str) -> Result<Vector, String> {
    let numbers: Vec<f64> = word.split(',').map(parse_number).collect::<Result<_, _>>()?;
    numbers.try_into().map_err(|_| "three numbers are needed, as in 0,0,-1".into())
}

/// A finite number.
pub(crate) fn parse_number(word: &str) -> Result<f64, String> {
    let number = word.trim().parse::<f64>().ok().filter(|number| number.is_finite());
    number.ok_or_else(|| format!("'{word}' is no finite number"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::made::organ;

    #[test]
    fn a_place_is_a_vertex_or_a_point() {
        let at = |word: &str| word.parse::<At>();
        assert_eq!((at("12"), at("1,-2.5,3e2")), (Ok(At::Vertex(12)), Ok(At::Point([1.0, -2.5, 300.0]))));
        assert!(["-1", "1,2", "1,2,nan", "1,2,inf", "x"].iter().all(|word| at(word).is_err()));
    }

    #[test]
    fn a_point_leads_to_the_nearest_vertex_of_a_face() {
        let mut mesh = organ::of_size(500);
        let p = mesh.positions[77].map(|x| f64::from(x) + 1e-4);
        mesh.positions.push(p.map(|x| x as f32));
        assert_eq!(At::Point(p).vertex("organ", &mesh).unwrap(), 77);
        let count = mesh.positions.len();
        assert_eq!(At::Vertex(count - 1).vertex("organ", &mesh).unwrap(), count - 1);
        assert!(At::Vertex(count).vertex("organ", &mesh).is_err());
    }
}

//! Vertices, edges and faces by the names that people give them, whatever the structure.

use super::relation::Kind;
use onering_io::Triangles;
use std::collections::HashMap;
use std::str::FromStr;

/// What `--id` says: a number, or the two ends of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Id {
    Number(u32),
    Ends([u32; 2]),
}

impl FromStr for Id {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |word: &str| {
            let is_number = !word.is_empty() && word.bytes().all(|byte| byte.is_ascii_digit());
            let number = if is_number { word.parse().ok() } else { None };
            number.ok_or_else(|| "an id is a number, or the two vertices of an edge as in 3-17".to_owned())
        };
        Ok(match text.split_once(['-', ',']) {
            Some((a, b)) => Self::Ends([number(a)?, number(b)?]),
            None => Self::Number(number(text)?),
        })
    }
}

/// One element of a mesh. An edge is there by its ends, the lesser first; a cycle of three edges, which the bare graph
/// has for a face, by its vertices.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Element {
    Vertex(u32),
    Edge([u32; 2]),
    Face(u32),
    Cycle([u32; 3]),
}

impl Element {
    pub(crate) fn edge([a, b]: [u32; 2]) -> Self {
        Self::Edge([a.min(b), a.max(b)])
    }

    /// The one of this kind that `id` names in the mesh.
    ///
    /// # Errors
    /// A line that says why there is none.
    pub(crate) fn find(
        kind: Kind,
        id: Id,
        mesh: &Triangles,
        edges: Option<&EdgeNumbers>,
    ) -> Result<Self, String> {
        match (kind, id) {
            (Kind::Vertex, Id::Number(v)) => {
                in_range("vertex", v, mesh.positions.len(), "vertices").map(Self::Vertex)
            }
            (Kind::Face, Id::Number(f)) => in_range("face", f, mesh.faces.len(), "faces").map(Self::Face),
            (Kind::Edge, Id::Number(e)) => {
                let ends = edges.map_or(&[][..], |edges| &edges.ends);
                in_range("edge", e, ends.len(), "edges").map(|e| Self::Edge(ends[e as usize]))
            }
            (Kind::Edge, Id::Ends(ends)) => {
                let edge = Self::edge(ends);
                let mut sides = mesh.faces.iter().flat_map(|&face| sides(face));
                let [a, b] = ends;
                let missing = || format!("no edge {a}-{b}: the mesh has no face with this side");
                sides.any(|side| Self::Edge(side) == edge).then_some(edge).ok_or_else(missing)
            }
            (_, Id::Ends([a, b])) => Err(format!("{a}-{b} names an edge, and the relation is not of edges")),
        }
    }
}

fn in_range(what: &str, number: u32, count: usize, plural: &str) -> Result<u32, String> {
    let range = || match count.checked_sub(1) {
        Some(last) => format!("the mesh has {count} {plural}, 0 to {last}"),
        None => format!("the mesh has no {plural}"),
    };
    if (number as usize) < count { Ok(number) } else { Err(format!("no {what} {number}: {}", range())) }
}

/// The edges along a face, the lesser end first.
fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)])
}

/// Edges numbered as the list of faces meets them: as `edges::edge_map` numbers them where half-edges go by corners.
#[derive(Debug)]
pub(crate) struct EdgeNumbers {
    ends: Vec<[u32; 2]>,
    number: HashMap<[u32; 2], u32>,
}

impl EdgeNumbers {
    pub(crate) fn of(faces: &[[u32; 3]]) -> Self {
        let (mut ends, mut number) = (Vec::new(), HashMap::new());
        for side in faces.iter().flat_map(|&face| sides(face)) {
            number.entry(side).or_insert_with(|| {
                ends.push(side);
                ends.len() as u32 - 1
            });
        }
        Self { ends, number }
    }

    pub(crate) fn number(&self, ends: [u32; 2]) -> Option<u32> {
        self.number.get(&ends).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use onering::{CheL1, FromFaces, HalfEdgeId, Handle, Topology, edges};

    #[test]
    fn ids_are_numbers_or_two_vertices() {
        assert_eq!("17".parse(), Ok(Id::Number(17)));
        assert_eq!(["3-17", "3,17"].map(str::parse), [Ok(Id::Ends([3, 17])), Ok(Id::Ends([3, 17]))]);
        for wrong in ["", "-", "3-", "-3", "a", "1-2-3", "+4", "4294967296", "1.5"] {
            assert!(wrong.parse::<Id>().is_err(), "{wrong}");
        }
    }

    #[test]
    fn edges_are_numbered_as_the_edge_map_does() {
        let faces = [[0, 1, 2], [2, 1, 3], [5, 3, 1], [0, 2, 4]];
        let (numbers, mesh) = (EdgeNumbers::of(&faces), CheL1::from_faces(6, &faces).unwrap());
        let map = edges::edge_map(&mesh);
        assert_eq!(numbers.ends.len(), map.edge_count());
        for h in (0..12).map(HalfEdgeId::new) {
            let [a, b] = [mesh.origin(h), mesh.target(h)].map(|v| v.index() as u32);
            assert_eq!(numbers.number([a.min(b), a.max(b)]), Some(map.edge(h).index() as u32));
        }
    }
}

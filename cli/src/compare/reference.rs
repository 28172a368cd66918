//! The answers that every backend should give, and the counts that their bytes depend on, from the plain list of faces:
//! its sides are sorted, and no structure or algorithm of the library is asked.

use super::kernels::{mix, mix_face, mix_fan};
use super::sample::Soup;
use onering::footprint::Counts;
use onering::{BuildError, memory};

/// The sides of all faces, those along the same edge next to each other.
#[derive(Debug)]
pub(crate) struct Sides(Vec<Side>);

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Side {
    low: u32,
    high: u32,
    face: u32,
    corner: u8,
    is_rising: bool,
}

/// In place of a side, where no other is across.
const NOBODY: u32 = u32::MAX;

impl Sides {
    /// Most of what is held before anything is measured: an error where there is no memory for it.
    pub(crate) fn of(faces: &[[u32; 3]]) -> Result<Self, BuildError> {
        let half_edges = faces.len().saturating_mul(3);
        if half_edges > NOBODY as usize {
            return Err(BuildError::TooManyHalfEdges { half_edges, limit: NOBODY as usize });
        }
        let side = |face: usize, corner: u8, a: u32, b: u32| Side {
            low: a.min(b),
            high: a.max(b),
            face: face as u32,
            corner,
            is_rising: a < b,
        };
        let sides =
            |(f, &[a, b, c]): (usize, &[u32; 3])| [side(f, 0, a, b), side(f, 1, b, c), side(f, 2, c, a)];
        // A side that returns to its own vertex is no edge.
        let is_edge = |side: &Side| side.low != side.high;
        let mut all: Vec<Side> = memory::with_room(half_edges)?;
        all.extend(faces.iter().enumerate().flat_map(sides).filter(is_edge));
        all.sort_unstable();
        Ok(Self(all))
    }

    fn edges(&self) -> impl Iterator<Item = &[Side]> {
        self.0.chunk_by(|a, b| (a.low, a.high) == (b.low, b.high))
    }

    pub(crate) fn edge_count(&self) -> usize {
        self.edges().count()
    }

    /// Answers under the names of the kernels that give them.
    pub(crate) fn answers(&self, faces: &[[u32; 3]]) -> Vec<(&'static str, u64)> {
        let [mut edges, mut neighbours, mut all_faces, mut star] = [0_u64; 4];
        for edge in self.edges() {
            let (a, b) = (edge[0].low as usize, edge[0].high as usize);
            add(&mut edges, mix(a, b));
            add(&mut neighbours, mix(a, b).wrapping_add(mix(b, a)));
        }
        for (f, face) in faces.iter().enumerate() {
            let vertices = face.map(|v| v as usize);
            add(&mut all_faces, mix_face(f, vertices));
            vertices.iter().for_each(|&v| add(&mut star, mix(v, f)));
        }
        let mut answers = vec![("faces", all_faces), ("neighbours", neighbours), ("edges", edges)];
        // What lies across an edge that a face meets twice is for nobody to say.
        if are_proper(faces) {
            answers.push(("star", star));
            answers.extend(self.across());
        }
        answers
    }

    /// What lies along edges, where no face meets one twice: the least half-edge is then that of the first side.
    fn across(&self) -> [(&'static str, u64); 3] {
        let [mut edge_fan, mut opposite, mut boundary] = [0_u64; 3];
        for edge in self.edges() {
            let face = |side: &Side| side.face as usize;
            add(&mut edge_fan, mix_fan(edge.iter().map(face)));
            edge[1..]
                .iter()
                .for_each(|side| add(&mut edge_fan, mix_fan([side, &edge[0]].into_iter().map(face))));
            match edge {
                [one] if one.is_rising => add(&mut boundary, mix(one.low as usize, one.high as usize)),
                [one] => add(&mut boundary, mix(one.high as usize, one.low as usize)),
                [one, two] if is_opposite(edge) => {
                    add(&mut opposite, mix(face(one), face(two)).wrapping_add(mix(face(two), face(one))));
                }
                _ => {}
            }
        }
        [("edge_fan", edge_fan), ("opposite", opposite), ("boundary", boundary)]
    }
}

/// Whether this is the edge of two faces that agree in orientation.
fn is_opposite(edge: &[Side]) -> bool {
    matches!(edge, [one, other] if one.is_rising != other.is_rising)
}

/// Whether the three vertices of every face differ.
fn are_proper(faces: &[[u32; 3]]) -> bool {
    faces.iter().all(|&[a, b, c]| a != b && b != c && c != a)
}

fn add(sum: &mut u64, term: u64) {
    *sum = sum.wrapping_add(term);
}

/// The numbers of elements that formulas for memory are linear in, but for the records of vertices. Without records
/// of edges and curves where the list has defects that no backend with such things holds.
pub(crate) fn counts(soup: &Soup, sides: &Sides) -> Result<Counts, BuildError> {
    let mut counts = Counts {
        vertices: soup.vertex_count,
        edges: sides.edge_count(),
        faces: soup.faces.len(),
        ..Counts::default()
    };
    if are_proper(&soup.faces) {
        // A record is its length and its half-edges.
        counts.edge_record_words = sides.irregular().map(|edge| 1 + edge.len()).sum();
        if counts.edge_record_words == 0 {
            counts.curves = sides.curve_count(soup.faces.len())?;
        }
    }
    Ok(counts)
}

impl Sides {
    /// Edges of three or more faces, or of two that disagree in orientation.
    fn irregular(&self) -> impl Iterator<Item = &[Side]> {
        self.edges().filter(|edge| edge.len() > 1 && !is_opposite(edge))
    }

    /// Number of boundary curves, where no edge is irregular. From each boundary side, turn through the faces around
    /// the vertex that it ends in to the next one: that is a permutation, and its cycles are the curves.
    fn curve_count(&self, face_count: usize) -> Result<usize, BuildError> {
        let mut across = memory::filled(3 * face_count, NOBODY)?;
        for edge in self.edges() {
            if let [one, other] = *edge {
                across[one.index()] = other.index() as u32;
                across[other.index()] = one.index() as u32;
            }
        }
        let mut seen = memory::filled(3 * face_count, false)?;
        let mut count = 0;
        for start in self.edges().filter(|edge| edge.len() == 1).map(|edge| edge[0].index()) {
            count += usize::from(!seen[start]);
            let mut side = start;
            while !std::mem::replace(&mut seen[side], true) {
                side = after(side);
                while across[side] != NOBODY {
                    side = after(across[side] as usize);
                }
            }
        }
        Ok(count)
    }
}

impl Side {
    fn index(self) -> usize {
        3 * self.face as usize + usize::from(self.corner)
    }
}

/// The side that follows in the same face.
fn after(side: usize) -> usize {
    side - side % 3 + (side + 1) % 3
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Edges, curves and words in records of edges.
    fn counted(vertex_count: usize, faces: &[[u32; 3]]) -> [usize; 3] {
        let soup = Soup { vertex_count, faces: faces.to_vec(), is_clean: true };
        let counts = counts(&soup, &Sides::of(faces).unwrap()).unwrap();
        assert_eq!((counts.vertices, counts.faces), (vertex_count, faces.len()));
        [counts.edges, counts.curves, counts.edge_record_words]
    }

    #[test]
    fn curves_run_around_each_sheet_and_each_hole() {
        assert_eq!(counted(4, &[[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]]), [6, 0, 0]);
        // A square, and a triangle of its own.
        assert_eq!(counted(7, &[[0, 1, 2], [2, 1, 3], [4, 5, 6]]), [8, 2, 0]);
        // Two triangles that touch in a vertex: a curve each.
        assert_eq!(counted(5, &[[0, 1, 2], [0, 3, 4]]), [6, 2, 0]);
        // A belt of six triangles around a hole: 12 edges, 6 of them on its two curves.
        let belt = [[0, 1, 3], [3, 1, 4], [1, 2, 4], [4, 2, 5], [2, 0, 5], [5, 0, 3]];
        assert_eq!(counted(6, &belt), [12, 2, 0]);
    }

    #[test]
    fn irregular_edges_have_records_and_then_there_are_no_curves() {
        // Three faces on an edge; two that run the same way; both; a face of two vertices.
        assert_eq!(counted(5, &[[0, 1, 2], [1, 0, 3], [0, 1, 4]]), [7, 0, 4]);
        assert_eq!(counted(4, &[[0, 1, 2], [0, 1, 3]]), [5, 0, 3]);
        assert_eq!(counted(6, &[[0, 1, 2], [1, 0, 3], [0, 1, 4], [1, 2, 5]]), [9, 0, 4 + 3]);
        assert_eq!(counted(3, &[[0, 1, 2], [0, 0, 1]]), [3, 0, 0]);
    }
}

//! The answers that every backend should give, from the plain list of faces: no structure, only sorting.

use super::kernels::{mix, mix_face, mix_fan};
use super::sample::Soup;
use onering::footprint::Counts;
use onering::{CheL1, FromFaces, Pairing, boundary, pairing};

/// The sides of all faces, those along the same edge next to each other.
#[derive(Debug)]
pub(crate) struct Sides(Vec<Side>);

#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
struct Side {
    low: u32,
    high: u32,
    face: u32,
    is_rising: bool,
}

impl Sides {
    pub(crate) fn of(faces: &[[u32; 3]]) -> Self {
        let side = |face: usize, a: u32, b: u32| Side {
            low: a.min(b),
            high: a.max(b),
            face: face as u32,
            is_rising: a < b,
        };
        let sides = |(f, &[a, b, c]): (usize, &[u32; 3])| [side(f, a, b), side(f, b, c), side(f, c, a)];
        // A side that returns to its own vertex is no edge.
        let is_edge = |side: &Side| side.low != side.high;
        let mut sides: Vec<Side> = faces.iter().enumerate().flat_map(sides).filter(is_edge).collect();
        sides.sort_unstable();
        Self(sides)
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
        if faces.iter().all(|&[a, b, c]| a != b && b != c && c != a) {
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
            edge[1..].iter().for_each(|side| add(&mut edge_fan, mix(face(side), face(&edge[0]))));
            match edge {
                [one] if one.is_rising => add(&mut boundary, mix(one.low as usize, one.high as usize)),
                [one] => add(&mut boundary, mix(one.high as usize, one.low as usize)),
                [one, two] if one.is_rising != two.is_rising => {
                    add(&mut opposite, mix(face(one), face(two)).wrapping_add(mix(face(two), face(one))));
                }
                _ => {}
            }
        }
        [("edge_fan", edge_fan), ("opposite", opposite), ("boundary", boundary)]
    }
}

fn add(sum: &mut u64, term: u64) {
    *sum = sum.wrapping_add(term);
}

/// The numbers of elements that formulas for memory are linear in, but for the records of vertices. Without records
/// of edges and curves where the list has defects that no backend with such things holds.
pub(crate) fn counts(soup: &Soup, sides: &Sides) -> Counts {
    let mut counts = Counts {
        vertices: soup.vertex_count,
        edges: sides.edge_count(),
        faces: soup.faces.len(),
        ..Counts::default()
    };
    if let Ok(paired) = pairing::pair(soup.vertex_count, &soup.faces, Pairing::Auto) {
        counts.edge_record_words = paired.irregular.iter().map(|edge| 1 + edge.len()).sum();
    }
    if let Ok(mesh) = CheL1::from_faces(soup.vertex_count, &soup.faces) {
        counts.curves = boundary::curves(&mesh).len();
    }
    counts
}

//! The answers that every backend should give, from the plain list of faces: no structure, only sorting.

use super::kernels::{mix, mix_face};
use super::sample::Soup;
use onering::footprint::Counts;
use onering::{CheL1, FromFaces, Pairing, boundary, fans, pairing};

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
        let [mut edge_fan, mut opposite, mut boundary, mut edges, mut neighbours] = [0_u64; 5];
        for edge in self.edges() {
            let (a, b) = (edge[0].low as usize, edge[0].high as usize);
            add(&mut edges, mix(a, b));
            add(&mut neighbours, mix(a, b).wrapping_add(mix(b, a)));
            for (i, side) in edge.iter().enumerate() {
                for (_, other) in edge.iter().enumerate().filter(|&(j, _)| j != i) {
                    let pair = mix(side.face as usize, other.face as usize);
                    add(&mut edge_fan, pair);
                    let is_opposite = edge.len() == 2 && side.is_rising != other.is_rising;
                    add(&mut opposite, if is_opposite { pair } else { 0 });
                }
            }
            if let [side] = edge {
                add(&mut boundary, if side.is_rising { mix(a, b) } else { mix(b, a) });
            }
        }
        let corners = faces.iter().map(|face| face.map(|v| v as usize)).enumerate();
        let (mut all_faces, mut star) = (0, 0);
        for (f, vertices) in corners {
            add(&mut all_faces, mix_face(f, vertices));
            vertices.iter().for_each(|&v| add(&mut star, mix(v, f)));
        }
        let mut answers = vec![("faces", all_faces), ("neighbours", neighbours), ("edges", edges)];
        // What lies across an edge that a face meets twice is for nobody to say.
        if faces.iter().all(|&[a, b, c]| a != b && b != c && c != a) {
            answers.extend([
                ("edge_fan", edge_fan),
                ("opposite", opposite),
                ("boundary", boundary),
                ("star", star),
            ]);
        }
        answers
    }
}

fn add(sum: &mut u64, term: u64) {
    *sum = sum.wrapping_add(term);
}

/// The numbers of elements that formulas for memory are linear in. Without records and curves where the list has
/// defects that no backend with such things holds.
pub(crate) fn counts(soup: &Soup, sides: &Sides) -> Counts {
    let mut counts = Counts {
        vertices: soup.vertex_count,
        edges: sides.edge_count(),
        faces: soup.faces.len(),
        ..Counts::default()
    };
    if let Ok(paired) = pairing::pair(soup.vertex_count, &soup.faces, Pairing::Auto) {
        counts.edge_record_words = paired.irregular.iter().map(|edge| 1 + edge.len()).sum();
        let fans = fans::fans(soup.vertex_count, &soup.faces, &paired.opposite);
        let several = fans.iter().flat_map(|fans| &fans.several);
        counts.vertex_record_words = several.map(|(_, fans)| 1 + fans.len()).sum();
    }
    if let Ok(mesh) = CheL1::from_faces(soup.vertex_count, &soup.faces) {
        counts.curves = boundary::curves(&mesh).len();
    }
    counts
}

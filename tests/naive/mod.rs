//! Pairing by the definition, written apart from the library: compares each half-edge with every other.
use onering::conformance::Flaw;
use onering::{BuildError, corner};

/// What there is to know of a face list.
pub(crate) struct Naive {
    pub(crate) opposite: Vec<Option<usize>>,
    /// The half-edges of each irregular edge, ascending; by the first.
    pub(crate) irregular: Vec<Vec<usize>>,
}

/// The first face that is no triangle over `vertices`; a backend that holds degenerate ones looks for vertices out
/// of range only.
pub(crate) fn face_error(vertices: usize, faces: &[[u32; 3]], holds: &[Flaw]) -> Option<BuildError> {
    for (face, &[a, b, c]) in faces.iter().enumerate() {
        for vertex in [a, b, c] {
            if vertex as usize >= vertices {
                return Some(BuildError::VertexOutOfRange { face, vertex, vertex_count: vertices });
            }
        }
        if !holds.contains(&Flaw::Degenerate) && (a == b || b == c || c == a) {
            let vertex = if b == c { b } else { a };
            return Some(BuildError::DegenerateFace { face, vertex });
        }
    }
    None
}

impl Naive {
    /// Pairs faces that name vertices in range.
    pub(crate) fn of(faces: &[[u32; 3]]) -> Self {
        let ends = |h| (corner::origin(faces, h), corner::target(faces, h));
        let count = 3 * faces.len();
        let mut naive = Naive { opposite: vec![None; count], irregular: Vec::new() };
        for h in 0..count {
            let (a, b) = ends(h);
            let along: Vec<usize> = (0..count).filter(|&g| ends(g) == (a, b) || ends(g) == (b, a)).collect();
            match along[..] {
                [_] => {}
                [g, k] if ends(g) != ends(k) => naive.opposite[h] = Some(g + k - h),
                [first, ..] if first == h => naive.irregular.push(along),
                _ => {}
            }
        }
        naive
    }

    /// The irregular edge that is found out first, as faces are read.
    pub(crate) fn edge_error(&self, faces: &[[u32; 3]], holds: &[Flaw]) -> Option<BuildError> {
        let (mut first, mut error) = (usize::MAX, None);
        for edge in &self.irregular {
            let flaw = if edge.len() == 2 { Flaw::SameDirection } else { Flaw::NonManifoldEdge };
            let found = edge[if edge.len() == 2 { 1 } else { 2 }];
            if !holds.contains(&flaw) && found < first {
                first = found;
                error = Some(edge_error(faces, edge));
            }
        }
        error
    }

    /// The lowest vertex of several fans: groups of its half-edges that opposites connect.
    pub(crate) fn vertex_error(
        &self,
        vertices: usize,
        faces: &[[u32; 3]],
        holds: &[Flaw],
    ) -> Option<BuildError> {
        if holds.contains(&Flaw::SeveralFans) {
            return None;
        }
        // Half-edges out of a vertex carry the least number that they can reach.
        let mut group: Vec<usize> = (0..self.opposite.len()).collect();
        for _ in 0..faces.len() {
            for (h, o) in self.opposite.iter().enumerate() {
                let Some(o) = o else { continue };
                let beyond = 3 * (o / 3) + (o + 1) % 3;
                let least = group[h].min(group[beyond]);
                (group[h], group[beyond]) = (least, least);
            }
        }
        let leads = |v| (0..group.len()).filter(move |&h| corner::origin(faces, h) as usize == v);
        let fans = |v| leads(v).filter(|&h| group[h] == h).count();
        let vertex = (0..vertices).find(|&v| fans(v) > 1)?;
        Some(BuildError::SeveralFans { vertex, fans: fans(vertex) })
    }
}

fn edge_error(faces: &[[u32; 3]], edge: &[usize]) -> BuildError {
    let (a, b) = (corner::origin(faces, edge[0]), corner::target(faces, edge[0]));
    if let [first, second] = *edge {
        return BuildError::SameDirection { vertices: [a, b], faces: [first / 3, second / 3] };
    }
    BuildError::NonManifoldEdge { vertices: [a.min(b), a.max(b)], faces: edge.len(), face: edge[2] / 3 }
}

/// The error of a backend that holds no flaws but these.
pub(crate) fn error(vertices: usize, faces: &[[u32; 3]], holds: &[Flaw]) -> Option<BuildError> {
    face_error(vertices, faces, holds).or_else(|| {
        let naive = Naive::of(faces);
        naive.edge_error(faces, holds).or_else(|| naive.vertex_error(vertices, faces, holds))
    })
}

//! Pairing by the definition, written apart from the library: compares each half-edge with every other.
use onering::BuildError;
use onering::conformance::Flaw;

/// What there is to know of a face list.
pub(crate) struct Naive {
    pub(crate) opposite: Vec<Option<usize>>,
    /// The half-edges of each irregular edge, ascending; by the first.
    pub(crate) irregular: Vec<Vec<usize>>,
}

/// The vertex that half-edge `h` starts from, and the one that it leads to.
fn ends(faces: &[[u32; 3]], h: usize) -> (u32, u32) {
    let face = faces[h / 3];
    (face[h % 3], face[[1, 2, 0][h % 3]])
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
        let ends = |h| ends(faces, h);
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

    /// The half-edges out of each vertex, fan after fan and counter-clockwise, each fan from its most clockwise
    /// half-edge, or where it is closed its lowest: the open ones in the order of their starts, then the closed ones.
    pub(crate) fn fans(&self, vertices: usize, faces: &[[u32; 3]]) -> Vec<Vec<Vec<usize>>> {
        let ccw = |h: &usize| self.opposite[h - h % 3 + [2, 0, 1][h % 3]];
        let from = |start| std::iter::successors(Some(start), ccw).take(3 * faces.len());
        let fan = |start: usize| match from(start).skip(1).position(|h| h == start) {
            Some(turns) => from(start).take(turns + 1).collect(),
            None => from(start).collect::<Vec<_>>(),
        };
        let of_vertex = |v: usize| {
            let out: Vec<usize> = (0..3 * faces.len()).filter(|&h| ends(faces, h).0 as usize == v).collect();
            let is_closed = |h: usize| from(h).skip(1).any(|g| g == h);
            let open = out.iter().copied().filter(|&h| self.opposite[h].is_none());
            let closed = out.iter().copied().filter(|&h| is_closed(h) && fan(h).iter().all(|&g| g >= h));
            open.chain(closed).map(fan).collect()
        };
        (0..vertices).map(of_vertex).collect()
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
        let leads = |v| (0..group.len()).filter(move |&h| ends(faces, h).0 as usize == v);
        let fans = |v| leads(v).filter(|&h| group[h] == h).count();
        let vertex = (0..vertices).find(|&v| fans(v) > 1)?;
        Some(BuildError::SeveralFans { vertex: vertex as u32, fans: fans(vertex) })
    }
}

fn edge_error(faces: &[[u32; 3]], edge: &[usize]) -> BuildError {
    let (a, b) = ends(faces, edge[0]);
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

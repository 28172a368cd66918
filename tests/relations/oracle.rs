//! The nine relations by their definitions: every element is looked at, whether it belongs.
use std::collections::BTreeSet;

type Edge = [u32; 2];

/// A face list, and its edges, lesser end first.
pub struct Oracle {
    pub name: String,
    pub vertex_count: usize,
    pub faces: Vec<[u32; 3]>,
    pub edges: BTreeSet<Edge>,
    /// Whether some face names a vertex twice.
    pub is_degenerate: bool,
}

pub fn undirected([a, b]: Edge) -> Edge {
    [a.min(b), a.max(b)]
}

fn sides([a, b, c]: [u32; 3]) -> [Edge; 3] {
    [[a, b], [b, c], [c, a]].map(undirected)
}

impl Oracle {
    pub fn new(name: &str, vertex_count: usize, faces: &[[u32; 3]]) -> Self {
        let edges = faces.iter().flat_map(|&face| sides(face)).collect();
        let is_degenerate = faces.iter().any(|&[a, b, c]| a == b || b == c || c == a);
        Self { name: name.into(), vertex_count, faces: faces.into(), edges, is_degenerate }
    }

    fn faces_with(&self, is_one: impl Fn([u32; 3]) -> bool) -> BTreeSet<usize> {
        (0..self.faces.len()).filter(|&f| is_one(self.faces[f])).collect()
    }

    pub fn vertex_vertices(&self, v: u32) -> BTreeSet<u32> {
        let ends = |u| self.edges.contains(&undirected([u, v]));
        (0..self.vertex_count as u32).filter(|&u| u != v && ends(u)).collect()
    }

    pub fn vertex_edges(&self, v: u32) -> BTreeSet<Edge> {
        self.edges.iter().copied().filter(|e| e.contains(&v)).collect()
    }

    pub fn vertex_faces(&self, v: u32) -> BTreeSet<usize> {
        self.faces_with(|face| face.contains(&v))
    }

    pub fn edge_edges(&self, e: Edge) -> BTreeSet<Edge> {
        self.edges.iter().copied().filter(|&o| o != e && o.iter().any(|v| e.contains(v))).collect()
    }

    pub fn edge_faces(&self, e: Edge) -> BTreeSet<usize> {
        self.faces_with(|face| sides(face).contains(&e))
    }

    pub fn face_edges(&self, f: usize) -> BTreeSet<Edge> {
        sides(self.faces[f]).into()
    }

    pub fn face_faces(&self, f: usize) -> BTreeSet<usize> {
        let of = self.face_edges(f);
        let mut across = self.faces_with(|face| sides(face).iter().any(|side| of.contains(side)));
        across.remove(&f);
        across
    }
}

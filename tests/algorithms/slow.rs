//! The answers once more, by slow search over the face list: maps, sets, and labels spread until none changes.
use super::figures::Figures;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// A face list, with what lies at each edge and vertex.
pub struct Slow {
    pub vertex_count: usize,
    pub faces: Vec<[u32; 3]>,
    /// Edge, lesser end first -> faces along it, and whether they run from the lesser end.
    pub edges: BTreeMap<[u32; 2], Vec<(usize, bool)>>,
    /// Vertex -> its faces.
    pub star: BTreeMap<u32, Vec<usize>>,
}

/// The sides of a face, as it runs.
pub fn sides([a, b, c]: [u32; 3]) -> [[u32; 2]; 3] {
    [[a, b], [b, c], [c, a]]
}

pub fn undirected([a, b]: [u32; 2]) -> [u32; 2] {
    [a.min(b), a.max(b)]
}

/// Numbers `count` things in the order of the first of each class; `groups` are in one class each.
pub fn classes(count: usize, groups: &[Vec<usize>]) -> Vec<usize> {
    let mut label: Vec<usize> = (0..count).collect();
    loop {
        let before = label.clone();
        for group in groups {
            let least = group.iter().map(|&i| label[i]).min().unwrap_or(0);
            group.iter().for_each(|&i| label[i] = least);
        }
        if label == before {
            let firsts: BTreeSet<usize> = label.iter().copied().collect();
            return label.iter().map(|l| firsts.range(..l).count()).collect();
        }
    }
}

pub fn class_count(classes: &[usize]) -> usize {
    classes.iter().max().map_or(0, |last| last + 1)
}

impl Slow {
    pub fn new(vertex_count: usize, faces: &[[u32; 3]]) -> Self {
        let (mut edges, mut star) = (BTreeMap::<_, Vec<_>>::new(), BTreeMap::<_, Vec<_>>::new());
        for (f, &face) in faces.iter().enumerate() {
            face.iter().for_each(|&v| star.entry(v).or_default().push(f));
            for side in sides(face) {
                edges.entry(undirected(side)).or_default().push((f, side[0] < side[1]));
            }
        }
        Self { vertex_count, faces: faces.into(), edges, star }
    }

    pub fn neighbours(&self, v: u32) -> BTreeSet<u32> {
        self.vertices_of(self.star.get(&v).into_iter().flatten()).into_iter().filter(|&u| u != v).collect()
    }

    fn vertices_of<'a>(&self, faces: impl IntoIterator<Item = &'a usize>) -> BTreeSet<u32> {
        faces.into_iter().flat_map(|&f| self.faces[f]).collect()
    }

    /// The vertices of the rings 1 to `k`, centre left out, by the paper's words: the first ring is all cells
    /// that contain `v`, each further one all cells that intersect the one before.
    pub fn rings_of_cells(&self, v: u32, k: usize) -> Vec<BTreeSet<u32>> {
        let mut vertices = BTreeSet::from([v]);
        let mut ring = || {
            let cells = self.faces.iter().filter(|face| face.iter().any(|u| vertices.contains(u)));
            vertices = cells.flatten().copied().collect();
            vertices.iter().copied().filter(|&u| u != v).collect()
        };
        (0..k).map(|_| ring()).collect()
    }

    /// Distances from `v` along edges, by relaxing all edges until nothing changes.
    pub fn distances(&self, v: u32) -> HashMap<u32, usize> {
        let mut distance = HashMap::from([(v, 0)]);
        loop {
            let before = distance.clone();
            for &[a, b] in self.edges.keys() {
                for [a, b] in [[a, b], [b, a]] {
                    if let Some(d) = distance.get(&a).map(|d| d + 1) {
                        let found = distance.entry(b).or_insert(d);
                        *found = d.min(*found);
                    }
                }
            }
            if distance == before {
                return distance;
            }
        }
    }

    /// The side opposite `v` in each of its faces, sorted.
    pub fn link(&self, v: u32) -> Vec<[u32; 2]> {
        let of_face = |f: &usize| sides(self.faces[*f]).into_iter().find(|side| !side.contains(&v)).unwrap();
        let mut link: Vec<_> = self.star.get(&v).into_iter().flatten().map(of_face).collect();
        link.sort_unstable();
        link
    }

    pub fn components(&self) -> Vec<usize> {
        let groups: Vec<Vec<usize>> =
            self.edges.values().map(|along| along.iter().map(|&(f, _)| f).collect()).collect();
        classes(self.faces.len(), &groups)
    }

    pub fn components_by_vertex(&self) -> Vec<usize> {
        classes(self.faces.len(), &self.star.values().cloned().collect::<Vec<_>>())
    }

    /// The umbrellas of `v`: the vertices of each connected part of its link.
    fn umbrellas(&self, v: u32) -> Vec<BTreeSet<u32>> {
        let mut parts: Vec<BTreeSet<u32>> = Vec::new();
        for side in self.link(v) {
            let (touched, mut rest): (Vec<_>, Vec<_>) =
                parts.into_iter().partition(|part| side.iter().any(|u| part.contains(u)));
            rest.push(touched.into_iter().flatten().chain(side).collect());
            parts = rest;
        }
        parts
    }

    fn faces_along(&self, a: u32, b: u32) -> usize {
        self.edges[&undirected([a, b])].len()
    }

    pub fn is_manifold(&self) -> bool {
        self.edges.values().all(|along| along.len() <= 2)
            && self.star.keys().all(|&v| self.umbrellas(v).len() == 1)
    }

    /// Boundary edges that end in one umbrella follow one another; there have to be two of them, or none.
    pub fn boundary_loops(&self) -> Option<usize> {
        let boundary: Vec<_> =
            self.edges.iter().filter(|(_, along)| along.len() == 1).map(|(e, _)| e).collect();
        let place = |a, b| boundary.iter().position(|&&e| e == undirected([a, b])).unwrap();
        let mut groups = Vec::new();
        for &v in self.star.keys() {
            for umbrella in self.umbrellas(v) {
                let ends = umbrella.into_iter().filter(|&u| self.faces_along(u, v) == 1);
                groups.push(ends.map(|u| place(u, v)).collect::<Vec<_>>());
            }
        }
        let all_pair = groups.iter().all(|ends| matches!(ends.len(), 0 | 2));
        all_pair.then(|| class_count(&classes(boundary.len(), &groups)))
    }

    /// Each face as it is and turned over, twice as many; what agrees across an edge of two faces is in one class.
    pub fn is_orientable(&self) -> bool {
        let n = self.faces.len();
        let mut groups = Vec::new();
        for along in self.edges.values().filter(|along| along.len() == 2) {
            let [(f, f_runs), (g, g_runs)] = [along[0], along[1]];
            let (as_is, turned) = if f_runs == g_runs { (g + n, g) } else { (g, g + n) };
            groups.extend([vec![f, as_is], vec![f + n, turned]]);
        }
        let class = classes(2 * n, &groups);
        (0..n).all(|f| class[f] != class[f + n])
    }

    pub fn is_oriented(&self) -> bool {
        self.edges.values().all(|along| along.len() != 2 || along[0].1 != along[1].1)
    }

    pub fn figures(&self) -> Figures {
        let boundary_edges = self.edges.values().filter(|along| along.len() == 1).count();
        let euler = self.star.len() as isize - self.edges.len() as isize + self.faces.len() as isize;
        let (components, boundary_loops) = (class_count(&self.components()), self.boundary_loops());
        let (is_manifold, is_orientable) = (self.is_manifold(), self.is_orientable());
        let has_genus = is_manifold && is_orientable && !self.faces.is_empty();
        let genus = || (2 * components as isize - boundary_loops.unwrap() as isize - euler) / 2;
        Figures {
            edges: self.edges.len(),
            boundary_edges,
            euler,
            components,
            components_by_vertex: class_count(&self.components_by_vertex()),
            boundary_loops,
            is_closed: boundary_edges == 0 && !self.faces.is_empty(),
            is_manifold,
            is_oriented: self.is_oriented(),
            is_orientable,
            genus: has_genus.then(|| genus() as usize),
        }
    }
}

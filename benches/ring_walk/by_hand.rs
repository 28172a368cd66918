//! One-ring sweeps as one would write them for each structure alone: the yardstick of the generic ones.
//!
//! Each sums the index of every neighbour of every vertex, in safe code, over plain `u32` columns.

const NONE: u32 = u32::MAX;

/// Columns of compact half-edges and of directed edges.
pub(crate) struct Columns {
    origin: Vec<u32>,
    target: Vec<u32>,
    opposite: Vec<u32>,
    /// The next half-edge out of the same vertex: `opposite[prev(h)]`.
    rotate: Vec<u32>,
    outgoing: Vec<u32>,
}

fn next(h: u32) -> u32 {
    if h % 3 == 2 { h - 2 } else { h + 1 }
}

fn prev(h: u32) -> u32 {
    if h.is_multiple_of(3) { h + 2 } else { h - 1 }
}

impl Columns {
    /// The columns of a mesh that is asked through its public methods.
    pub(crate) fn of<M: onering::Incidence>(mesh: &M) -> Self {
        use onering::Handle;
        let index = |h: Option<M::HalfEdge>| h.map_or(NONE, |h| h.index() as u32);
        let half_edges = || mesh.half_edges();
        Self {
            origin: half_edges().map(|h| mesh.origin(h).index() as u32).collect(),
            target: half_edges().map(|h| mesh.target(h).index() as u32).collect(),
            opposite: half_edges().map(|h| index(mesh.opposite(h))).collect(),
            rotate: half_edges().map(|h| index(mesh.opposite(mesh.prev(h)))).collect(),
            outgoing: mesh.vertices().map(|v| index(mesh.outgoing(v))).collect(),
        }
    }

    /// Origin and opposite, both read at `prev(h)` alone.
    pub(crate) fn compact(&self) -> u64 {
        let is_open = |h: u32| self.opposite[h as usize] == NONE;
        let turn = |h: u32| {
            let p = prev(h) as usize;
            (self.origin[p], self.opposite[p])
        };
        self.sweep(is_open, |h| self.origin[next(h) as usize], turn)
    }

    /// Target and opposite, at three places of the face.
    pub(crate) fn directed(&self) -> u64 {
        let is_open = |h: u32| self.opposite[h as usize] == NONE;
        let turn = |h: u32| (self.target[next(h) as usize], self.opposite[prev(h) as usize]);
        self.sweep(is_open, |h| self.target[h as usize], turn)
    }

    /// Target and rotation: no place in a face is worked out but at the ends of an open fan.
    pub(crate) fn turned(&self) -> u64 {
        let is_open = |h: u32| self.rotate[next(h) as usize] == NONE;
        let turn = |h: u32| {
            let g = self.rotate[h as usize];
            (self.target[if g == NONE { next(h) } else { g } as usize], g)
        };
        self.sweep(is_open, |h| self.target[h as usize], turn)
    }

    #[inline(always)]
    fn sweep(
        &self,
        is_open: impl Fn(u32) -> bool,
        target: impl Fn(u32) -> u32,
        turn: impl Fn(u32) -> (u32, u32),
    ) -> u64 {
        let mut sum = 0;
        for &start in &self.outgoing {
            if start == NONE {
                continue;
            }
            if is_open(start) {
                sum += u64::from(target(start));
            }
            let mut h = start;
            loop {
                let (v, g) = turn(h);
                sum += u64::from(v);
                h = g;
                if h == NONE || h == start {
                    break;
                }
            }
        }
        sum
    }
}

/// The neighbours of each vertex in one run of memory.
pub(crate) struct Lists {
    offsets: Vec<u32>,
    neighbours: Vec<u32>,
}

impl Lists {
    /// The rings of a mesh that is asked through its public methods.
    pub(crate) fn of<M: onering::Incidence>(mesh: &M) -> Self {
        use onering::Handle;
        let (mut offsets, mut neighbours) = (vec![0], Vec::new());
        for v in mesh.vertices() {
            neighbours.extend(mesh.one_ring(v).map(|u| u.index() as u32));
            offsets.push(neighbours.len() as u32);
        }
        Self { offsets, neighbours }
    }

    pub(crate) fn lists(&self) -> u64 {
        let list = |ends: &[u32]| &self.neighbours[ends[0] as usize..ends[1] as usize];
        self.offsets.windows(2).map(|ends| list(ends).iter().map(|&u| u64::from(u)).sum::<u64>()).sum()
    }
}

/// Mate-face by hand: records of three vertices and three mates, a cell for each vertex (Biscaro et al. 2016,
/// Algorithm 1, on manifolds).
pub(crate) struct Cells {
    pub(crate) cells: Vec<([u32; 3], [u32; 3])>,
    pub(crate) first: Vec<u32>,
}

impl Cells {
    /// The cells of a mesh that is asked through its public methods.
    pub(crate) fn of<M: onering::Incidence>(mesh: &M) -> Self {
        use onering::Handle;
        let face = |h: M::HalfEdge| mesh.face(h).index() as u32;
        // Mate i lies across the side opposite vertex i, which starts at vertex i + 1.
        let mate = |h: M::HalfEdge| mesh.opposite(mesh.next(h)).map_or(NONE, face);
        let cell = |f| {
            let sides = mesh.face_half_edges(f);
            (sides.map(|h| mesh.origin(h).index() as u32), sides.map(mate))
        };
        let first = |v| mesh.outgoing(v).map_or(NONE, face);
        Self { cells: mesh.faces().map(cell).collect(), first: mesh.vertices().map(first).collect() }
    }

    /// The walk of a fan whose faces may disagree in orientation: it leaves each cell by the side at the vertex
    /// that it did not come in by.
    pub(crate) fn mate_face(&self) -> u64 {
        let mut sum = 0;
        for (v, &start) in self.first.iter().enumerate() {
            if start == NONE {
                continue;
            }
            let i = position(&self.cells[start as usize].0, v as u32);
            let mut from = self.cells[start as usize].0[(i + 1) % 3];
            if self.cells[start as usize].1[(i + 2) % 3] == NONE {
                sum += u64::from(from);
            }
            let mut c = start;
            loop {
                let (vertices, mates) = &self.cells[c as usize];
                let i = position(vertices, v as u32);
                let (right, left) = ((i + 1) % 3, (i + 2) % 3);
                let (to, across) = if vertices[right] == from { (left, right) } else { (right, left) };
                from = vertices[to];
                sum += u64::from(from);
                c = mates[across];
                if c == NONE || c == start {
                    break;
                }
            }
        }
        sum
    }

    /// The same where all faces are known to agree, as Algorithm 1 is printed: what that knowledge is worth.
    pub(crate) fn mate_face_oriented(&self) -> u64 {
        let mut sum = 0;
        for (v, &start) in self.first.iter().enumerate() {
            if start == NONE {
                continue;
            }
            let (vertices, mates) = &self.cells[start as usize];
            let i = position(vertices, v as u32);
            if mates[(i + 2) % 3] == NONE {
                sum += u64::from(vertices[(i + 1) % 3]);
            }
            let mut c = start;
            loop {
                let (vertices, mates) = &self.cells[c as usize];
                let i = position(vertices, v as u32);
                sum += u64::from(vertices[(i + 2) % 3]);
                c = mates[(i + 1) % 3];
                if c == NONE || c == start {
                    break;
                }
            }
        }
        sum
    }
}

fn position(vertices: &[u32; 3], v: u32) -> usize {
    if vertices[0] == v {
        0
    } else if vertices[1] == v {
        1
    } else {
        2
    }
}

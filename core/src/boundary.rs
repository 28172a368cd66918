//! Boundary curves of any [`Adjacency`]. Compact Half-Edge level 3 keeps them: see [`Boundaries`](crate::Boundaries).
use crate::{Adjacency, BuildError, Map, Slot, disjoint_sets::DisjointSets, memory, umbrella};
use alloc::vec::Vec;

/// The boundary half-edge that follows boundary half-edge `h` along its curve: the next one around its target.
/// `None` where an edge of three or more faces, or two faces that disagree in orientation, stop the turn.
/// O(degree of the target).
///
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, Handle, HalfEdgeId, boundary};
/// let mesh = Mesh::from_faces(4, &[[0, 1, 2], [2, 1, 3]])?;
/// let next = boundary::next_along(&mesh, HalfEdgeId::new(0));
/// assert_eq!(next, Some(HalfEdgeId::new(4)));
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn next_along<M: Adjacency + ?Sized>(mesh: &M, h: M::HalfEdge) -> Option<M::HalfEdge> {
    let mut g = mesh.next(h);
    while let Some(o) = mesh.opposite(g) {
        g = mesh.next(o);
    }
    mesh.is_boundary(g).then_some(g)
}

/// The first half-edge of every boundary curve, in ascending order. O(half-edges), one byte of scratch for each.
///
/// A closed curve starts at its least half-edge. One that ends early, on a mesh that is no manifold, starts at
/// its first. A mesh of [`Boundaries`](crate::Boundaries) keeps these: there, `curve_start` is O(1).
///
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, Topology, boundary};
/// let mesh = Mesh::from_faces(7, &[[0, 1, 2], [2, 1, 3], [4, 5, 6]])?;
/// let lengths = boundary::curves(&mesh).into_iter().map(|start| boundary::Curve::new(&mesh, start).count());
/// assert_eq!(lengths.collect::<Vec<_>>(), [4, 3]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Panics
/// If memory does not suffice: [`try_curves`] gives that as an error.
pub fn curves<M: Adjacency + ?Sized>(mesh: &M) -> Vec<M::HalfEdge> {
    try_curves(mesh).unwrap_or_else(|error| panic!("{error}"))
}

/// As [`curves`], for the construction of a structure.
///
/// # Errors
/// [`BuildError::OutOfMemory`].
pub fn try_curves<M: Adjacency + ?Sized>(mesh: &M) -> Result<Vec<M::HalfEdge>, BuildError> {
    let on_boundary = || mesh.half_edges().filter(|&h| mesh.is_boundary(h));
    let mut seen: Map<M::HalfEdge, bool> = memory::filled(mesh.half_edge_bound(), false)?.into();
    for g in on_boundary().filter_map(|b| next_along(mesh, b)) {
        seen[g] = true;
    }
    // What nothing leads to begins a curve that ends early; what is then still unmarked lies on closed ones.
    let mut starts = Vec::new();
    for start in on_boundary().filter(|&h| !seen[h]) {
        memory::push(&mut starts, start)?;
    }
    seen.as_mut_slice().fill(false);
    for &start in &starts {
        Curve::new(mesh, start).for_each(|h| seen[h] = true);
    }
    for start in on_boundary() {
        if !seen[start] {
            memory::push(&mut starts, start)?;
            Curve::new(mesh, start).for_each(|h| seen[h] = true);
        }
    }
    starts.sort_unstable();
    Ok(starts)
}

/// Number of boundary half-edges, which is the length of all boundary curves together. O(half-edges).
///
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, boundary};
/// assert_eq!(boundary::edge_count(&Mesh::from_faces(4, &[[0, 1, 2], [2, 1, 3]])?), 4);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn edge_count<M: Adjacency + ?Sized>(mesh: &M) -> usize {
    mesh.half_edges().filter(|&h| mesh.is_boundary(h)).count()
}

/// Whether each vertex is an end of a boundary edge. O(vertices + half-edges).
///
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, boundary};
/// let mesh = Mesh::from_faces(4, &[[0, 1, 2]])?;
/// assert_eq!(boundary::vertices(&mesh).as_slice(), [true, true, true, false]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
pub fn vertices<M: Adjacency + ?Sized>(mesh: &M) -> Map<M::Vertex, bool> {
    let mut is_on_boundary = Map::filled(mesh.vertex_count(), false);
    for h in mesh.half_edges().filter(|&h| mesh.is_boundary(h)) {
        is_on_boundary[mesh.origin(h)] = true;
        is_on_boundary[mesh.target(h)] = true;
    }
    is_on_boundary
}

/// Number of closed loops that the boundary edges form, whatever the orientation of the faces: two boundary
/// edges follow one another where they end in the same [umbrella](umbrella::umbrellas), so two sheets that touch
/// in a vertex only have a loop each, and two holes that do have one together. `None` where "loop" has no single
/// meaning: where an umbrella has other than two boundary edges or none, which takes an edge of three or more faces.
///
/// As many as there are [`curves`], where faces agree in orientation and no edge has three. O(half-edges) then;
/// nearly linear otherwise, with some 16 bytes for each half-edge.
///
/// ```
/// # use onering::DirectedEdgesSmall as Mesh;
/// use onering_core::{FromFaces, boundary};
/// let moebius = [[0, 1, 2], [2, 1, 3], [2, 3, 4], [4, 3, 0], [4, 0, 1]];
/// assert_eq!(boundary::loops(&Mesh::from_faces(5, &moebius)?), Some(1));
/// let three_at_an_edge = [[0, 1, 2], [1, 0, 3], [0, 1, 4]];
/// assert_eq!(boundary::loops(&Mesh::from_faces(5, &three_at_an_edge)?), None);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Panics
/// If memory does not suffice.
pub fn loops<M: Adjacency + ?Sized>(mesh: &M) -> Option<usize> {
    let mut boundary = mesh.half_edges().filter(|&h| mesh.is_boundary(h));
    if boundary.all(|h| next_along(mesh, h).is_some()) {
        return Some(curves(mesh).len());
    }
    loops_by_umbrella(mesh)
}

fn loops_by_umbrella<M: Adjacency + ?Sized>(mesh: &M) -> Option<usize> {
    let umbrella = umbrella::umbrellas(mesh);
    let mut loops = DisjointSets::new(mesh.half_edge_bound()).unwrap_or_else(|error| panic!("{error}"));
    // How many boundary edges end in each umbrella, and the last of them.
    let mut ends: Map<M::HalfEdge, (u8, Slot<M::HalfEdge>)> =
        Map::filled(mesh.half_edge_bound(), (0, Slot::NONE));
    for b in mesh.half_edges().filter(|&h| mesh.is_boundary(h)) {
        for corner in [b, mesh.next(b)] {
            let (count, end) = &mut ends[umbrella[corner]];
            match (*count, end.get()) {
                (1, Some(other)) => loops.join(b, other),
                (0, _) => *end = Slot::some(b),
                _ => return None,
            }
            *count += 1;
        }
    }
    let open = ends.as_slice().iter().any(|&(count, _)| count == 1);
    let is_first = |&b: &M::HalfEdge| mesh.is_boundary(b) && loops.least(b) == b;
    (!open).then(|| mesh.half_edges().filter(is_first).count())
}

/// The half-edges of one boundary curve, in order: iterator of [`Boundaries::curve`](crate::Boundaries::curve).
#[derive(Debug)]
pub struct Curve<'a, M: Adjacency + ?Sized> {
    mesh: &'a M,
    at: Slot<M::HalfEdge>,
    start: M::HalfEdge,
    begun: bool,
}

impl<'a, M: Adjacency + ?Sized> Curve<'a, M> {
    /// The curve from boundary half-edge `start` on, once round or to its end.
    pub fn new(mesh: &'a M, start: M::HalfEdge) -> Self {
        Self { mesh, at: Slot::some(start), start, begun: false }
    }
}

impl<M: Adjacency + ?Sized> Iterator for Curve<'_, M> {
    type Item = M::HalfEdge;

    fn next(&mut self) -> Option<M::HalfEdge> {
        let h = self.at.get().filter(|&h| !(self.begun && h == self.start))?;
        self.begun = true;
        self.at = next_along(self.mesh, h).into();
        Some(h)
    }
}

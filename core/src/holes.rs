//! Boundary curves filled with triangles.
use crate::{Adjacency, Map, NotFinite, boundary, not_finite};
use alloc::vec::Vec;
use core::ops::Range;

mod clip;
mod edges;
mod loops;
mod optimal;

use edges::Edges;

/// How to [`fill`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct FillOptions {
    /// Curves of more edges are left. The time for each grows with its square.
    pub max_edges: usize,
    /// Loops of up to so many edges are filled in the best of all ways, in time that grows with the cube; longer ones by
    /// clipping ears.
    pub optimal_edges: usize,
    /// Whether loops of up to [`optimal_edges`](Self::optimal_edges) are filled with regard to how sharply faces fold,
    /// and then to area; else to area alone.
    pub weigh_folds: bool,
}

impl Default for FillOptions {
    /// Curves of up to 4096 edges; the best way for up to 128, with regard to folds.
    fn default() -> Self {
        Self { max_edges: 4096, optimal_edges: 128, weigh_folds: true }
    }
}

/// The faces that close boundary curves: what [`fill`] gives.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Filled<H> {
    /// The new faces, to go behind those of the mesh. They name its vertices, and run against their neighbours.
    pub faces: Vec<[u32; 3]>,
    /// The curves that are filled, by the order of [`boundary::curves`].
    pub filled: Vec<FilledCurve<H>>,
    /// The curves that are as they were, in the same order.
    pub left: Vec<LeftCurve<H>>,
}

/// A curve that was filled.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct FilledCurve<H> {
    /// The half-edge that it starts with.
    pub start: H,
    /// Which of the new faces fill it.
    pub faces: Range<usize>,
}

/// A curve that was not filled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct LeftCurve<H> {
    /// The half-edge that it starts with.
    pub start: H,
    /// Why.
    pub reason: LeftReason,
}

/// Why a curve was not filled.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum LeftReason {
    /// It is not closed: an edge of three or more faces, or two faces that disagree in orientation, end it.
    EndsEarly,
    /// It has more edges than [`FillOptions::max_edges`].
    TooLong,
    /// Whatever triangles were looked at would lie along an edge that has its faces already, or copy a face.
    NoWay,
}

/// Fills boundary curves with triangles over their own vertices.
///
/// A loop of up to [`FillOptions::optimal_edges`] edges gets the triangulation that dynamic programming finds. By area
/// alone that is one of least area among all. With [`FillOptions::weigh_folds`], each part of the loop is filled so that the
/// sharpest fold in it, those to the faces around included, is the least sharp, and of these so that the area is least:
/// such parts put together may miss the best by a little, as in the paper. A longer loop is seen from the direction of its vector area, and ears are cut off: corners that turn left and hold no other vertex of
/// the loop; where none is left, which a loop can bring about that crosses itself in that view, the corner that turns
/// left most. A curve that comes by a vertex several times is first divided into loops that do not.
///
/// No edge of the mesh gets a third face: triangles that would need one, because two vertices of the loop are neighbours
/// already elsewhere, are not used, nor are copies of a face. A curve for which that leaves nothing is left whole, and so
/// is one that does not close. The outer boundary of a sheet is a curve as well. Whether new faces pass through old ones
/// is not looked at.
///
/// # Arguments
/// Any mesh that knows what lies across its edges; `positions` has one for each vertex.
///
/// # Returns
/// The new faces, and the curves that were left, with the reason. Every edge of a filled curve has two faces then, in
/// opposite directions. No curve left as [`EndsEarly`](LeftReason::EndsEarly) remains after
/// [`repair`](crate::repair()).
///
/// # Complexity
/// O(half-edges), and for each loop of n edges O(n^3) up to [`FillOptions::optimal_edges`] and O(n^2) above, with O(n^2)
/// memory up to it and O(n) above; each with a logarithm for what it asks of the edges. So, whatever the mesh, never more
/// than the boundary's length times (max_edges + optimal_edges^2).
///
/// # Errors
/// [`NotFinite`].
///
/// # Panics
/// If `positions` has fewer than there are vertices.
///
/// # Example
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, Topology, boundary, holes};
/// let bowl = Mesh::from_faces(5, &[[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 1]])?;
/// let positions =
///     vec![[0.0, 0.0, -1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, -1.0, 0.0]].into();
/// let filled = holes::fill(&bowl, &positions, &holes::FillOptions::default())?;
/// assert_eq!(filled.faces.len(), 2);
/// let closed = Mesh::from_face_vec(5, [bowl.to_faces(), filled.faces].concat())?;
/// assert_eq!(boundary::edge_count(&closed), 0);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Barequet, Sharir, "Filling gaps in the boundary of a polyhedron", Computer Aided Geometric Design 12, 1995 (least
/// area); Liepa, "Filling holes in meshes", SGP 2003 (folds first); ears after Meisters, 1975, and O'Rourke,
/// "Computational Geometry in C", 1998.
pub fn fill<M: Adjacency + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
    options: &FillOptions,
) -> Result<Filled<M::HalfEdge>, NotFinite> {
    not_finite::positions(positions)?;
    let mut edges = Edges::of_boundary(mesh);
    let mut result = Filled { faces: Vec::new(), filled: Vec::new(), left: Vec::new() };
    for start in boundary::curves(mesh) {
        let first_face = result.faces.len();
        match fill_curve(mesh, positions, options, start, &mut edges, &mut result.faces) {
            Ok(()) => {
                result.filled.push(FilledCurve { start, faces: first_face..result.faces.len() });
            }
            Err(reason) => {
                // What other loops of the curve have got is taken back.
                result.faces.truncate(first_face);
                result.left.push(LeftCurve { start, reason });
            }
        }
    }
    Ok(result)
}

fn fill_curve<M: Adjacency + ?Sized>(
    mesh: &M,
    positions: &Map<M::Vertex, [f32; 3]>,
    options: &FillOptions,
    start: M::HalfEdge,
    edges: &mut Edges,
    faces: &mut Vec<[u32; 3]>,
) -> Result<(), LeftReason> {
    let curve = loops::closed_curve(mesh, start, options.max_edges)?;
    let mut chords = Vec::new();
    let mut way = Ok(());
    for half_edges in loops::simple(mesh, &curve) {
        let hole = loops::Hole::of(mesh, positions, &half_edges);
        let Some(triangles) = hole.triangles(options, edges) else {
            way = Err(LeftReason::NoWay);
            break;
        };
        for [i, j, k] in triangles {
            faces.push([i, j, k].map(|i| hole.vertices[i]));
            hole.chords([i, j, k]).for_each(|chord| chords.extend(edges.insert(chord).then_some(chord)));
        }
    }
    if way.is_err() {
        chords.into_iter().for_each(|chord| edges.remove(chord));
    }
    way
}

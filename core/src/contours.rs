//! Contours: lines along which a scalar field has one value.
//!
//! A vertex whose value is exactly a level counts as above it. So every face has none of its sides crossed by a
//! level, or exactly two, one that runs down through the level and one that runs up: a line that comes in over
//! one leaves over the other, and there is nowhere to branch. What follows from the rule:
//!
//! - A face of one value is never crossed: the line of a plateau that lies at the level runs along the
//!   plateau's edge, where the surface goes down.
//! - Where a line runs through a vertex, several of its crossings, of edges at that vertex, are the same point.
//! - A line goes on across every edge of exactly two faces, whichever way these run along it. At an edge of one
//!   face, or of three and more, it ends, and each of the faces has a crossing of its own there.
//! - The ground above the level is on the left of a line, where faces agree in orientation: the line around a
//!   summit runs counter-clockwise. Where faces disagree, it is on the left at the line's first face.
use crate::{Adjacency, Handle, Map, NotFinite, Topology, not_finite, vector, vector::Vector};
use alloc::vec::Vec;

mod buckets;
mod trace;

/// The most levels that [`levels`] gives.
const MOST_LEVELS: f64 = 16_777_216.0;

/// The contours of a mesh: what [`contours()`] gives.
#[derive(Clone, Debug, PartialEq)]
pub struct Contours<H> {
    lines: Vec<Span>,
    crossings: Vec<Crossing<H>>,
}

/// A line, as the end of its crossings in the list of all.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Span {
    level: f32,
    is_closed: bool,
    end: usize,
}

/// A polyline along which the field has one value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Line<'a, H> {
    /// The value.
    pub level: f32,
    /// Whether the last crossing is joined to the first, which is not said twice. A line that is not closed
    /// ends on the boundary, or at an edge of three or more faces.
    pub is_closed: bool,
    /// Where the line crosses edges, in order; between two that follow one another it runs straight through a
    /// face.
    pub crossings: &'a [Crossing<H>],
}

/// Where a line crosses an edge: at `origin + t (target - origin)` of the half-edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing<H> {
    /// The side of the face that the line goes into; for the last crossing of an open line, of the face that it
    /// comes from.
    pub half_edge: H,
    /// The part of the half-edge that lies before the crossing, from 0 to 1.
    pub t: f64,
}

impl<H> Contours<H> {
    /// All lines, those of the lowest level first. Among those of one level, open ones come first.
    pub fn lines(&self) -> impl ExactSizeIterator<Item = Line<'_, H>> {
        let mut start = 0;
        self.lines.iter().map(move |&Span { level, is_closed, end }| {
            let crossings = &self.crossings[start..end];
            start = end;
            Line { level, is_closed, crossings }
        })
    }

    /// Number of crossings of all lines.
    pub fn crossing_count(&self) -> usize {
        self.crossings.len()
    }
}

impl<H: Handle> Line<'_, H> {
    /// Number of straight pieces, each through one face: as many as crossings, or one fewer where the line is
    /// open.
    pub fn segment_count(&self) -> usize {
        self.crossings.len() - usize::from(!self.is_closed)
    }

    /// The length, in the unit of the positions. O(crossings).
    pub fn length<M>(&self, mesh: &M, positions: &Map<M::Vertex, [f32; 3]>) -> f64
    where
        M: Topology<HalfEdge = H> + ?Sized,
    {
        let point = |c: &Crossing<H>| c.point(mesh, positions);
        let closing = self.is_closed.then(|| [self.crossings.last(), self.crossings.first()]);
        let pieces = self.crossings.windows(2).map(|w| [&w[0], &w[1]]);
        let closing = closing.into_iter().filter_map(|[last, first]| Some([last?, first?]));
        pieces.chain(closing).map(|[a, b]| vector::length(vector::minus(point(b), point(a)))).sum()
    }
}

impl<H: Handle> Crossing<H> {
    /// The point of the crossing.
    #[inline]
    pub fn point<M>(&self, mesh: &M, positions: &Map<M::Vertex, [f32; 3]>) -> Vector
    where
        M: Topology<HalfEdge = H> + ?Sized,
    {
        let [from, to] = [mesh.origin(self.half_edge), mesh.target(self.half_edge)].map(|v| positions[v]);
        let [from, to] = [vector::of(from), vector::of(to)];
        vector::plus(vector::times(1.0 - self.t, from), vector::times(self.t, to))
    }
}

/// Equidistant levels: the multiples of `step` from `min` to `max`, both included.
///
/// # Arguments
/// The step in the unit of the field, and the range of the field or a part of it.
///
/// # Returns
/// The levels, ascending, each once: multiples that are the same `f32` are one level. None where `step` is not
/// positive, where one of the three is not finite, or where the multiples would be more than 16,777,216, as
/// many as an `f32` tells apart at its precision.
///
/// # Complexity
/// O(levels).
///
/// # Example
/// ```
/// use onering_core::contours;
/// assert_eq!(contours::levels(0.5, -0.7, 1.0), [-0.5, 0.0, 0.5, 1.0]);
/// ```
pub fn levels(step: f32, min: f32, max: f32) -> Vec<f32> {
    let [step, min, max] = [step, min, max].map(f64::from);
    let [first, last] = [libm::ceil(min / step), libm::floor(max / step)];
    let is_possible =
        step > 0.0 && [step, min, max].iter().all(|x| x.is_finite()) && last - first < MOST_LEVELS;
    let count = if is_possible && first <= last { (last - first) as usize + 1 } else { 0 };
    let mut levels: Vec<f32> = (0..count).map(|i| ((first + i as f64) * step) as f32).collect();
    levels.dedup();
    levels
}

/// The lines along which `field` has one of `levels`, as ordered polylines.
///
/// # Arguments
/// A value for each vertex, such as its height, and the levels, in any order; one that is given twice is one
/// level, and one that is not finite crosses nothing.
///
/// # Returns
/// The lines, by ascending level. Each segment through a face is in exactly one line, once; so is each crossing
/// of an edge of one or two faces. The module says what happens at vertices that are exactly on a level, at
/// plateaus and where the mesh is no manifold.
///
/// # Complexity
/// O(faces + vertices log levels + segments). Scratch: 4 bytes for each vertex and face, 12 for each level, and
/// 4 for each segment; the answer takes 16 bytes for each crossing.
///
/// # Errors
/// [`NotFinite`] where a value is infinite or no number.
///
/// # Panics
/// If `field` is shorter than the list of vertices.
///
/// # Example
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, Map, contours};
/// // A pyramid of height 1 over a square.
/// let mesh = Mesh::from_faces(5, &[[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])?;
/// let height = Map::from(vec![0.0, 0.0, 0.0, 0.0, 1.0]);
/// let lines = contours::contours(&mesh, &height, &[0.25, 0.75])?;
/// let lines: Vec<_> = lines.lines().map(|line| (line.level, line.is_closed, line.crossings.len())).collect();
/// assert_eq!(lines, [(0.25, true, 4), (0.75, true, 4)]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Source
/// Figueiredo et al. (2014), section 6.3, Algorithm 4, which gives the segments of one level, loose. The rule
/// for values on a level is the symbolic perturbation of Edelsbrunner and Muecke (1990).
pub fn contours<M: Adjacency + ?Sized>(
    mesh: &M,
    field: &Map<M::Vertex, f32>,
    levels: &[f32],
) -> Result<Contours<M::HalfEdge>, NotFinite> {
    not_finite::values(field)?;
    let mut levels: Vec<f32> = levels.iter().copied().filter(|level| level.is_finite()).collect();
    levels.sort_unstable_by(f32::total_cmp);
    levels.dedup();
    Ok(trace::Tracer::new(mesh, field, &levels).lines())
}

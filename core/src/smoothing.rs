//! Laplacian smoothing: vertices move towards the mean of their neighbours, step by step.
use crate::{
    Adjacency, Map, NotFinite, edges, not_finite, triangle,
    vector::{self, Vector},
};
use core::{error::Error, fmt};

/// How much each neighbour counts in the mean. Weights are never negative.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Weights {
    /// All alike: evens out the lengths of edges as well, and so moves vertices along the surface.
    #[default]
    Uniform,
    /// By the sum of the cotangents of the angles that face the edge: moves vertices along the normal, and keeps the
    /// shape of triangles. Where that sum is negative, by obtuse angles, it counts as zero, which keeps every step
    /// stable; so does the angle of a degenerate face. A vertex all of whose weights are zero stays.
    Cotangent,
}

/// How to smooth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// How much each neighbour counts.
    pub weights: Weights,
    /// Number of steps; with `mu`, of pairs of steps.
    pub steps: usize,
    /// The part of the way to the mean of its neighbours that a vertex goes in a step: above 0, at most 1. In this
    /// range a step is stable: each position is a mean of old ones, so none leaves their convex hull.
    pub lambda: f64,
    /// After each step another by this factor, away from the mean, so that smooth parts keep their size: negative,
    /// and beyond `-lambda` (Taubin). Waves of the frequency 1/lambda + 1/mu keep their height, lower ones grow a
    /// little, higher ones shrink; the highest, 2, do not grow where (1 - 2 lambda)(1 - 2 mu) is at least -1, which
    /// is asked for.
    pub mu: Option<f64>,
}

impl Default for Options {
    /// Ten steps of half the way, by uniform weights.
    fn default() -> Self {
        Self { weights: Weights::Uniform, steps: 10, lambda: 0.5, mu: None }
    }
}

impl Options {
    /// Taubin's smoothing against shrinking, with the factors that he uses: 0.33 and -0.34.
    pub fn taubin(weights: Weights, steps: usize) -> Self {
        Self { weights, steps, lambda: 0.33, mu: Some(-0.34) }
    }

    fn check(&self) -> Result<(), SmoothingError> {
        let lambda = self.lambda;
        if !(lambda > 0.0 && lambda <= 1.0) {
            return Err(SmoothingError::Lambda(lambda));
        }
        match self.mu {
            Some(mu) if !(mu < -lambda && (1.0 - 2.0 * lambda) * (1.0 - 2.0 * mu) >= -1.0) => {
                Err(SmoothingError::Mu { lambda, mu })
            }
            _ => Ok(()),
        }
    }
}

/// Why a mesh is not smoothed.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum SmoothingError {
    /// A coordinate is infinite or no number; or became so, which takes many steps with a `mu`.
    NotFinite(NotFinite),
    /// `lambda` is not above 0 and at most 1.
    Lambda(f64),
    /// `mu` is not below `-lambda`, or so far that the steps are not stable.
    Mu {
        /// The factor of the steps inward.
        lambda: f64,
        /// The factor of the steps outward.
        mu: f64,
    },
}

impl From<NotFinite> for SmoothingError {
    fn from(error: NotFinite) -> Self {
        Self::NotFinite(error)
    }
}

impl fmt::Display for SmoothingError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite(error) => error.fmt(f),
            Self::Lambda(lambda) => write!(f, "lambda has to be above 0 and at most 1, and is {lambda}"),
            Self::Mu { lambda, mu } => write!(
                f,
                "mu has to be below -lambda, with (1 - 2 lambda)(1 - 2 mu) at least -1; it is {mu}, with lambda {lambda}"
            ),
        }
    }
}

impl Error for SmoothingError {}

/// Smooths positions in place: in each step every vertex goes a part of the way to the weighted mean of its
/// neighbours, all at once, by the positions of the step before.
///
/// Vertices of boundary edges stay where they are, so holes and the rim of an open surface do; so do isolated
/// vertices, and those of the caller. An edge of three or more faces is one edge, its weight the sum over all of
/// them.
///
/// # Arguments
/// `positions`: of all vertices; changed. `is_fixed`: vertices that stay besides; `|_| false` for none. `options`:
/// weights, number of steps, and factors.
///
/// # Returns
/// The positions, in place. Between steps they are `f64`, and are rounded once, at the end. All are finite.
///
/// # Complexity
/// O(vertices + half-edges) a step; 69 bytes for each vertex, taken once for all steps.
///
/// # Errors
/// [`SmoothingError`]; positions are then unchanged. Panics if a position is missing.
///
/// # Example
/// ```
/// # use onering::CheL1 as Mesh;
/// use onering_core::{FromFaces, smoothing::{self, Options}};
/// let pyramid = Mesh::from_faces(5, &[[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])?;
/// let base = [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [2.0, 2.0, 0.0], [0.0, 2.0, 0.0]];
/// let mut positions = [&base[..], &[[1.0, 1.0, 8.0]]].concat().into();
/// smoothing::smooth(&pyramid, &mut positions, |_| false, &Options { steps: 3, ..Options::default() }).unwrap();
/// assert_eq!(positions.as_slice()[..4], base);
/// assert_eq!(positions.as_slice()[4], [1.0, 1.0, 1.0]);
/// # Ok::<(), onering_core::BuildError>(())
/// ```
///
/// # Source
/// Uniform: D. A. Field, *Laplacian smoothing and Delaunay triangulations*, 1988. Cotangents: M. Desbrun, M. Meyer,
/// P. Schröder and A. H. Barr, *Implicit fairing of irregular meshes using diffusion and curvature flow*, SIGGRAPH
/// 1999, here by explicit steps. Two factors: G. Taubin, *A signal processing approach to fair surface design*,
/// SIGGRAPH 1995.
pub fn smooth<M: Adjacency + ?Sized>(
    mesh: &M,
    positions: &mut Map<M::Vertex, [f32; 3]>,
    mut is_fixed: impl FnMut(M::Vertex) -> bool,
    options: &Options,
) -> Result<(), SmoothingError> {
    options.check()?;
    not_finite::positions(positions)?;
    let mut state = State {
        mesh,
        is_free: mesh.vertices().map(|v| !is_fixed(v)).collect(),
        at: mesh.vertices().map(|v| vector::of(positions[v])).collect(),
        sums: Map::filled(mesh.vertex_count(), ([0.0; 3], 0.0)),
    };
    state.keep_boundary();
    for _ in 0..options.steps {
        state.step(options.weights, options.lambda);
        options.mu.into_iter().for_each(|mu| state.step(options.weights, mu));
    }
    let smoothed: Map<M::Vertex, _> = state.at.iter().map(|(_, &at)| vector::rounded(at)).collect();
    not_finite::positions(&smoothed)?;
    // Positions beyond the vertices are none of ours.
    positions.as_mut_slice()[..smoothed.len()].copy_from_slice(smoothed.as_slice());
    Ok(())
}

/// What is kept from step to step.
struct State<'a, M: Adjacency + ?Sized> {
    mesh: &'a M,
    is_free: Map<M::Vertex, bool>,
    at: Map<M::Vertex, Vector>,
    /// The weighted sum of the neighbours, and that of the weights.
    sums: Map<M::Vertex, (Vector, f64)>,
}

impl<M: Adjacency + ?Sized> State<'_, M> {
    fn keep_boundary(&mut self) {
        let mesh = self.mesh;
        for h in mesh.half_edges().filter(|&h| mesh.is_boundary(h)) {
            self.is_free[mesh.origin(h)] = false;
            self.is_free[mesh.target(h)] = false;
        }
    }

    /// Moves every free vertex by `factor` times the way to the mean of its neighbours.
    fn step(&mut self, weights: Weights, factor: f64) {
        self.sums.as_mut_slice().fill(([0.0; 3], 0.0));
        for h in edges::each(self.mesh) {
            let weight = match weights {
                Weights::Uniform => 1.0,
                Weights::Cotangent => self.cotangents(h).max(0.0),
            };
            let ends = [self.mesh.origin(h), self.mesh.target(h)];
            for [v, u] in [ends, [ends[1], ends[0]]] {
                let (sum, total) = &mut self.sums[v];
                *sum = vector::plus(*sum, vector::times(weight, self.at[u]));
                *total += weight;
            }
        }
        for ((v, at), (_, &(sum, total))) in self.at.iter_mut().zip(self.sums.iter()) {
            if self.is_free[v] && total > 0.0 {
                let way = vector::minus(sum.map(|x| x / total), *at);
                *at = vector::plus(*at, vector::times(factor, way));
            }
        }
    }

    /// The sum of the cotangents of the angles that face the edge of `h`.
    fn cotangents(&self, h: M::HalfEdge) -> f64 {
        let at = |h| self.at[self.mesh.origin(h)];
        let (p, q) = (at(h), at(self.mesh.next(h)));
        self.mesh.edge_fan(h).map(|g| triangle::cotangent(at(self.mesh.prev(g)), p, q)).sum()
    }
}

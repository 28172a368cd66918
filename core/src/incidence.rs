//! [`Incidence`]: neighbourhoods from a vertex.
use crate::{
    Adjacency,
    ring::{self, OneOrSeveral, OneRing, Star},
};

/// Knows where to start around each vertex (Compact Half-Edge level 2, directed edges and up), so that its
/// neighbourhood takes O(degree).
///
/// A *fan* of a vertex is a run of its faces, each reached from the one before by
/// [`rotate_ccw`](Adjacency::rotate_ccw). On a manifold every vertex that is not isolated has one. A structure that
/// knows the neighbour across faces that disagree in orientation (Mate-Face) may go on there, and says so.
///
/// ```compile_fail,E0277
/// # use onering_core::*;
/// fn degree<M: Incidence>(mesh: &M, v: M::Vertex) -> usize {
///     mesh.star(v).count()
/// }
/// fn isolated<M: Adjacency>(mesh: &M) -> usize {
///     mesh.vertices().filter(|&v| degree(mesh, v) == 0).count() // the error names `WithOutgoing::new(mesh)`
/// }
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` cannot start from a vertex",
    label = "this mesh has no `outgoing`",
    note = "wrap it in `WithOutgoing::new(mesh)` (or `Searched::new(mesh)`, O(faces) a step), or choose a backend with an `outgoing` column, such as `CheL2` or `DirectedEdgesSmall`",
    note = "for `onering::Mesh`, turn on the feature `incidence` or a preset that has it, such as `che-l2`"
)]
pub trait Incidence: Adjacency {
    /// The start of the first fan of `v`: its most clockwise half-edge, so that one counter-clockwise turn sees
    /// the whole fan. `None` when `v` is isolated. O(1), but for boundary vertices of a sorted opposite table.
    ///
    /// Open fans come before closed ones: `v` has an open fan if and only if `opposite` of this is `None` (but where
    /// a fan goes on across faces that disagree in orientation: see above).
    fn outgoing(&self, v: Self::Vertex) -> Option<Self::HalfEdge>;

    /// The start of every fan of `v`, that of [`outgoing`](Self::outgoing) first.
    #[inline]
    fn fans(&self, v: Self::Vertex) -> impl Iterator<Item = Self::HalfEdge> {
        self.outgoing(v).into_iter()
    }

    /// Whether `v` has more than one fan, so that its neighbours are not all in [`one_ring`](Self::one_ring).
    #[inline]
    fn has_several_fans(&self, v: Self::Vertex) -> bool {
        self.fans(v).nth(1).is_some()
    }

    /// The half-edges out of `v`, one for each of its faces, fan after fan, counter-clockwise.
    #[inline]
    fn star(&self, v: Self::Vertex) -> impl Iterator<Item = Self::HalfEdge> {
        Star::new(self, self.fans(v))
    }

    /// The neighbours of `v` around its first fan, counter-clockwise: one more than faces where it is open.
    #[inline]
    fn one_ring(&self, v: Self::Vertex) -> impl Iterator<Item = Self::Vertex> {
        OneRing::new(self, self.outgoing(v))
    }

    /// All neighbours of `v`, each once. On a manifold, the same as [`one_ring`](Self::one_ring).
    #[inline]
    fn neighbours(&self, v: Self::Vertex) -> impl Iterator<Item = Self::Vertex> {
        if self.has_several_fans(v) {
            // An edge of three or more faces leads to a neighbour that several fans share.
            OneOrSeveral::Several(ring::each_neighbour_once(self, v))
        } else {
            OneOrSeveral::One(self.one_ring(v))
        }
    }
}

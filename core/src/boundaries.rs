//! [`Boundaries`]: names for boundary curves.
use crate::{Adjacency, Handle, boundary::Curve, handle::Handles};

/// Names boundary curves (Compact Half-Edge level 3).
///
/// A curve is a run of boundary half-edges, each followed by the next one around its target. On a manifold it
/// is closed. It ends early where that turn is stopped by an edge of three or more faces or by two faces that
/// disagree in orientation.
///
/// ```compile_fail,E0277
/// # use onering_core::*;
/// fn holes(mesh: &impl Boundaries) -> usize {
///     mesh.curve_count()
/// }
/// fn is_closed(mesh: &impl Adjacency) -> bool {
///     holes(mesh) == 0 // the error names `boundary::curves(&mesh)`
/// }
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` has no names for boundary curves",
    label = "this mesh keeps no boundary curves",
    note = "find them with `boundary::curves(&mesh)`, or choose a backend that keeps them: `CheL3`",
    note = "for `onering::Mesh`, turn on the feature `boundary-curves` or the preset `che-l3`"
)]
pub trait Boundaries: Adjacency {
    /// Names a boundary curve.
    type Curve: Handle;

    /// Number of boundary curves. Curve handles have the indices below it.
    fn curve_count(&self) -> usize;

    /// The first half-edge of curve `c`. O(1).
    fn curve_start(&self, c: Self::Curve) -> Self::HalfEdge;

    /// The curve that `h` lies along; `None` where `h` is not on the boundary. O(1).
    fn curve_of(&self, h: Self::HalfEdge) -> Option<Self::Curve>;

    /// Every boundary curve.
    fn curves(&self) -> Handles<Self::Curve> {
        Handles::below(self.curve_count())
    }

    /// The half-edges along `c`, in order, the faces on their left.
    fn curve(&self, c: Self::Curve) -> impl Iterator<Item = Self::HalfEdge> {
        Curve::new(self, self.curve_start(c))
    }
}

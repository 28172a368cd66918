//! [`NotFinite`]: a value at a vertex that is no number to calculate with.
use crate::{Handle, Map};
use core::{error::Error, fmt};

/// A vertex has a coordinate or a value that is infinite or no number, so what was asked for has no meaning.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotFinite {
    /// The first such vertex, by its index.
    pub vertex: usize,
}

impl fmt::Display for NotFinite {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "vertex {} has a coordinate or a value that is infinite or no number", self.vertex)
    }
}

impl Error for NotFinite {}

/// Checks the values of all vertices. O(vertices).
pub(crate) fn values<V: Handle>(values: &Map<V, f32>) -> Result<(), NotFinite> {
    first(values.as_slice(), |x| x.is_finite())
}

/// Checks the positions of all vertices. O(vertices).
pub(crate) fn positions<V: Handle>(positions: &Map<V, [f32; 3]>) -> Result<(), NotFinite> {
    first(positions.as_slice(), |p| p.iter().all(|x| x.is_finite()))
}

fn first<T>(cells: &[T], is_finite: impl Fn(&T) -> bool) -> Result<(), NotFinite> {
    cells.iter().position(|cell| !is_finite(cell)).map_or(Ok(()), |vertex| Err(NotFinite { vertex }))
}

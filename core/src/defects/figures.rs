//! The figures as a table of name and value, for reports and comparisons.

use super::Defects;
use core::fmt;

/// One value of [`Defects::figures`]; its `Display` is JSON.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Figure {
    /// A number of elements; only the Euler characteristic can be below zero.
    Count(i128),
    /// Yes or no.
    Flag(bool),
    /// What has no meaning for this mesh; `null`.
    Undefined,
}

impl fmt::Display for Figure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Count(n) => n.fmt(f),
            Self::Flag(flag) => flag.fmt(f),
            Self::Undefined => f.write_str("null"),
        }
    }
}

impl From<usize> for Figure {
    fn from(count: usize) -> Self {
        Self::Count(count as i128)
    }
}

impl From<i64> for Figure {
    fn from(count: i64) -> Self {
        Self::Count(count.into())
    }
}

impl From<bool> for Figure {
    fn from(flag: bool) -> Self {
        Self::Flag(flag)
    }
}

impl From<Option<usize>> for Figure {
    fn from(count: Option<usize>) -> Self {
        count.map_or(Self::Undefined, Self::from)
    }
}

macro_rules! named {
    ($defects:ident: $($name:ident)*) => { [$((stringify!($name), Figure::from($defects.$name)),)*] };
}

impl Defects {
    /// Every figure under the name of its field, in the order of the fields.
    pub fn figures(&self) -> impl Iterator<Item = (&'static str, Figure)> + use<> {
        let figures = named!(self:
            out_of_range_faces degenerate_faces duplicate_faces duplicate_faces_same_orientation
            isolated_vertices edges boundary_edges nonmanifold_edges max_faces_per_edge inconsistent_edges
            repeated_halfedges bowtie_vertices nonmanifold_vertices components components_by_vertex euler
            boundary_components boundary_loops patches nonorientable_patches orientable min_flips closed
            manifold genus valence_min valence_max max_faces_per_vertex);
        figures.into_iter()
    }
}

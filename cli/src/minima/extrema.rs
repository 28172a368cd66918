//! Minima, maxima and saddles with their places.

use crate::failure::Failure;
use crate::surface::Surface;
use onering::{Handle, Incidence, critical};
use onering_io::{Error, Lines};
use serde::Serialize;

/// What was found, each kind by ascending vertex.
#[derive(Debug, Default)]
pub(crate) struct Extrema {
    pub(crate) minima: Vec<Extremum>,
    pub(crate) maxima: Vec<Extremum>,
    pub(crate) saddles: Vec<Extremum>,
}

/// A vertex where the field turns.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub(crate) struct Extremum {
    /// Counted from 0, after welding and repair.
    pub(crate) vertex: usize,
    pub(crate) position: [f32; 3],
    /// The field there.
    pub(crate) value: f32,
    /// Of a saddle: how many simple ones it would make.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(crate) multiplicity: Option<usize>,
}

impl Extrema {
    /// The minima alone.
    pub(crate) fn minima<M: Incidence>(mesh: &M, surface: &Surface) -> Result<Self, Failure> {
        let minima = critical::local_minima(mesh, &surface.field());
        let minima = minima.map_err(|error| surface.failure(&error))?;
        Ok(Self { minima: extrema(surface, minima), ..Self::default() })
    }

    /// All of them as points, with the value of the field, and the name of that.
    pub(crate) fn points(&self, value_name: &str) -> Result<Lines, Error> {
        let mut points = Lines::new(value_name);
        let all = [&self.minima, &self.maxima, &self.saddles].into_iter().flatten();
        for extremum in all {
            points.push([extremum.position], false, extremum.value)?;
        }
        Ok(points)
    }
}

/// The vertices, with their places.
pub(super) fn extrema<V: Handle>(surface: &Surface, vertices: Vec<V>) -> Vec<Extremum> {
    vertices.into_iter().map(|v| extremum(surface, v, None)).collect()
}

/// The saddles, with their places.
pub(super) fn saddles<V: Handle>(surface: &Surface, saddles: Vec<(V, usize)>) -> Vec<Extremum> {
    saddles.into_iter().map(|(v, multiplicity)| extremum(surface, v, Some(multiplicity))).collect()
}

fn extremum<V: Handle>(surface: &Surface, v: V, multiplicity: Option<usize>) -> Extremum {
    let position = surface.mesh.positions[v.index()];
    Extremum { vertex: v.index(), position, value: surface.value(position), multiplicity }
}

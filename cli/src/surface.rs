//! A mesh as it is seen from above, with a field on it.

use crate::args::{Heights, MeshFile};
use crate::failure::Failure;
use crate::up::{Up, has_y_up_and_metres};
use crate::{input, made, on_backend};
use onering::{Handle, Map, NotFinite};
use onering_io::{Triangles, one_line};
use std::fmt::Display;

/// What is looked at where no file is named.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Made {
    name: &'static str,
    mesh: fn() -> Triangles,
}

pub(crate) const TERRAIN: Made = Made { name: "hills and hollows (made here)", mesh: made::terrain::mesh };
pub(crate) const ROOF: Made = Made { name: "roof of a cave (made here)", mesh: made::roof::mesh };

/// A mesh whose coordinates are all finite.
#[derive(Debug)]
pub(crate) struct Surface {
    /// What to call it.
    pub(crate) name: String,
    pub(crate) mesh: Triangles,
    pub(crate) up: Up,
    /// The unit of the coordinates; empty where it is not known.
    pub(crate) unit: String,
    /// The coordinate that is the field; the height where there is none.
    coordinate: Option<usize>,
}

impl Surface {
    /// The mesh of the command line, `made` where no file is named.
    ///
    /// # Errors
    /// What [`on_backend::read`] says, and where a coordinate is infinite or no number.
    pub(crate) fn read(
        file: &MeshFile,
        made: Made,
        up: Option<Up>,
        unit: Option<&str>,
    ) -> Result<Self, Failure> {
        let (mesh, format) = on_backend::read_with_format(file, made.mesh)?;
        let name = file.file.as_deref().map_or(made.name.into(), input::name_of);
        let finite = |p: &[f32; 3]| p.iter().all(|x| x.is_finite());
        if let Some(vertex) = mesh.positions.iter().position(|p| !finite(p)) {
            return Err(Failure::Input(format!("{name}: {}", NotFinite { vertex })));
        }
        let metres = if format.is_none_or(has_y_up_and_metres) { "m" } else { "" };
        let unit = one_line(unit.unwrap_or(metres));
        Ok(Self { name, mesh, up: up.unwrap_or(Up::of_format(format)), unit, coordinate: None })
    }

    /// As [`read`](Self::read), with the field that is asked for.
    pub(crate) fn with_field(file: &MeshFile, made: Made, heights: &Heights) -> Result<Self, Failure> {
        let surface = Self::read(file, made, heights.up, heights.unit.as_deref())?;
        Ok(Self { coordinate: heights.field(), ..surface })
    }

    /// What the field is: the height, or a coordinate.
    pub(crate) fn field_name(&self) -> &'static str {
        self.coordinate.map_or("height", |i| ["x", "y", "z"][i])
    }

    /// The field at a point.
    pub(crate) fn value(&self, point: [f32; 3]) -> f32 {
        self.coordinate.map_or_else(|| self.up.turned(point)[2], |i| point[i])
    }

    /// The field at every vertex.
    pub(crate) fn field<V: Handle>(&self) -> Map<V, f32> {
        self.mesh.positions.iter().map(|p| self.value(*p)).collect()
    }

    /// The positions, as the file has them.
    pub(crate) fn positions<V: Handle>(&self) -> Map<V, [f32; 3]> {
        self.mesh.positions.iter().copied().collect()
    }

    /// The positions with the third coordinate up.
    pub(crate) fn turned<V: Handle>(&self) -> Map<V, [f32; 3]> {
        self.mesh.positions.iter().map(|p| self.up.turned(*p)).collect()
    }

    /// The least and the largest value at the corners of faces; `None` without faces.
    pub(crate) fn range(&self) -> Option<[f32; 2]> {
        let corners = self.mesh.faces.as_flattened().iter();
        let values = corners.map(|&v| self.value(self.mesh.positions[v as usize]));
        values.fold(None, |range, value| match range {
            None => Some([value; 2]),
            Some([least, most]) => Some([value.min(least), value.max(most)]),
        })
    }

    /// The failure, with the name of the mesh.
    pub(crate) fn failure(&self, error: &dyn Display) -> Failure {
        Failure::Output(format!("{}: {error}", self.name))
    }

    /// ` m`, or nothing.
    pub(crate) fn with_unit(&self, power: &str) -> String {
        if self.unit.is_empty() { String::new() } else { format!(" {}{power}", self.unit) }
    }
}

//! What a format can hold, found out by writing a mesh that has everything and reading it back: it cannot be out of
//! date, whatever formats there are.

use super::ring;
use onering_io::{Attribute, Format, MeshRef, Triangles, Values};

/// What comes back of a mesh that was written in a format.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Holds {
    /// Polygons of more than three corners.
    pub(crate) polygons: bool,
    /// Vertices in no face.
    pub(crate) isolated_vertices: bool,
    /// Several vertices at one position.
    pub(crate) equal_positions: bool,
    /// Values at vertices, as numbers or as colours.
    pub(crate) attributes: bool,
}

/// In no face.
const APART: [f32; 3] = [9.0, 9.0, 9.0];

/// `APART`, a square, and a triangle at one of its corners but with a vertex of its own there.
const POSITIONS: [[f32; 3]; 8] = [
    APART,
    [0.0, 0.0, 0.0],
    [1.0, 0.0, 0.0],
    [1.0, 1.0, 0.0],
    [0.0, 1.0, 0.0],
    [0.0, 0.0, 0.0],
    [-1.0, 0.0, 0.0],
    [0.0, -1.0, 0.0],
];
const FACES: [[u32; 3]; 3] = [[1, 2, 3], [1, 3, 4], [5, 6, 7]];
const POLYGON_STARTS: [u32; 2] = [0, 2];

impl Holds {
    /// Nothing, where the format is not written.
    pub(crate) fn of(format: Format) -> Self {
        if format == Format::Ring {
            return ring::HOLDS;
        }
        let plain = written(mesh(), format);
        let back = onering_io::read_as(&plain, format).unwrap_or_default();
        let count = |position: [f32; 3]| back.positions.iter().filter(|p| **p == position).count();
        let labels = [0; POSITIONS.len()];
        let attributes = [Attribute { name: "label", values: Values::Labels(&labels) }];
        let with_attributes = written(mesh().with_vertex_attributes(&attributes), format);
        Self {
            polygons: has_square(&back),
            isolated_vertices: count(APART) == 1,
            equal_positions: count([0.0; 3]) == 2,
            attributes: with_attributes != plain,
        }
    }
}

fn mesh() -> MeshRef<'static> {
    let mut mesh = MeshRef::new(&POSITIONS, &FACES);
    mesh.polygon_starts = Some(&POLYGON_STARTS);
    mesh
}

fn written(mesh: MeshRef<'_>, format: Format) -> Vec<u8> {
    let mut bytes = Vec::new();
    match onering_io::write(&mut bytes, mesh, format) {
        Ok(()) => bytes,
        Err(_) => Vec::new(),
    }
}

fn has_square(mesh: &Triangles) -> bool {
    mesh.polygon_sizes.contains_key(&4)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::args::is_written;

    #[test]
    fn obj_holds_polygons_and_vertices_but_no_values() {
        let expected =
            Holds { polygons: true, isolated_vertices: true, equal_positions: true, ..Holds::default() };
        assert_eq!(Holds::of(Format::Obj), expected);
    }

    #[test]
    fn what_is_not_written_holds_nothing() {
        for format in Format::all().filter(|format| !is_written(*format)) {
            assert_eq!(Holds::of(format), Holds::default(), "{format}");
        }
    }

    #[test]
    fn what_is_written_comes_back() {
        for format in Format::all().filter(|format| format.is_written()) {
            let back = onering_io::read_as(&written(mesh(), format), format).unwrap();
            assert_eq!(back.faces.len(), FACES.len(), "{format}");
        }
    }
}

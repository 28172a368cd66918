//! What the buffer of a GLB is made of.

use std::io::{self, Write};

use super::{UNSIGNED_INT, UNSIGNED_SHORT};
use crate::attribute::{unique_names, word};
use crate::block::Block;
use crate::colour::{Colours, linear_table};
use crate::{MeshRef, Place, Reason, Values};

/// A column for each attribute of the primitive, one after the other, then the indices.
pub(super) struct Parts<'a> {
    pub(super) mesh: &'a MeshRef<'a>,
    /// Whether each face has three vertices of its own. There are no indices then.
    split: bool,
    pub(super) columns: Vec<Column<'a>>,
}

/// An attribute of the primitive.
pub(super) struct Column<'a> {
    pub(super) semantic: String,
    pub(super) data: Data<'a>,
    /// Whether the data are of faces and not of vertices.
    of_faces: bool,
}

pub(super) enum Data<'a> {
    Positions(&'a [[f32; 3]]),
    Colours(Colours<'a>),
    Values(Values<'a>),
}

impl<'a> Parts<'a> {
    pub(super) fn of(mesh: &'a MeshRef<'a>) -> Self {
        let split = !mesh.face_attributes.is_empty() && !mesh.faces.is_empty();
        let positions = Data::Positions(mesh.positions);
        let mut columns = vec![Column { semantic: "POSITION".into(), data: positions, of_faces: false }];
        let of_faces = mesh.face_attributes.iter().filter(|_| split).map(|attribute| (attribute, true));
        let all =
            || mesh.vertex_attributes.iter().map(|attribute| (attribute, false)).chain(of_faces.clone());
        if let Some((first, of_faces)) = all().next() {
            let data = Data::Colours(Colours::of(first.values));
            columns.push(Column { semantic: "COLOR_0".into(), data, of_faces });
        }
        let names = all().map(|(attribute, _)| format!("_{}", word(attribute.name).to_ascii_uppercase()));
        let values = all().map(|(attribute, of_faces)| (Data::Values(attribute.values), of_faces));
        let named = unique_names(names, &[]).into_iter().zip(values);
        columns.extend(named.map(|(semantic, (data, of_faces))| Column { semantic, data, of_faces }));
        Self { mesh, split, columns }
    }

    /// Vertices of the primitive.
    pub(super) fn vertex_count(&self) -> usize {
        if self.split { 3 * self.mesh.faces.len() } else { self.mesh.positions.len() }
    }

    /// The vertex or the face of the mesh that vertex `i` of the primitive has the values of.
    #[inline(always)]
    fn source(&self, of_faces: bool, i: usize) -> usize {
        match (self.split, of_faces) {
            (false, _) => i,
            (true, false) => self.mesh.faces[i / 3][i % 3] as usize,
            (true, true) => i / 3,
        }
    }

    pub(super) fn has_indices(&self) -> bool {
        !self.split && !self.mesh.faces.is_empty()
    }

    /// The type of the indices, and its bytes. The largest of its values is never a vertex: it would restart a strip.
    pub(super) fn index_type(&self) -> (u32, u64) {
        let short = self.vertex_count() <= usize::from(u16::MAX);
        if short { (UNSIGNED_SHORT, 2) } else { (UNSIGNED_INT, 4) }
    }

    /// Bytes of the indices, without what fills up the chunk.
    pub(super) fn index_bytes(&self) -> u64 {
        if self.has_indices() { 3 * self.mesh.faces.len() as u64 * self.index_type().1 } else { 0 }
    }

    pub(super) fn column_bytes(&self, column: &Column<'_>) -> u64 {
        self.vertex_count() as u64 * column.data.size()
    }

    /// Bytes of all columns and the indices.
    fn used_bytes(&self) -> u64 {
        self.columns.iter().map(|column| self.column_bytes(column)).sum::<u64>() + self.index_bytes()
    }

    /// Bytes of the buffer, filled up to a multiple of four.
    pub(super) fn bytes(&self) -> u64 {
        self.used_bytes().next_multiple_of(4)
    }

    /// The least and the largest of each coordinate that is written: glTF demands them, and that they are finite.
    pub(super) fn bounds(&self, positions: &[[f32; 3]]) -> Result<[[f32; 3]; 2], (Place, Reason)> {
        let written = || (0..self.vertex_count()).map(|i| self.source(false, i));
        if let Some(bad) = written().find(|v| !positions[*v].iter().all(|x| x.is_finite())) {
            return Err((Place::Vertex(bad), Reason::NotFinite { what: "position".into() }));
        }
        let (mut min, mut max) = ([f32::INFINITY; 3], [f32::NEG_INFINITY; 3]);
        for position in written().map(|v| positions[v]) {
            min = std::array::from_fn(|c| min[c].min(position[c]));
            max = std::array::from_fn(|c| max[c].max(position[c]));
        }
        Ok([min, max])
    }

    pub(super) fn check_finite(&self, column: usize) -> Result<(), (Place, Reason)> {
        let Column { data: Data::Values(Values::Scalars(scalars)), of_faces, .. } = self.columns[column]
        else {
            return Ok(());
        };
        let written = (0..self.vertex_count()).map(|i| self.source(of_faces, i));
        let Some(bad) = written.into_iter().find(|i| !scalars[*i].is_finite()) else { return Ok(()) };
        let place = if of_faces { Place::Face(bad) } else { Place::Vertex(bad) };
        let what = self.columns[column].semantic.clone();
        Err((place, Reason::NotFinite { what }))
    }

    /// The buffer, in the order of the bufferViews.
    pub(super) fn write_columns(&self, out: &mut dyn Write) -> io::Result<()> {
        let mut block = Block::new(out);
        for column in &self.columns {
            self.write_column(column, &mut block)?;
        }
        if self.has_indices() {
            let faces = self.mesh.faces.iter();
            match self.index_type().1 {
                2 => block.put_all(faces.map(|face| short_bytes(*face)))?,
                _ => block.put_all::<12>(faces.map(|face| bytes_of(face.map(u32::to_le_bytes))))?,
            }
        }
        let filling = self.bytes() - self.used_bytes();
        block.bytes().extend(std::iter::repeat_n(0, filling as usize));
        block.finish()
    }

    fn write_column(&self, column: &Column<'_>, block: &mut Block<'_>) -> io::Result<()> {
        let sources = (0..self.vertex_count()).map(|i| self.source(column.of_faces, i));
        match &column.data {
            Data::Positions(positions) => {
                block.put_all::<12>(sources.map(|v| bytes_of(positions[v].map(f32::to_le_bytes))))
            }
            Data::Colours(colours) => {
                let linear = linear_table();
                block.put_all::<8>(sources.map(|i| {
                    let [r, g, b] = colours.at(i).map(|channel| linear[usize::from(channel)]);
                    bytes_of([r, g, b, u16::MAX].map(u16::to_le_bytes))
                }))
            }
            Data::Values(Values::Flags(flags)) => {
                block.put_all(sources.map(|i| f32::from(u8::from(flags[i])).to_le_bytes()))
            }
            Data::Values(Values::Labels(labels)) => {
                block.put_all(sources.map(|i| (labels[i] as f32).to_le_bytes()))
            }
            Data::Values(Values::Scalars(scalars)) => {
                block.put_all(sources.map(|i| scalars[i].to_le_bytes()))
            }
        }
    }
}

impl Data<'_> {
    /// Bytes for each vertex: multiples of four, as glTF wants them.
    fn size(&self) -> u64 {
        match self {
            Self::Positions(_) => 12,
            Self::Colours(_) => 8,
            Self::Values(_) => 4,
        }
    }
}

/// The bytes of all numbers; M is N times K.
#[inline(always)]
fn bytes_of<const K: usize, const N: usize, const M: usize>(numbers: [[u8; K]; N]) -> [u8; M] {
    let bytes = numbers.as_flattened();
    std::array::from_fn(|i| bytes[i])
}

/// The corners in 16 bits, which they fit in.
#[inline(always)]
fn short_bytes(face: [u32; 3]) -> [u8; 6] {
    bytes_of(face.map(|corner| (corner as u16).to_le_bytes()))
}

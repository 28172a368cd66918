//! A mesh as PLY: vertices, polygons, and every attribute as a property.

use std::io::{self, Write};

use super::encoding::{Ascii, Binary, Encoding};
use crate::attribute::{unique_names, word};
use crate::block::Block;
use crate::colour::Colours;
use crate::{Attribute, MeshRef, SaveOptions, Values};

/// What the header says of the faces.
struct Faces {
    count: usize,
    /// The type of the number of corners.
    size_type: &'static str,
    /// The type of a corner.
    corner_type: &'static str,
}

/// The properties of an element that come from attributes, in the order of the file.
struct Properties<'a> {
    /// The colours of the first attribute.
    colours: Option<Colours<'a>>,
    attributes: &'a [Attribute<'a>],
}

/// Flags are `uchar`, labels `uint`, scalars `float`. With values at the faces, which are triangles, the faces of the
/// file are these; else they are the polygons.
pub(crate) fn write(mesh: &MeshRef<'_>, out: &mut dyn Write, options: SaveOptions) -> io::Result<()> {
    let polygon_starts = mesh.polygon_starts.filter(|_| mesh.face_attributes.is_empty());
    let mesh = MeshRef { polygon_starts, ..*mesh };
    if options.ascii { write_as::<Ascii>(&mesh, out) } else { write_as::<Binary>(&mesh, out) }
}

fn write_as<E: Encoding>(mesh: &MeshRef<'_>, out: &mut dyn Write) -> io::Result<()> {
    let faces = Faces::of(mesh);
    write_header::<E>(mesh, &faces, out)?;
    let mut block = Block::new(out);
    let properties = Properties::of(mesh.vertex_attributes);
    for (v, position) in mesh.positions.iter().enumerate() {
        position.iter().for_each(|coordinate| E::float(block.bytes(), *coordinate));
        properties.put::<E>(block.bytes(), v);
        block.pass_on()?;
    }
    let properties = Properties::of(mesh.face_attributes);
    let small = faces.size_type == "uchar";
    mesh.each_polygon(|corners, f| {
        if small {
            E::uchar(block.bytes(), corners.len() as u8);
        } else {
            E::uint(block.bytes(), corners.len() as u32);
        }
        corners.iter().for_each(|corner| E::uint(block.bytes(), *corner));
        properties.put::<E>(block.bytes(), f);
        block.pass_on()
    })?;
    block.finish()
}

fn write_header<E: Encoding>(mesh: &MeshRef<'_>, faces: &Faces, out: &mut dyn Write) -> io::Result<()> {
    writeln!(out, "ply\nformat {} 1.0\nelement vertex {}", E::NAME, mesh.positions.len())?;
    out.write_all(b"property float x\nproperty float y\nproperty float z\n")?;
    declare(mesh.vertex_attributes, &["x", "y", "z", "red", "green", "blue"], out)?;
    let Faces { count, size_type, corner_type } = faces;
    writeln!(out, "element face {count}\nproperty list {size_type} {corner_type} vertex_indices")?;
    declare(mesh.face_attributes, &["vertex_indices", "vertex_index", "red", "green", "blue"], out)?;
    out.write_all(b"end_header\n")
}

/// The properties that come from attributes; none of them is named as one of `taken`.
fn declare(attributes: &[Attribute<'_>], taken: &[&str], out: &mut dyn Write) -> io::Result<()> {
    if !attributes.is_empty() {
        out.write_all(b"property uchar red\nproperty uchar green\nproperty uchar blue\n")?;
    }
    let names = unique_names(attributes.iter().map(|attribute| word(attribute.name)), taken);
    for (Attribute { values, .. }, name) in attributes.iter().zip(names) {
        let kind = match values {
            Values::Flags(_) => "uchar",
            Values::Labels(_) => "uint",
            Values::Scalars(_) => "float",
        };
        writeln!(out, "property {kind} {name}")?;
    }
    Ok(())
}

impl Faces {
    fn of(mesh: &MeshRef<'_>) -> Self {
        let sizes = mesh.polygon_sizes();
        let largest = sizes.keys().last().copied().unwrap_or(0);
        // Most readers know `int`; `uint` is for meshes that need it.
        let int = |most: usize| if i32::try_from(most).is_ok() { "int" } else { "uint" };
        let size_type = if largest <= usize::from(u8::MAX) { "uchar" } else { int(largest) };
        Self { count: sizes.values().sum(), size_type, corner_type: int(mesh.positions.len()) }
    }
}

impl<'a> Properties<'a> {
    fn of(attributes: &'a [Attribute<'a>]) -> Self {
        Self { colours: attributes.first().map(|attribute| Colours::of(attribute.values)), attributes }
    }

    /// The values of element `i`, and the end of its row.
    #[inline(always)]
    fn put<E: Encoding>(&self, row: &mut Vec<u8>, i: usize) {
        if let Some(colours) = &self.colours {
            colours.at(i).iter().for_each(|channel| E::uchar(row, *channel));
        }
        for attribute in self.attributes {
            match attribute.values {
                Values::Flags(flags) => E::uchar(row, u8::from(flags[i])),
                Values::Labels(labels) => E::uint(row, labels[i]),
                Values::Scalars(scalars) => E::float(row, scalars[i]),
            }
        }
        E::end(row);
    }
}

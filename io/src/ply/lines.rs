//! Polylines as PLY: vertices with the value and the colour of their line, and edges.

use std::io::{self, Write};

use super::encoding::{Binary, Encoding};
use crate::attribute::word;
use crate::block::Block;
use crate::colour::Colours;
use crate::{Lines, Values};

/// Binary.
pub(crate) fn write(lines: &Lines, out: &mut dyn Write) -> io::Result<()> {
    write_header(lines, out)?;
    let colours = Colours::of(Values::Scalars(lines.values()));
    let mut block = Block::new(out);
    for (i, line) in lines.iter().enumerate() {
        let colour = colours.at(i);
        for point in line.points {
            point.iter().for_each(|coordinate| Binary::float(block.bytes(), *coordinate));
            block.bytes().extend_from_slice(&colour);
            Binary::float(block.bytes(), line.value);
            block.pass_on()?;
        }
    }
    for line in lines.iter() {
        for edge in line.edges() {
            edge.iter().for_each(|end| Binary::uint(block.bytes(), *end as u32));
            block.pass_on()?;
        }
    }
    block.finish()
}

fn write_header(lines: &Lines, out: &mut dyn Write) -> io::Result<()> {
    let points = lines.positions().len();
    writeln!(out, "ply\nformat {} 1.0\nelement vertex {points}", Binary::NAME)?;
    out.write_all(b"property float x\nproperty float y\nproperty float z\n")?;
    out.write_all(b"property uchar red\nproperty uchar green\nproperty uchar blue\n")?;
    let name = match word(lines.value_name()) {
        taken if ["x", "y", "z", "red", "green", "blue"].contains(&taken.as_str()) => taken + "_2",
        free => free,
    };
    let edges: usize = lines.iter().map(|line| line.edges().count()).sum();
    // Most readers know `int`; `uint` is for files that need it.
    let end = if i32::try_from(points).is_ok() { "int" } else { "uint" };
    writeln!(out, "property float {name}\nelement edge {edges}")?;
    writeln!(out, "property {end} vertex1\nproperty {end} vertex2\nend_header")
}

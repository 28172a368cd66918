//! Vertices and polygons as OFF.

use std::io::{self, Write};

use crate::MeshRef;
use crate::block::Block;
use crate::decimal::{f32_into, u64_into};

/// Attributes are left out.
pub(crate) fn write(mesh: &MeshRef<'_>, out: &mut dyn Write) -> io::Result<()> {
    let polygons: usize = mesh.polygon_sizes().values().sum();
    // The number of edges is not known, and no reader goes by it.
    writeln!(out, "OFF\n{} {polygons} 0", mesh.positions.len())?;
    let mut block = Block::new(out);
    for [x, y, z] in mesh.positions {
        f32_into(block.bytes(), *x);
        for coordinate in [y, z] {
            block.bytes().push(b' ');
            f32_into(block.bytes(), *coordinate);
        }
        block.bytes().push(b'\n');
        block.pass_on()?;
    }
    mesh.each_polygon(|corners, _| {
        u64_into(block.bytes(), corners.len() as u64);
        for corner in corners {
            block.bytes().push(b' ');
            u64_into(block.bytes(), u64::from(*corner));
            block.pass_on()?;
        }
        block.bytes().push(b'\n');
        block.pass_on()
    })?;
    block.finish()
}

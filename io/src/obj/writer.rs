//! Vertices and faces as OBJ lines.

use std::io::{self, Write};

use crate::MeshRef;
use crate::decimal::{f32_into, u64_into};

/// Corners that are put together before they are written.
const CORNERS: usize = 1024;

/// Attributes are left out: OBJ has no place for them.
pub(crate) fn write(mesh: &MeshRef<'_>, out: &mut dyn Write) -> io::Result<()> {
    write_positions(mesh.positions, out)?;
    let mut text = Vec::new();
    mesh.each_polygon(|corners, _| {
        text.clear();
        text.push(b'f');
        for corners in corners.chunks(CORNERS) {
            for corner in corners {
                text.push(b' ');
                u64_into(&mut text, u64::from(*corner) + 1);
            }
            out.write_all(&text)?;
            text.clear();
        }
        out.write_all(b"\n")
    })
}

/// A line `v x y z` for each.
pub(super) fn write_positions(positions: &[[f32; 3]], out: &mut dyn Write) -> io::Result<()> {
    let mut text = Vec::new();
    for position in positions {
        text.clear();
        text.push(b'v');
        for coordinate in position {
            text.push(b' ');
            f32_into(&mut text, *coordinate);
        }
        text.push(b'\n');
        out.write_all(&text)?;
    }
    Ok(())
}

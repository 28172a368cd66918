//! Vertices and polygons as OFF.

use std::io::{self, Write};

use crate::MeshRef;

/// Attributes are left out.
pub(crate) fn write(mesh: &MeshRef<'_>, out: &mut dyn Write) -> io::Result<()> {
    // The number of edges is not known, and no reader goes by it.
    writeln!(out, "OFF\n{} {} 0", mesh.positions.len(), mesh.polygon_count())?;
    for [x, y, z] in mesh.positions {
        // As short as it can be for the same bits to be read: `0.1`, `1e-12`.
        writeln!(out, "{x:?} {y:?} {z:?}")?;
    }
    mesh.each_polygon(|corners, _| {
        write!(out, "{}", corners.len())?;
        corners.iter().try_for_each(|corner| write!(out, " {corner}"))?;
        out.write_all(b"\n")
    })
}

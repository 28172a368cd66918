//! Vertices and faces as OBJ lines.

use std::io::{self, Write};

use crate::MeshRef;

/// Attributes are left out: OBJ has no place for them.
pub(crate) fn write(mesh: &MeshRef<'_>, out: &mut dyn Write) -> io::Result<()> {
    for [x, y, z] in mesh.positions {
        // As short as it can be for the same bits to be read: `0.1`, `1e-12`.
        writeln!(out, "v {x:?} {y:?} {z:?}")?;
    }
    mesh.each_polygon(|corners, _| {
        out.write_all(b"f")?;
        corners.iter().try_for_each(|corner| write!(out, " {}", u64::from(*corner) + 1))?;
        out.write_all(b"\n")
    })
}

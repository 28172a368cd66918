//! Triangles as binary STL.

use std::io::{self, Write};

use super::RECORD;
use crate::MeshRef;

/// Readers that go by the first word take a file for ASCII if it is `solid`.
const HEADER: &[u8; 80] = b"binary STL written by onering                                                   ";

/// Attributes and vertices that no face names are left out: STL has no place for them.
pub(crate) fn write(mesh: &MeshRef<'_>, out: &mut dyn Write) -> io::Result<()> {
    let too_many = |_| io::Error::new(io::ErrorKind::InvalidInput, "STL has at most 2^32 - 1 triangles");
    let count = u32::try_from(mesh.faces.len()).map_err(too_many)?;
    out.write_all(HEADER)?;
    out.write_all(&count.to_le_bytes())?;
    for face in mesh.faces {
        let corners = face.map(|v| mesh.positions[v as usize]);
        out.write_all(&record(normal(corners), corners))?;
    }
    Ok(())
}

fn record(normal: [f32; 3], [a, b, c]: [[f32; 3]; 3]) -> [u8; RECORD] {
    let mut record = [0; RECORD];
    let numbers = [normal, a, b, c];
    for (bytes, number) in record.as_chunks_mut().0.iter_mut().zip(numbers.as_flattened()) {
        *bytes = number.to_le_bytes();
    }
    record
}

/// Unit normal of a triangle that is seen counter-clockwise; zero where it has none. In `f64`, which the differences
/// and products of `f32` neither overflow nor vanish in.
fn normal([a, b, c]: [[f32; 3]; 3]) -> [f32; 3] {
    let side = |end: [f32; 3]| -> [f64; 3] { std::array::from_fn(|i| f64::from(end[i]) - f64::from(a[i])) };
    let ([ux, uy, uz], [vx, vy, vz]) = (side(b), side(c));
    let cross = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    let length = cross.iter().map(|x| x * x).sum::<f64>().sqrt();
    if length > 0.0 && length.is_finite() { cross.map(|x| (x / length) as f32) } else { [0.0; 3] }
}

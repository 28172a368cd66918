//! The arrays that every library gets, and the file in which they go from process to process.

use std::error::Error;
use std::fs::{self, File};
use std::io::{BufWriter, Write};
use std::path::Path;

/// Positions and faces of a mesh, how many edges it has, so that whoever can may reserve them exactly, and the vertices
/// whose 4-rings are asked for.
#[derive(Debug, PartialEq)]
pub(crate) struct Mesh {
    pub(crate) positions: Vec<[f32; 3]>,
    pub(crate) faces: Vec<[u32; 3]>,
    pub(crate) queries: Vec<u32>,
    pub(crate) edge_count: usize,
}

/// One neighbour in a sum that does not depend on the order. The C++ programs do the same.
#[inline(always)]
pub(crate) fn mixed(v: u32, u: u32) -> u64 {
    u64::from(v).wrapping_mul(0x9E37_79B9_7F4A_7C15) ^ u64::from(u)
}

impl Mesh {
    /// Numbers of vertices, faces, edges and queries as `u64`, then positions, faces and queries, all little-endian.
    pub(crate) fn write(&self, path: &Path) -> std::io::Result<()> {
        let mut out = BufWriter::new(File::create(path)?);
        for count in [self.positions.len(), self.faces.len(), self.edge_count, self.queries.len()] {
            out.write_all(&(count as u64).to_le_bytes())?;
        }
        out.write_all(bytemuck::cast_slice(&self.positions))?;
        out.write_all(bytemuck::cast_slice(&self.faces))?;
        out.write_all(bytemuck::cast_slice(&self.queries))?;
        out.flush()
    }

    pub(crate) fn read(path: &Path) -> Result<Self, Box<dyn Error>> {
        let bytes = fs::read(path)?;
        let (counts, arrays) = bytes.split_at_checked(32).ok_or("the file ends within its counts")?;
        let count = |i: usize| u64::from_le_bytes(counts[i * 8..][..8].try_into().expect("8 bytes")) as usize;
        let (positions, arrays) = split(arrays, count(0), 12)?;
        let (faces, arrays) = split(arrays, count(1), 12)?;
        let (queries, rest) = split(arrays, count(3), 4)?;
        if !rest.is_empty() {
            return Err("the file goes on behind its queries".into());
        }
        Ok(Self {
            positions: bytemuck::pod_collect_to_vec(positions),
            faces: bytemuck::pod_collect_to_vec(faces),
            queries: bytemuck::pod_collect_to_vec(queries),
            edge_count: count(2),
        })
    }
}

/// So many elements of so many bytes, and the rest.
fn split(bytes: &[u8], count: usize, size: usize) -> Result<(&[u8], &[u8]), &'static str> {
    let taken = count.checked_mul(size).and_then(|length| bytes.split_at_checked(length));
    taken.ok_or("the file ends within its arrays")
}
